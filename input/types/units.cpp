#include "input/types/units.hpp"

#include "base/plain_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

using mechanics::ReferenceUnit;

/// A unit of the problem.
struct OwnUnit {
  const char* symbol;
  Dimension dimension;
  ReferenceUnit reference;
};

constexpr OwnUnit own_units[] = {
    {"E*", Dimension::pressure, ReferenceUnit::contact_modulus},
    {"E* h'", Dimension::pressure, ReferenceUnit::contact_modulus_times_slope},
    {"length", Dimension::length, ReferenceUnit::length},
    {"h", Dimension::length, ReferenceUnit::spacing},
    {"h_rms", Dimension::length, ReferenceUnit::rms_height},
    {"E*/h", Dimension::stiffness, ReferenceUnit::contact_modulus_per_spacing}};

const OwnUnit* own_unit(ReferenceUnit reference) {
  const auto* const found =
      std::ranges::find(own_units, reference, &OwnUnit::reference);
  return found == std::end(own_units) ? nullptr : found;
}

bool is_own_allowed(const OwnUnit& unit, Dimension dimension,
                    const std::vector<ReferenceUnit>& references) {
  return unit.dimension == dimension &&
         std::ranges::find(references, unit.reference) != references.end();
}

QuantityReading refused(const std::string& mistake) {
  return {std::nullopt, mistake};
}

} // namespace

std::string reference_symbol(ReferenceUnit reference) {
  const OwnUnit* const unit = own_unit(reference);
  return unit ? unit->symbol : "";
}

Dimension reference_dimension(ReferenceUnit reference) {
  const OwnUnit* const unit = own_unit(reference);
  return unit ? unit->dimension : Dimension::none;
}

std::vector<std::string>
unit_symbols(Dimension dimension,
             const std::vector<ReferenceUnit>& references) {
  std::vector<std::string> symbols;
  if (dimension != Dimension::none) // a plain number
    symbols = input::usual_units(dimension);
  for (const OwnUnit& unit : own_units)
    if (is_own_allowed(unit, dimension, references))
      symbols.emplace_back(unit.symbol);
  return symbols;
}

QuantityReading read_quantity(const std::string& text, Dimension dimension,
                              const std::vector<ReferenceUnit>& references) {
  const std::vector<std::string> allowed = unit_symbols(dimension, references);
  const input::NumberWithUnit read = input::split_number(text, dimension);
  if (!read.mistake.empty()) {
    const std::string written = trimmed(text);
    return refused(std::ranges::find(allowed, written) == allowed.end()
                       ? read.mistake
                       : "is a unit without a number; write \"1 " + written +
                             "\"");
  }
  if (dimension == Dimension::none)
    return refused("must be a plain number, without quotes");
  if (read.unit.empty())
    return refused(fmt::format("has no unit; allowed: {} (a number without "
                               "quotes is in {})",
                               fmt::join(allowed, ", "), si_unit(dimension)));
  for (const OwnUnit& unit : own_units)
    if (read.unit == unit.symbol) {
      if (is_own_allowed(unit, dimension, references))
        return {mechanics::Quantity{read.number, unit.reference}, ""};
      return refused(fmt::format(
          "has the unit {} of {}, but must have one of: {}", unit.symbol,
          input::with_article(unit.dimension), fmt::join(allowed, ", ")));
    }
  const input::Unit* const unit = input::unit_called(read.unit);
  if (!unit || unit->dimension != dimension)
    return refused(input::unit_mistake(read.unit, dimension, allowed));
  const double value = unit->in_si(read.number);
  if (!std::isfinite(value))
    return refused("is out of the range of numbers");
  return {mechanics::Quantity{value, ReferenceUnit::si}, ""};
}

std::string write_quantity(const mechanics::Quantity& quantity,
                           Dimension dimension) {
  const std::string symbol = quantity.reference == ReferenceUnit::si
                                 ? si_unit(dimension)
                                 : reference_symbol(quantity.reference);
  return fmt::format("{} {}", quantity.value, symbol);
}

} // namespace asperity::cases
