#include "input/types/quantity_at_load.hpp"

#include "base/plain_text.hpp"
#include "input/nearest.hpp"
#include "input/types/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

QuantityAtLoadReading refused_at_load(const std::string& mistake) {
  return {std::nullopt, mistake};
}

/// Returns the text after "@key =" in the given range of `name`, if the key
/// matches.
std::optional<std::string> value_of(const std::string& key,
                                    const std::string& name, std::size_t at,
                                    std::size_t end) {
  if (at == std::string::npos)
    return std::nullopt;
  const std::string clause = name.substr(at + 1, end - at - 1);
  const auto equals = clause.find('=');
  if (equals == std::string::npos || trimmed(clause.substr(0, equals)) != key)
    return std::nullopt;
  return clause.substr(equals + 1);
}

std::optional<double> positive_number(const std::optional<std::string>& text) {
  const std::string digits = trimmed(text.value_or(""));
  const auto [number, rest] = number_and_rest(digits);
  return rest.empty() && std::isfinite(number) && number > 0.0
             ? std::optional(number)
             : std::nullopt;
}

/// Returns the mistake in a name that should be one of `known`; "" if it is
/// correct.
std::string mistake_in_name(const std::string& quantity,
                            const std::vector<ExpectationName>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const ExpectationName& entry : known)
    names.push_back(entry.name);
  if (std::find(names.begin(), names.end(), quantity) != names.end())
    return "";
  return fmt::format(
      "asks for {} at a load, which is not a known quantity; nearest: {}",
      quantity, input::nearest(quantity, names));
}

} // namespace

bool names_a_load(const std::string& name) {
  return name.find('@') != std::string::npos;
}

QuantityAtLoadReading read_quantity_at_load(const std::string& name) {
  const std::string quantity = trimmed(name.substr(0, name.find('@')));
  const auto at = name.find('@');
  const auto second_at = at == std::string::npos ? at : name.find('@', at + 1);
  const std::optional<std::string> load = value_of("p", name, at, second_at);
  if (!load)
    return refused_at_load("must have the form area_fraction@p=0.01 E*");
  const bool has_magnification = second_at != std::string::npos;
  const std::string mistake = mistake_in_name(
      quantity, expectation_names(has_magnification ? QuantityOf::magnification
                                                    : QuantityOf::load));
  if (!mistake.empty())
    return refused_at_load(mistake);
  const QuantityReading pressure = read_quantity(
      *load, Dimension::pressure, {mechanics::ReferenceUnit::contact_modulus});
  if (!pressure.quantity)
    return refused_at_load("has a p that " + pressure.mistake);
  if (!(pressure.quantity->value > 0.0))
    return refused_at_load("has a p that is not > 0");
  QuantityAtLoad read{quantity, *pressure.quantity};
  if (has_magnification) {
    read.magnification =
        positive_number(value_of("zeta", name, second_at, std::string::npos));
    if (!read.magnification)
      return refused_at_load(
          "must have the form area_fraction@p=0.01 E*@zeta=10 with zeta > 0");
  }
  return {read, ""};
}

} // namespace asperity::cases
