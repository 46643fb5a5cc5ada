#include "input/units.hpp"

#include "base/physical_constants.hpp"
#include "base/plain_text.hpp"
#include "input/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace asperity::input {
namespace {

constexpr bool usual = true;
constexpr double inch = 254.0;         // [0.1 mm]
constexpr double square_inch = 6.4516; // [cm^2]
constexpr double pound_force = pound * standard_gravity;
constexpr double torr = standard_atmosphere / 760.0;

std::vector<Unit> lengths_and_areas() {
  using enum Dimension;
  return {
      {"m", length, 0, 1.0, usual},
      {"mm", length, -3, 1.0, usual},
      {"um", length, -6, 1.0, usual},
      {"nm", length, -9, 1.0, usual},
      {"angstrom", length, -10, 1.0, usual},
      {"Angstrom", length, -10},
      {"km", length, 3},
      {"cm", length, -2},
      {"micron", length, -6},
      {"microns", length, -6},
      {"pm", length, -12},
      {"fm", length, -15},
      {"in", length, -4, inch},
      {"inch", length, -4, inch},
      {"inches", length, -4, inch},
      {"mil", length, -7, inch},
      {"uin", length, -10, inch},
      {"m^2", area, 0, 1.0, usual},
      {"mm^2", area, -6, 1.0, usual},
      {"um^2", area, -12, 1.0, usual},
      {"nm^2", area, -18, 1.0, usual},
      {"cm^2", area, -4},
      {"angstrom^2", area, -20},
      {"in^2", area, -4, square_inch},
      {"1/m", wavevector, 0, 1.0, usual},
      {"1/mm", wavevector, 3},
      {"1/um", wavevector, 6},
      {"1/nm", wavevector, 9},
      {"rad/m", wavevector, 0},
      {"rad/mm", wavevector, 3},
      {"rad/um", wavevector, 6},
      {"rad/nm", wavevector, 9},
  };
}

/// A pressure in mPa is left out: MPa is meant where it is written.
std::vector<Unit> pressures() {
  using enum Dimension;
  return {
      {"Pa", pressure, 0, 1.0, usual},
      {"kPa", pressure, 3, 1.0, usual},
      {"MPa", pressure, 6, 1.0, usual},
      {"GPa", pressure, 9, 1.0, usual},
      {"TPa", pressure, 12},
      {"hPa", pressure, 2},
      {"N/m^2", pressure, 0},
      {"kN/m^2", pressure, 3},
      {"MN/m^2", pressure, 6},
      {"GN/m^2", pressure, 9},
      {"N/cm^2", pressure, 4},
      {"N/mm^2", pressure, 6},
      {"kN/mm^2", pressure, 9},
      {"N/um^2", pressure, 12},
      {"mN/um^2", pressure, 9},
      {"uN/um^2", pressure, 6},
      {"nN/um^2", pressure, 3},
      {"nN/nm^2", pressure, 9},
      {"bar", pressure, 5},
      {"mbar", pressure, 2},
      {"kbar", pressure, 8},
      {"atm", pressure, 0, standard_atmosphere},
      {"Torr", pressure, 0, torr},
      {"torr", pressure, 0, torr},
      {"mTorr", pressure, -3, torr},
      {"mmHg", pressure, 0, millimetre_of_mercury},
      {"psi", pressure, 4, pound_force / square_inch},
      {"ksi", pressure, 7, pound_force / square_inch},
      {"Mpsi", pressure, 10, pound_force / square_inch},
      {"kgf/mm^2", pressure, 6, standard_gravity},
      {"kgf/cm^2", pressure, 4, standard_gravity},
      {"dyn/cm^2", pressure, -1},
      {"eV/angstrom^3", pressure, 30, electronvolt},
      {"Pa/m", stiffness, 0, 1.0, usual},
      {"MPa/m", stiffness, 6},
      {"GPa/m", stiffness, 9},
      {"MPa/mm", stiffness, 9},
      {"GPa/mm", stiffness, 12},
      {"MPa/um", stiffness, 12},
      {"GPa/um", stiffness, 15},
      {"MPa/nm", stiffness, 15},
      {"GPa/nm", stiffness, 18},
      {"N/m^3", stiffness, 0},
      {"N/mm^3", stiffness, 9},
  };
}

std::vector<Unit> forces_and_energies() {
  using enum Dimension;
  return {
      {"N", force, 0, 1.0, usual},
      {"MN", force, 6},
      {"kN", force, 3},
      {"mN", force, -3},
      {"uN", force, -6},
      {"nN", force, -9},
      {"pN", force, -12},
      {"kgf", force, 0, standard_gravity},
      {"lbf", force, 0, pound_force},
      {"dyn", force, -5},
      {"J/m^2", energy_per_area, 0, 1.0, usual},
      {"mJ/m^2", energy_per_area, -3, 1.0, usual},
      {"uJ/m^2", energy_per_area, -6},
      {"N/m", energy_per_area, 0},
      {"mN/m", energy_per_area, -3},
      {"dyn/cm", energy_per_area, -3},
      {"erg/cm^2", energy_per_area, -3},
      {"eV/nm^2", energy_per_area, 18, electronvolt},
      {"eV/angstrom^2", energy_per_area, 20, electronvolt},
      {"J", energy, 0, 1.0, usual},
      {"eV", energy, 0, electronvolt, usual},
      {"meV", energy, -3, electronvolt, usual},
      {"keV", energy, 3, electronvolt},
      {"mJ", energy, -3},
      {"uJ", energy, -6},
      {"nJ", energy, -9},
      {"pJ", energy, -12},
      {"fJ", energy, -15},
      {"aJ", energy, -18},
      {"erg", energy, -7},
  };
}

std::vector<Unit> other_units() {
  using enum Dimension;
  return {
      {"1", none, 0, 1.0, usual},
      {"%", none, -2, 1.0, usual},
      {"-", none, 0},
      {"kg", mass, 0, 1.0, usual},
      {"u", mass, 0, atomic_mass_unit, usual},
      {"g", mass, -3},
      {"mg", mass, -6},
      {"s", time, 0, 1.0, usual},
      {"ps", time, -12, 1.0, usual},
      {"fs", time, -15, 1.0, usual},
      {"ms", time, -3},
      {"us", time, -6},
      {"ns", time, -9},
      {"1/s", rate, 0, 1.0, usual},
      {"1/ps", rate, 12, 1.0, usual},
      {"1/fs", rate, 15},
      {"1/ns", rate, 9},
      {"1/us", rate, 6},
      {"1/ms", rate, 3},
      {"K", temperature, 0, 1.0, usual},
      {"mK", temperature, -3},
      {"kg/m^3", density, 0, 1.0, usual},
      {"g/cm^3", density, 3},
      {"Pa s", viscosity, 0, 1.0, usual},
      {"mPa s", viscosity, -3, 1.0, usual},
      {"uPa s", viscosity, -6},
      {"P", viscosity, -1},
      {"cP", viscosity, -3},
      {"W/(m K)", thermal_conductivity, 0, 1.0, usual},
      {"mW/(m K)", thermal_conductivity, -3},
      {"W/(cm K)", thermal_conductivity, 2},
      {"W/m/K", thermal_conductivity, 0},
      {"Ohm m", resistivity, 0, 1.0, usual},
      {"nOhm m", resistivity, -9, 1.0, usual},
      {"uOhm m", resistivity, -6},
      {"uOhm cm", resistivity, -8},
      {"Ohm cm", resistivity, -2},
  };
}

using Spelling = std::pair<std::string_view, std::string_view>;

/// What the table has for other spellings, in UTF-8. Some instruments write '~'
/// for the sign of micro.
constexpr Spelling spellings[] = {
    {"\xC2\xB5", "u"},            // micro sign
    {"\xCE\xBC", "u"},            // Greek mu
    {"\xC3\x85", "angstrom"},     // A with ring
    {"\xE2\x84\xAB", "angstrom"}, // angstrom sign
    {"\xCE\xA9", "Ohm"},          // Greek omega
    {"\xE2\x84\xA6", "Ohm"},      // ohm sign
    {"\xC2\xB2", "^2"},           // superscripts
    {"\xC2\xB3", "^3"},
    {"\xC2\xB7", " "},     // dot of a product
    {"\xE2\x8B\x85", " "}, // operator of a product
    {"\xC2\xA0", " "},     // no-break space
    {"\xE2\x80\xAF", " "}, // narrow no-break space
    {"\xE2\x80\x89", " "}, // thin space
    {"**", "^"},
    {"~", "u"}};

/// The same in Latin-1, as which a text that is not UTF-8 is read.
constexpr Spelling latin_spellings[] = {
    {"\xB5", "u"}, {"\xC5", "angstrom"}, {"\xB2", "^2"}, {"\xB3", "^3"},
    {"\xB7", " "}, {"\xA0", " "},        {"**", "^"},    {"~", "u"}};

bool is_letter(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0;
}

std::string respelled(std::string_view text,
                      std::span<const Spelling> letters) {
  std::string plain;
  while (!text.empty()) {
    const auto found =
        std::ranges::find_if(letters, [&](const Spelling& letter) {
          return text.starts_with(letter.first);
        });
    const bool is_other = found != letters.end();
    plain += is_other ? found->second : text.substr(0, 1);
    text.remove_prefix(is_other ? found->first.size() : 1);
  }
  return plain;
}

/// A name of a unit as the table writes it.
std::string as_in_table(std::string_view name) {
  const bool is_utf8 = find_not_plain(name) == std::string_view::npos;
  const std::string plain =
      is_utf8 ? respelled(name, spellings) : respelled(name, latin_spellings);
  std::string symbol;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const bool is_behind_letter = i > 0 && is_letter(plain[i - 1]);
    const bool is_before_letter =
        i + 1 < plain.size() && is_letter(plain[i + 1]);
    const bool is_digit = plain[i] == '2' || plain[i] == '3';
    if (is_behind_letter && is_digit)
      symbol += '^';
    const bool is_product = (plain[i] == '*' || plain[i] == '.') &&
                            is_behind_letter && is_before_letter;
    symbol += is_product ? ' ' : plain[i];
  }
  return trimmed(symbol);
}

} // namespace

double Unit::in_si(double number) const {
  const double power = std::pow(10.0, std::abs(decade));
  const double scaled = number * factor;
  return decade < 0 ? scaled / power : scaled * power;
}

const std::vector<Unit>& units() {
  static const std::vector<Unit> table = [] {
    std::vector<Unit> all;
    for (const std::vector<Unit>& some : {lengths_and_areas(), pressures(),
                                          forces_and_energies(), other_units()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return table;
}

const Unit* unit_called(std::string_view name) {
  const std::string symbol = as_in_table(name);
  const auto found = std::ranges::find(units(), symbol, &Unit::symbol);
  return found == units().end() ? nullptr : &*found;
}

std::optional<double> unit_in_si(std::string_view name, Dimension dimension) {
  const Unit* const unit = unit_called(name);
  return unit != nullptr && unit->dimension == dimension
             ? std::optional(unit->in_si(1.0))
             : std::nullopt;
}

std::string dimension_name(Dimension dimension) {
  static constexpr std::array names{"number",      "length",
                                    "area",        "pressure",
                                    "wavevector",  "stiffness per area",
                                    "force",       "energy per area",
                                    "energy",      "mass",
                                    "time",        "rate",
                                    "temperature", "density",
                                    "viscosity",   "thermal conductivity",
                                    "resistivity"};
  return names.at(static_cast<std::size_t>(dimension));
}

std::string with_article(Dimension dimension) {
  const std::string name = dimension_name(dimension);
  return (name.front() == 'a' || name.front() == 'e' ? "an " : "a ") + name;
}

std::string si_unit(Dimension dimension) {
  return std::string(
      std::ranges::find(units(), dimension, &Unit::dimension)->symbol);
}

std::vector<std::string> usual_units(Dimension dimension) {
  std::vector<std::string> symbols;
  for (const Unit& unit : units())
    if (unit.dimension == dimension && unit.is_usual)
      symbols.emplace_back(unit.symbol);
  return symbols;
}

std::string nearest_unit(const std::string& name, Dimension dimension,
                         std::vector<std::string> symbols) {
  for (const Unit& unit : units())
    if (unit.dimension == dimension)
      symbols.emplace_back(unit.symbol);
  return nearest(as_in_table(name), symbols);
}

NumberWithUnit split_number(const std::string& text, Dimension dimension) {
  const std::string written = trimmed(text);
  const char* const end = written.data() + written.size();
  NumberWithUnit read;
  const auto [rest, error] = std::from_chars(written.data(), end, read.number);
  read.unit = trimmed(std::string(rest, end));
  if (error == std::errc::result_out_of_range)
    read.mistake = "is out of the range of numbers";
  else if (error != std::errc{} || !std::isfinite(read.number))
    read.mistake = unit_in_si(written, dimension)
                       ? "is a unit without a number; write \"1 " +
                             printable(written) + '"'
                       : "does not begin with a number";
  else if (read.unit.starts_with(','))
    read.mistake = "has a comma in its number; write a decimal point";
  return read;
}

std::string unit_mistake(const std::string& unit, Dimension dimension,
                         const std::vector<std::string>& allowed) {
  const std::string choice = fmt::format("{}", fmt::join(allowed, ", "));
  if (const Unit* const known = unit_called(unit))
    return fmt::format("has the unit {} of {}, but must have one of: {}",
                       known->symbol, with_article(known->dimension), choice);
  return fmt::format("has the unknown unit \"{}\"; allowed: {}; nearest: {}",
                     printable(unit), choice,
                     nearest_unit(unit, dimension, allowed));
}

ValueReading read_with_unit(const std::string& text, Dimension dimension) {
  const NumberWithUnit read = split_number(text, dimension);
  if (!read.mistake.empty())
    return {std::nullopt, read.mistake};
  const std::vector<std::string> allowed = usual_units(dimension);
  if (read.unit.empty()) {
    std::vector<std::string> forms;
    forms.reserve(allowed.size());
    for (const std::string& unit : allowed)
      forms.push_back(fmt::format("\"{} {}\"", trimmed(text), unit));
    return {std::nullopt,
            fmt::format("has no unit; write {}", fmt::join(forms, " or "))};
  }
  const Unit* const unit = unit_called(read.unit);
  if (unit == nullptr || unit->dimension != dimension)
    return {std::nullopt, unit_mistake(read.unit, dimension, allowed)};
  const double value = unit->in_si(read.number);
  if (!std::isfinite(value))
    return {std::nullopt, "is out of the range of numbers"};
  return {value, ""};
}

} // namespace asperity::input
