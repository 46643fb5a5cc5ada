// Numbers as a person writes them, on pages and on the terminal.
#include "base/shown_number.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(ShownNumber, QuantitiesHavePrefixesAndNoExponents) {
  EXPECT_EQ(quantity_text(3.33e-6, "m", 3), "3.33 µm");
  EXPECT_EQ(quantity_text(12.1e-9, "m^2", 3), "12 100 µm²");
  EXPECT_EQ(quantity_text(2e9, "Pa"), "2 GPa");
  EXPECT_EQ(quantity_text(999.96e3, "Pa", 3), "1 MPa");
  EXPECT_EQ(quantity_text(700e3, "Pa", 3), "700 kPa");
  EXPECT_EQ(quantity_text(-1500.0, "Pa"), "-1.5 kPa");
  EXPECT_EQ(quantity_text(9.94e-10, "m", 3), "0.994 nm");
  EXPECT_EQ(quantity_text(0.0, "Pa"), "0 Pa");
  EXPECT_EQ(quantity_text(1.25e8, "1/m"), "1.25e+08 1/m");
  EXPECT_EQ(quantity_text(123456.0, "1", 7), "123 456");
  EXPECT_EQ(quantity_text(2.46e-18, "m^3/s", 3), "2.46e-18 m^3/s");
  EXPECT_EQ(quantity_text(std::numeric_limits<double>::infinity(), "m"), "–");
}

TEST(ShownNumber, AnIntervalDecidesOnTheDigits) {
  EXPECT_EQ(interval_text(33.21e-9, 32.0e-9, 34.4e-9, "m"), "33 nm (32 to 34)");
  EXPECT_EQ(interval_text(2.31, 2.12, 2.5, "%"), "2.3 % (2.1 to 2.5)");
  EXPECT_EQ(interval_text(99.4, 98.81, 100.0, "%"), "99.4 % (98.8 to 100.0)");
  EXPECT_EQ(interval_text(33.21e-9, 33.2099e-9, 33.2101e-9, "m"), "33.2 nm");
  EXPECT_EQ(interval_text(33.21e-9, 33.21e-9, 33.21e-9, "m"), "33.2 nm");
  EXPECT_EQ(interval_text(2.0, -28.0, 32.0, "%"), "0 % (-30 to 30)");
}

} // namespace
} // namespace asperity
