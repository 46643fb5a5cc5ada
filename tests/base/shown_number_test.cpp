// Numbers as a person writes them, on pages and on the terminal.
#include "base/shown_number.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(ShownNumber, QuantitiesHavePrefixesAndNoExponents) {
  EXPECT_EQ(quantity_text(3.33e-6, "m", 3), "3.33 µm");
  EXPECT_EQ(quantity_text(12.1e-9, "m^2", 3), "12 100 µm²");
  EXPECT_EQ(quantity_text(0.61e-12, "m^2"), "0.61 µm²");
  EXPECT_EQ(quantity_text(4.2e-15, "m^2"), "4200 nm²");
  EXPECT_EQ(quantity_text(2e9, "Pa"), "2 GPa");
  EXPECT_EQ(quantity_text(999.96e3, "Pa", 3), "1 MPa");
  EXPECT_EQ(quantity_text(700e3, "Pa", 3), "700 kPa");
  EXPECT_EQ(quantity_text(-1500.0, "Pa"), "-1.5 kPa");
  EXPECT_EQ(quantity_text(9.94e-10, "m", 3), "0.994 nm");
  EXPECT_EQ(quantity_text(0.0, "Pa"), "0 Pa");
  EXPECT_EQ(quantity_text(1.25e8, "1/m"), "1.25e+08 1/m");
  EXPECT_EQ(quantity_text(123456.0, "1", 7), "123 456");
  EXPECT_EQ(quantity_text(2.46e-18, "m^3/s", 3), "2.46e-18 m³/s");
  EXPECT_EQ(quantity_text(std::numeric_limits<double>::infinity(), "m"), "–");
}

TEST(ShownNumber, AnIntervalDecidesOnTheDigits) {
  EXPECT_EQ(interval_text(33.21e-9, 32.0e-9, 34.4e-9, "m"), "33 nm (32 to 34)");
  EXPECT_EQ(interval_text(0.0231, 0.0212, 0.025, "%"), "2.3 % (2.1 to 2.5)");
  EXPECT_EQ(interval_text(0.994, 0.9881, 1.0, "%"), "99.4 % (98.8 to 100.0)");
  EXPECT_EQ(interval_text(33.21e-9, 33.2099e-9, 33.2101e-9, "m"), "33.2 nm");
  EXPECT_EQ(interval_text(33.21e-9, 33.21e-9, 33.21e-9, "m"), "33.2 nm");
  EXPECT_EQ(interval_text(0.02, -0.28, 0.32, "%"), "0 % (-30 to 30)");
}

TEST(ShownNumber, AnUncertaintyDecidesOnTheDigits) {
  EXPECT_EQ(uncertain_text(7.206e-2, 1.7e-2, "%"), "7.2 ± 1.7 %");
  EXPECT_EQ(uncertain_text(5.611e-9, 0.3e-9, "m"), "5.61 ± 0.30 nm");
  EXPECT_EQ(uncertain_text(393.3e-12, 10.2e-12, "m^2"), "393 ± 10 µm²");
  EXPECT_EQ(uncertain_text(4.83e-9, 5e-9, "m"), "4.8 ± 5.0 nm");
  EXPECT_EQ(uncertain_text(-30.77e6, 2.44e6, "Pa"), "-30.8 ± 2.4 MPa");
  EXPECT_EQ(uncertain_text(98.321e-2, 1e-9, "%"), "98.32 %");
  EXPECT_EQ(uncertain_text(0.0123, 0.00456, "1"), "0.0123 ± 0.0046");
  EXPECT_EQ(uncertain_text(123456.0, 1200.0, "1"), "123 500 ± 1200");
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(uncertain_text(2e6, unknown, "Pa"), "2 MPa");
  EXPECT_EQ(uncertain_text(unknown, 1.0, "Pa"), "–");
}

// Two exponents, or a prefix that suits only the smaller number, hide which of
// both is larger.
TEST(ShownNumber, AnUncertaintyHasTheExponentOfItsNumber) {
  EXPECT_EQ(uncertain_text(7.67e-26, 1.3e-25, "m^3"), "(0.8 ± 1.3)e-25 m³");
  EXPECT_EQ(uncertain_text(5.39e-24, 2e-24, "m^3"), "(5.4 ± 2.0)e-24 m³");
  EXPECT_EQ(uncertain_text(-1.234e-18, 1.2e-20, "m^3/s"),
            "(-1.234 ± 0.012)e-18 m³/s");
  EXPECT_EQ(uncertain_text(9.96e-7, 3e-7, "m^2 K/W"),
            "(10.0 ± 3.0)e-07 m² K/W");
  EXPECT_EQ(uncertain_text(1.25e8, 3e5, "1/m"), "(1.250 ± 0.003)e+08 1/m");
  EXPECT_EQ(uncertain_text(-500.0, 1300.0, "Pa"), "-0.5 ± 1.3 kPa");
}

} // namespace
} // namespace asperity
