#include "surfaces/formats/length_units.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

namespace asperity::surfaces {
namespace {

/// Returns the number at the beginning of a text and what follows it; NaN if
/// there is none.
std::pair<double, std::string_view> leading_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.remove_prefix(1);
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{})
    return {std::nan(""), text};
  return {number, text.substr(static_cast<std::size_t>(stop - text.data()))};
}

/// Replaces the only comma of a text by a dot.
std::string with_decimal_point(std::string_view text) {
  std::string copy(text);
  if (std::count(copy.begin(), copy.end(), ',') == 1 &&
      copy.find('.') == std::string::npos)
    copy[copy.find(',')] = '.';
  return copy;
}

} // namespace

std::optional<double> length_unit(std::string_view unit) {
  static constexpr std::pair<std::string_view, double> units[] = {
      {"m", 1.0},
      {"km", 1e3},
      {"cm", 1e-2},
      {"mm", 1e-3},
      {"um", 1e-6},
      {"\xC2\xB5m", 1e-6}, // micro sign, UTF-8
      {"\xCE\xBCm", 1e-6}, // Greek mu, UTF-8
      {"\xB5m", 1e-6},     // micro sign, Latin-1
      {"~m", 1e-6},        // written by instruments without a micro sign
      {"nm", 1e-9},
      {"pm", 1e-12},
      {"fm", 1e-15},
      {"angstrom", 1e-10},
      {"\xC3\x85", 1e-10},     // A with ring, UTF-8
      {"\xE2\x84\xAB", 1e-10}, // Angstrom sign, UTF-8
      {"\xC5", 1e-10},         // A with ring, Latin-1
  };
  for (const auto& [name, metres] : units)
    if (unit == name)
      return metres;
  return std::nullopt;
}

std::optional<double> length_of_text(std::string_view text) {
  const std::string pointed = with_decimal_point(text);
  auto [number, unit] = leading_number(pointed);
  // A no-break space, in UTF-8 or Latin-1, separates the unit in some
  // languages.
  for (const std::string_view blank : {" ", "\xC2\xA0", "\xA0"})
    while (unit.starts_with(blank))
      unit.remove_prefix(blank.size());
  const std::optional<double> metres = length_unit(unit);
  if (!metres || !std::isfinite(number))
    return std::nullopt;
  return number * *metres;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z')
      letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

double number_of_text(std::string_view word) {
  if (word.find(',') != std::string_view::npos) {
    const std::string pointed = with_decimal_point(word);
    const auto [number, rest] = leading_number(pointed);
    return rest.empty() ? number : std::nan("");
  }
  const auto [number, rest] = leading_number(word);
  return rest.empty() ? number : std::nan("");
}

} // namespace asperity::surfaces
