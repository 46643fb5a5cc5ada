#include "cases/types/units.hpp"

#include "base/physical_constants.hpp"
#include "base/plain_text.hpp"
#include "input/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace asperity::cases {
namespace {

const Unit* unit_called(const std::string& symbol) {
  const auto found =
      std::find_if(units().begin(), units().end(),
                   [&](const Unit& unit) { return unit.symbol == symbol; });
  return found == units().end() ? nullptr : &*found;
}

QuantityReading refused(const std::string& mistake) {
  return {std::nullopt, mistake};
}

std::string wrong_unit(const std::string& symbol,
                       const std::vector<std::string>& allowed) {
  const std::string choice = fmt::format("{}", fmt::join(allowed, ", "));
  if (const Unit* unit = unit_called(symbol))
    return fmt::format("has the unit {} of a {}, but must have one of: {}",
                       symbol, dimension_name(unit->dimension), choice);
  return fmt::format("has the unknown unit \"{}\"; allowed: {}; nearest: {}",
                     symbol, choice, input::nearest(symbol, allowed));
}

} // namespace

const std::vector<Unit>& units() {
  using enum Dimension;
  static const std::vector<Unit> table = {
      {"m", length},
      {"mm", length, 1.0, 1e3},
      {"um", length, 1.0, 1e6},
      {"\u00b5m", length, 1.0, 1e6, mechanics::ReferenceUnit::si,
       true}, // micro sign
      {"\u03bcm", length, 1.0, 1e6, mechanics::ReferenceUnit::si,
       true}, // Greek mu
      {"nm", length, 1.0, 1e9},
      {"angstrom", length, 1.0, 1e10},
      {"Pa", pressure},
      {"kPa", pressure, 1e3},
      {"MPa", pressure, 1e6},
      {"GPa", pressure, 1e9},
      {"N", force},
      {"J/m^2", energy_per_area},
      {"mJ/m^2", energy_per_area, 1.0, 1e3},
      {"J", energy},
      {"eV", energy, electronvolt},
      {"meV", energy, electronvolt, 1e3},
      {"kg", mass},
      {"u", mass, atomic_mass_unit},
      {"s", time},
      {"ps", time, 1.0, 1e12},
      {"fs", time, 1.0, 1e15},
      {"1/s", rate},
      {"1/ps", rate, 1e12},
      {"K", temperature},
      {"kg/m^3", density},
      {"Pa s", viscosity},
      {"mPa s", viscosity, 1.0, 1e3},
      {"W/(m K)", thermal_conductivity},
      {"Ohm m", resistivity},
      {"nOhm m", resistivity, 1.0, 1e9},
      {"1/m", wavevector},
      {"Pa/m", stiffness},
      {"E*", pressure, 1.0, 1.0, mechanics::ReferenceUnit::contact_modulus},
      {"E* h'", pressure, 1.0, 1.0,
       mechanics::ReferenceUnit::contact_modulus_times_slope},
      {"length", length, 1.0, 1.0, mechanics::ReferenceUnit::length},
      {"h", length, 1.0, 1.0, mechanics::ReferenceUnit::spacing},
      {"h_rms", length, 1.0, 1.0, mechanics::ReferenceUnit::rms_height},
      {"E*/h", stiffness, 1.0, 1.0,
       mechanics::ReferenceUnit::contact_modulus_per_spacing},
  };
  return table;
}

std::string dimension_name(Dimension dimension) {
  switch (dimension) {
  case Dimension::none:
    return "number";
  case Dimension::length:
    return "length";
  case Dimension::pressure:
    return "pressure";
  case Dimension::wavevector:
    return "wavevector";
  case Dimension::stiffness:
    return "stiffness per area";
  case Dimension::force:
    return "force";
  case Dimension::energy_per_area:
    return "energy per area";
  case Dimension::energy:
    return "energy";
  case Dimension::mass:
    return "mass";
  case Dimension::time:
    return "time";
  case Dimension::rate:
    return "rate";
  case Dimension::temperature:
    return "temperature";
  case Dimension::density:
    return "density";
  case Dimension::viscosity:
    return "viscosity";
  case Dimension::thermal_conductivity:
    return "thermal conductivity";
  case Dimension::resistivity:
    return "resistivity";
  }
  return "";
}

std::string si_unit(Dimension dimension) {
  const auto found =
      std::find_if(units().begin(), units().end(), [&](const Unit& unit) {
        return unit.dimension == dimension;
      });
  return found == units().end() ? "1" : found->symbol;
}

std::string reference_symbol(mechanics::ReferenceUnit reference) {
  for (const Unit& unit : units())
    if (unit.reference == reference &&
        reference != mechanics::ReferenceUnit::si)
      return unit.symbol;
  return "";
}

bool is_allowed(const Unit& unit, Dimension dimension,
                const std::vector<mechanics::ReferenceUnit>& references) {
  return unit.dimension == dimension &&
         (unit.reference == mechanics::ReferenceUnit::si ||
          std::find(references.begin(), references.end(), unit.reference) !=
              references.end());
}

std::vector<std::string>
unit_symbols(Dimension dimension,
             const std::vector<mechanics::ReferenceUnit>& references) {
  std::vector<std::string> symbols;
  for (const Unit& unit : units())
    if (is_allowed(unit, dimension, references) && !unit.is_alias)
      symbols.push_back(unit.symbol);
  return symbols;
}

QuantityReading
read_quantity(const std::string& text, Dimension dimension,
              const std::vector<mechanics::ReferenceUnit>& references) {
  const std::string written = trimmed(text);
  const char* const end = written.data() + written.size();
  double number = 0.0;
  const auto [rest, error] = std::from_chars(written.data(), end, number);
  if (error == std::errc::result_out_of_range)
    return refused("is out of the range of numbers");
  const std::vector<std::string> allowed = unit_symbols(dimension, references);
  if (error != std::errc{} || !std::isfinite(number))
    return refused(std::ranges::find(allowed, written) == allowed.end()
                       ? "does not begin with a number"
                       : "is a unit without a number; write \"1 " + written +
                             "\"");

  const std::string symbol = trimmed(std::string(rest, end));
  if (dimension == Dimension::none)
    return refused("must be a plain number, without quotes");
  if (symbol.empty())
    return refused(fmt::format("has no unit; allowed: {} (a number without "
                               "quotes is in {})",
                               fmt::join(allowed, ", "), si_unit(dimension)));
  const Unit* const unit = unit_called(symbol);
  if (!unit || !is_allowed(*unit, dimension, references))
    return refused(wrong_unit(symbol, allowed));

  const double value = number * unit->multiplier / unit->divisor;
  if (!std::isfinite(value))
    return refused("is out of the range of numbers");
  return {mechanics::Quantity{value, unit->reference}, ""};
}

std::string write_quantity(const mechanics::Quantity& quantity,
                           Dimension dimension) {
  const std::string symbol = quantity.reference == mechanics::ReferenceUnit::si
                                 ? si_unit(dimension)
                                 : reference_symbol(quantity.reference);
  return fmt::format("{} {}", quantity.value, symbol);
}

} // namespace asperity::cases
