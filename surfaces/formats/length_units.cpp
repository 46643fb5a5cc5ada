#include "surfaces/formats/length_units.hpp"

#include "base/plain_text.hpp"
#include "input/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace asperity::surfaces {
namespace {

/// Returns the number at the beginning of a text and what follows it; NaN if
/// there is none.
std::pair<double, std::string_view> leading_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.remove_prefix(1);
  return number_and_rest(text);
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

std::string known_length_units() {
  return fmt::format(
      "{}", fmt::join(input::usual_units(input::Dimension::length), ", "));
}

std::optional<double> length_unit(std::string_view unit) {
  return input::unit_in_si(unit, input::Dimension::length);
}

std::optional<double> length_of_text(std::string_view text) {
  const std::string pointed = with_decimal_point(text);
  const auto [number, unit] = leading_number(pointed);
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
