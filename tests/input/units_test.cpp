// Tests of input/units.hpp: every unit of the table has the value that follows
// from the definitions of its parts, in every spelling, and what is no unit is
// refused with the nearest one of the same dimension.
#include "input/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string>

namespace asperity::input::units_test {

/// A value in SI and the powers of kg, m, s, K and A.
struct Defined {
  double value = 1.0;
  std::array<int, 5> powers = {};
};

constexpr std::array<int, 5> newton{1, 1, -2}, pascal{1, -1, -2},
    joule{1, 2, -2}, metre{0, 1}, kilogram{1};

/// The definitions of the units from which all are made: the SI Brochure (9th
/// edition, 2019), and NIST Special Publication 811 (2008), Appendix B, for the
/// units of pressure, force and length that do not belong to SI.
const std::map<std::string, Defined> definitions{
    {"m", {1.0, metre}},
    {"g", {1e-3, kilogram}},
    {"s", {1.0, {0, 0, 1}}},
    {"K", {1.0, {0, 0, 0, 1}}},
    {"rad", {}},
    {"1", {}},
    {"-", {}},
    {"%", {0.01, {}}},
    {"N", {1.0, newton}},
    {"Pa", {1.0, pascal}},
    {"J", {1.0, joule}},
    {"W", {1.0, {1, 2, -3}}},
    {"Ohm", {1.0, {1, 2, -3, 0, -2}}},
    {"P", {0.1, {1, -1, -1}}},
    {"eV", {1.602176634e-19, joule}},
    {"u", {1.66053906660e-27, kilogram}},
    {"bar", {1e5, pascal}},
    {"atm", {101325.0, pascal}},
    {"Torr", {133.32236842105263, pascal}},
    {"torr", {133.32236842105263, pascal}},
    {"mmHg", {133.322387415, pascal}},
    {"psi", {6894.757293168361, pascal}},
    {"ksi", {6894757.293168361, pascal}},
    {"kgf", {9.80665, newton}},
    {"lbf", {4.4482216152605, newton}},
    {"dyn", {1e-5, newton}},
    {"erg", {1e-7, joule}},
    {"angstrom", {1e-10, metre}},
    {"Angstrom", {1e-10, metre}},
    {"micron", {1e-6, metre}},
    {"microns", {1e-6, metre}},
    {"in", {0.0254, metre}},
    {"inch", {0.0254, metre}},
    {"inches", {0.0254, metre}},
    {"mil", {25.4e-6, metre}},
};

const std::map<char, double> prefixes{{'T', 1e12},  {'G', 1e9},   {'M', 1e6},
                                      {'k', 1e3},   {'h', 1e2},   {'c', 1e-2},
                                      {'m', 1e-3},  {'u', 1e-6},  {'n', 1e-9},
                                      {'p', 1e-12}, {'f', 1e-15}, {'a', 1e-18}};

/// "mm^2" by its prefix, its definition and its power.
Defined defined_part(const std::string& part) {
  const std::size_t hat = part.find('^');
  const std::string name = part.substr(0, hat);
  const int power =
      hat == std::string::npos ? 1 : std::atoi(part.substr(hat + 1).c_str());
  double value = 1.0;
  auto found = definitions.find(name);
  if (found == definitions.end()) {
    value = prefixes.at(name.front());
    found = definitions.find(name.substr(1));
  }
  if (found == definitions.end()) {
    ADD_FAILURE() << "no definition of " << name;
    return {};
  }
  Defined part_value{std::pow(value * found->second.value, power),
                     found->second.powers};
  for (int& one : part_value.powers)
    one *= power;
  return part_value;
}

/// "W/(m K)" by its parts: those in brackets, and one behind a stroke, divide.
Defined defined(const std::string& symbol) {
  Defined all;
  bool divides = false, is_in_brackets = false;
  std::string part;
  const auto take = [&] {
    if (part.empty())
      return;
    const Defined one = defined_part(part);
    all.value *= divides ? 1.0 / one.value : one.value;
    for (std::size_t i = 0; i < all.powers.size(); ++i)
      all.powers.at(i) += (divides ? -1 : 1) * one.powers.at(i);
    part.clear();
  };
  for (const char letter : symbol) {
    if (letter == '/' || letter == ' ' || letter == '(' || letter == ')') {
      take();
      is_in_brackets = letter == '(' || (is_in_brackets && letter != ')');
      divides = letter == '/' || (divides && is_in_brackets);
    } else {
      part += letter;
    }
  }
  take();
  return all;
}

TEST(Units, HaveTheValuesOfTheirDefinitions) {
  const std::map<Dimension, std::array<int, 5>> powers{
      {Dimension::none, {}},
      {Dimension::length, metre},
      {Dimension::area, {0, 2}},
      {Dimension::pressure, pascal},
      {Dimension::wavevector, {0, -1}},
      {Dimension::stiffness, {1, -2, -2}},
      {Dimension::force, newton},
      {Dimension::energy_per_area, {1, 0, -2}},
      {Dimension::energy, joule},
      {Dimension::mass, kilogram},
      {Dimension::time, {0, 0, 1}},
      {Dimension::rate, {0, 0, -1}},
      {Dimension::temperature, {0, 0, 0, 1}},
      {Dimension::density, {1, -3}},
      {Dimension::viscosity, {1, -1, -1}},
      {Dimension::thermal_conductivity, {1, 1, -3, -1}},
      {Dimension::resistivity, {1, 3, -3, 0, -2}}};
  std::map<Dimension, int> seen;
  for (const Unit& unit : units()) {
    const Defined expected = defined(std::string(unit.symbol));

    EXPECT_NEAR(unit.in_si(1.0) / expected.value, 1.0,
                8.0 * std::numeric_limits<double>::epsilon())
        << unit.symbol;
    EXPECT_EQ(expected.powers, powers.at(unit.dimension)) << unit.symbol;
    EXPECT_EQ(unit_called(unit.symbol), &unit) << unit.symbol;
    if (seen[unit.dimension]++ == 0) {
      EXPECT_TRUE(unit.is_usual) << unit.symbol;
      EXPECT_EQ(unit.in_si(1.0), 1.0) << unit.symbol;
      EXPECT_EQ(si_unit(unit.dimension), unit.symbol);
    }
  }
  EXPECT_EQ(seen.size(), powers.size());
}

// A unit that is a power of ten of that of SI gives the double of the decimal
// number.
RC_GTEST_PROP(UnitsProperty, PowersOfTenAreExact, (int number)) {
  const Unit unit =
      *rc::gen::suchThat(rc::gen::elementOf(units()), [](const Unit& any) {
        return any.factor == 1.0 && std::abs(any.decade) <= 22;
      });

  RC_ASSERT(
      unit.in_si(number) ==
      std::strtod(fmt::format("{}e{}", number, unit.decade).c_str(), nullptr));
}

TEST(Units, HaveOtherSpellings) {
  for (const auto& [spelling, symbol] :
       {std::pair("\u00b5m", "um"),
        std::pair("\u03bcm", "um"),
        std::pair("~m", "um"),
        std::pair("\xB5m", "um"), // Latin-1
        std::pair("\u00b5m\u00b2", "um^2"),
        std::pair("\xB5m\xB2", "um^2"), // Latin-1
        std::pair("mm2", "mm^2"),
        std::pair("mm**2", "mm^2"),
        std::pair("N/mm2", "N/mm^2"),
        std::pair("kN/mm\u00b2", "kN/mm^2"),
        std::pair("\u00c5", "angstrom"),
        std::pair("\u212b", "angstrom"),
        std::pair("\xC5", "angstrom"), // Latin-1
        std::pair("eV/\u00c5\u00b2", "eV/angstrom^2"),
        std::pair("kg/m3", "kg/m^3"),
        std::pair("Pa*s", "Pa s"),
        std::pair("mPa.s", "mPa s"),
        std::pair("Pa\u00b7s", "Pa s"),
        std::pair("Pa\u00a0s", "Pa s"),
        std::pair("W/(m*K)", "W/(m K)"),
        std::pair("\u03a9 m", "Ohm m"),
        std::pair(" nm\t", "nm")}) {
    const Unit* const unit = unit_called(spelling);

    ASSERT_NE(unit, nullptr) << spelling;
    EXPECT_EQ(unit->symbol, symbol);
  }
  // Another case, another letter, and the S with a caron, whose first byte is
  // an A with a ring in Latin-1. mPa would be meant as MPa.
  for (const char* const other :
       {"", "MM", "Gpa", "mPa", "Mm", "KN", "m m", "mm^", "\u0160", "E*", "h"})
    EXPECT_EQ(unit_called(other), nullptr) << other;
  EXPECT_EQ(unit_in_si("nm", Dimension::pressure), std::nullopt);
}

TEST(Units, AreReadWithTheirNumber) {
  EXPECT_EQ(read_with_unit("2 kN/mm^2", Dimension::pressure).value, 2e9);
  EXPECT_EQ(read_with_unit("20\u00b5m", Dimension::length).value, 20e-6);
  EXPECT_EQ(read_with_unit("0.1 in", Dimension::length).value, 2.54e-3);
  EXPECT_EQ(read_with_unit(" -5e-1 bar ", Dimension::pressure).value, -5e4);

  const auto mistake = [](const std::string& text) {
    const ValueReading read = read_with_unit(text, Dimension::length);
    EXPECT_FALSE(read.value) << text;
    return read.mistake;
  };
  const std::string allowed = "m, mm, um, nm, angstrom";
  EXPECT_EQ(
      mistake("10"),
      "has no unit; write \"10 m\" or \"10 mm\" or \"10 um\" or \"10 nm\" "
      "or \"10 angstrom\"");
  EXPECT_EQ(mistake("10 MPa"),
            "has the unit MPa of a pressure, but must have one of: " + allowed);
  EXPECT_EQ(mistake("10 nn"), "has the unknown unit \"nn\"; allowed: " +
                                  allowed + "; nearest: nm");
  EXPECT_EQ(mistake("nm"), "is a unit without a number; write \"1 nm\"");
  EXPECT_EQ(mistake("MPa"), "does not begin with a number");
  EXPECT_EQ(mistake("inf m"), "does not begin with a number");
  EXPECT_EQ(mistake("1e999 m"), "is out of the range of numbers");
  EXPECT_EQ(mistake("1e308 km"), "is out of the range of numbers");
  EXPECT_EQ(mistake("20,5 um"),
            "has a comma in its number; write a decimal point");
}

TEST(Units, HaveTheNearestOfTheSameDimension) {
  EXPECT_EQ(nearest_unit("kn/mm^2", Dimension::pressure), "kN/mm^2");
  EXPECT_EQ(nearest_unit("Gpa", Dimension::pressure), "GPa");
  EXPECT_EQ(nearest_unit("mPa", Dimension::pressure), "MPa");
  EXPECT_EQ(nearest_unit("torr", Dimension::pressure), "torr");
  EXPECT_EQ(nearest_unit("\u00b5M", Dimension::length), "um");
}

// Verifies that any text is read or refused with a reason, and that what is
// named is of the right dimension.
RC_GTEST_PROP(UnitsProperty, AnyTextIsReadOrRefused,
              (const std::string& text)) {
  const Dimension dimension = (*rc::gen::elementOf(units())).dimension;

  const ValueReading read = read_with_unit(text, dimension);
  const Unit* const nearest = unit_called(nearest_unit(text, dimension));

  RC_ASSERT(read.value.has_value() == read.mistake.empty());
  RC_ASSERT(nearest != nullptr && nearest->dimension == dimension);
}

} // namespace asperity::input::units_test
