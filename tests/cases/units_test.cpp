// Tests of input/types/units.hpp: exact conversion, and the messages about a
// wrong unit.
#include "input/types/units.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace asperity::cases::units_test {

const std::vector<mechanics::ReferenceUnit> by_the_grid = {
    mechanics::ReferenceUnit::length, mechanics::ReferenceUnit::spacing};

QuantityReading length_from(const std::string& text) {
  return read_quantity(text, Dimension::length, by_the_grid);
}

// A decimal unit gives the double nearest to the decimal number, as the C
// library reads "14e-9". This is exact, because the powers of ten up to 1e22
// are doubles and one division or product rounds once.
TEST(Units, ConvertWholeNumbersWithOneRounding) {
  struct Example {
    const char* text;
    Dimension dimension;
    const char* in_si;
  };

  for (const Example& example :
       std::vector<Example>{{"14 nm", Dimension::length, "14e-9"},
                            {"3 angstrom", Dimension::length, "3e-10"},
                            {"7 um", Dimension::length, "7e-6"},
                            {"7 \u00b5m", Dimension::length, "7e-6"},
                            {"7 \u03bcm", Dimension::length, "7e-6"},
                            {"9 mm", Dimension::length, "9e-3"},
                            {"2 m", Dimension::length, "2"},
                            {"5 Pa", Dimension::pressure, "5"},
                            {"5 kPa", Dimension::pressure, "5e3"},
                            {"5 MPa", Dimension::pressure, "5e6"},
                            {"2 GPa", Dimension::pressure, "2e9"},
                            {"3 N", Dimension::force, "3"},
                            {"4 J/m^2", Dimension::energy_per_area, "4"},
                            {"1.2566e6 1/m", Dimension::wavevector, "1.2566e6"},
                            {"8 Pa/m", Dimension::stiffness, "8"}}) {
    const QuantityReading reading =
        read_quantity(example.text, example.dimension, {});

    ASSERT_TRUE(reading.quantity) << example.text << " " << reading.mistake;
    EXPECT_EQ(reading.quantity->value, std::strtod(example.in_si, nullptr))
        << example.text;
    EXPECT_EQ(reading.quantity->reference, mechanics::ReferenceUnit::si);
  }
}

TEST(Units, KeepTheProblemsOwnReferenceUnits) {
  const QuantityReading load =
      read_quantity("0.3 E*", Dimension::pressure,
                    {mechanics::ReferenceUnit::contact_modulus});
  const QuantityReading penalty =
      read_quantity("100E*/h", Dimension::stiffness,
                    {mechanics::ReferenceUnit::contact_modulus_per_spacing});
  const QuantityReading gap = read_quantity(
      " 2\th_rms ", Dimension::length, {mechanics::ReferenceUnit::rms_height});

  const QuantityReading by_slope =
      read_quantity("0.3 E* h'", Dimension::pressure,
                    {mechanics::ReferenceUnit::contact_modulus_times_slope});

  EXPECT_EQ(by_slope.quantity->value, 0.3);
  EXPECT_EQ(by_slope.quantity->reference,
            mechanics::ReferenceUnit::contact_modulus_times_slope);
  EXPECT_EQ(load.quantity->value, 0.3);
  EXPECT_EQ(load.quantity->reference,
            mechanics::ReferenceUnit::contact_modulus);
  EXPECT_EQ(penalty.quantity->value, 100.0);
  EXPECT_EQ(penalty.quantity->reference,
            mechanics::ReferenceUnit::contact_modulus_per_spacing);
  EXPECT_EQ(gap.quantity->reference, mechanics::ReferenceUnit::rms_height);
}

TEST(Units, StateTheMistakeAndWhatIsAllowed) {
  const std::string allowed = "m, mm, um, nm, angstrom, length, h";

  EXPECT_EQ(length_from("14 nn").mistake,
            "has the unknown unit \"nn\"; allowed: " + allowed +
                "; nearest: nm");
  EXPECT_EQ(length_from("14 MPa").mistake,
            "has the unit MPa of a pressure, but must have one of: " + allowed);
  EXPECT_EQ(length_from("14").mistake,
            "has no unit; allowed: " + allowed +
                " (a number without quotes is in m)");
  EXPECT_EQ(length_from("nm").mistake,
            "is a unit without a number; write \"1 nm\"");
  EXPECT_EQ(length_from("MPa").mistake, "does not begin with a number");
  EXPECT_EQ(length_from("inf nm").mistake, "does not begin with a number");
  EXPECT_EQ(length_from("1e999 m").mistake, "is out of the range of numbers");
  EXPECT_EQ(read_quantity("1e300 GPa", Dimension::pressure, {}).mistake,
            "is out of the range of numbers");
  EXPECT_EQ(length_from("").mistake, "does not begin with a number");
}

// A reference unit is refused where the key does not allow it, even if it is
// known.
TEST(Units, OfferAReferenceUnitOnlyWhereTheKeyDoes) {
  EXPECT_EQ(read_quantity("2 E*", Dimension::pressure, {}).mistake,
            "has the unit E* of a pressure, but must have one of: Pa, kPa, "
            "MPa, GPa");
}

TEST(Units, NameTheNearestDespiteTheCase) {
  EXPECT_EQ(read_quantity("2 kn/mm^2", Dimension::pressure, {}).mistake,
            "has the unknown unit \"kn/mm^2\"; allowed: Pa, kPa, MPa, GPa; "
            "nearest: kN/mm^2");
  EXPECT_NE(read_quantity("2 e*", Dimension::pressure,
                          {mechanics::ReferenceUnit::contact_modulus})
                .mistake.find("nearest: E*"),
            std::string::npos);
  EXPECT_EQ(read_quantity("2 kN/mm^2", Dimension::pressure, {})
                .quantity.value()
                .value,
            2e9);
  EXPECT_NE(read_quantity("2 Gpa", Dimension::pressure, {})
                .mistake.find("nearest: GPa"),
            std::string::npos);
}

// Verifies that read_quantity reads what write_quantity writes to the last bit.
RC_GTEST_PROP(UnitsProperty, WrittenQuantitiesReadBack, (double number)) {
  RC_PRE(std::isfinite(number));
  using mechanics::ReferenceUnit;
  const auto reference = *rc::gen::element(
      ReferenceUnit::si, ReferenceUnit::contact_modulus, ReferenceUnit::length,
      ReferenceUnit::spacing, ReferenceUnit::rms_height,
      ReferenceUnit::contact_modulus_per_spacing,
      ReferenceUnit::contact_modulus_times_slope);
  const Dimension dimension =
      reference == ReferenceUnit::si
          ? *rc::gen::element(Dimension::length, Dimension::pressure,
                              Dimension::energy, Dimension::viscosity)
          : reference_dimension(reference);
  const mechanics::Quantity quantity{number, reference};

  const QuantityReading reading = read_quantity(
      write_quantity(quantity, dimension), dimension, {reference});

  RC_ASSERT(reading.quantity.has_value());
  RC_ASSERT(reading.quantity->value == number);
  RC_ASSERT(reading.quantity->reference == reference);
}

// An integer of any unit is worth factor times the SI unit, with the factor of
// the metric prefix from an independent list.
RC_GTEST_PROP(UnitsProperty, PrefixesAreThePowersOfTen, (int number)) {
  const auto [symbol, exponent] = *rc::gen::element(
      std::pair<std::string, std::string>{"nm", "e-9"},
      std::pair<std::string, std::string>{"um", "e-6"},
      std::pair<std::string, std::string>{"mm", "e-3"},
      std::pair<std::string, std::string>{"angstrom", "e-10"});
  const std::string digits = std::to_string(number);

  const QuantityReading reading = length_from(digits + " " + symbol);

  RC_ASSERT(reading.quantity->value ==
            std::strtod((digits + exponent).c_str(), nullptr));
}

// Verifies that any text is read or refused with a reason.
RC_GTEST_PROP(UnitsProperty, AnyTextIsReadOrRefused,
              (const std::string& text)) {
  const QuantityReading reading = length_from(text);

  RC_ASSERT(reading.quantity.has_value() == reading.mistake.empty());
}

} // namespace asperity::cases::units_test
