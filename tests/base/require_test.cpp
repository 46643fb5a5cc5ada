// Tests of base/require.hpp: the message names argument, value and range.
#include "base/require.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace asperity::require_test {

TEST(Require, NamesArgumentValueAndRange) {
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { require_positive("radius", -2.5, "m"); }),
            "radius = -2.5, but must be finite and > 0 [m]");
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { require_not_negative("load", -1e-9, "N"); }),
            "load = -1e-09, but must be finite and >= 0 [N]");
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { require_between("hurst", 1.5, 0.0, 1.0, "1"); }),
            "hurst = 1.5, but must be between 0 and 1 [1]");
}

TEST(Require, DistinguishesAValueFromItsLimit) {
  EXPECT_EQ(tests::message_of<std::domain_error>([] {
              require_between("poisson_ratio", 0.49999999, -1.0, 0.4999, "1");
            }),
            "poisson_ratio = 0.49999999, but must be between -1 and 0.4999 "
            "[1]");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_NE(number_text(std::nextafter(1.0, 2.0)), number_text(1.0));
  EXPECT_EQ(number_text(1.0234e-9, 1.0e-9, 2), "1.02e-09");
  EXPECT_EQ(number_text(3.4567e-9, 1.0e-9, 2), "3.5e-09");
  EXPECT_EQ(number_text(1e-9, 1.0234e-9, 2), "1e-09");
  EXPECT_EQ(number_text(1e-9, 1e-9, 2), "1e-09");
}

TEST(Require, RefusesWhatIsNotANumber) {
  EXPECT_NE(tests::message_of<std::domain_error>(
                [] { require_positive("x", NAN, "1"); }),
            "accepted");
  EXPECT_NE(tests::message_of<std::domain_error>(
                [] { require_not_negative("x", INFINITY, "1"); }),
            "accepted");
  EXPECT_NE(tests::message_of<std::domain_error>(
                [] { require_between("x", NAN, 0.0, 1.0, "1"); }),
            "accepted");
}

TEST(Require, AcceptsTheEndsOfARange) {
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { require_between("x", 1.0, 0.0, 1.0, "1"); }),
            "accepted");
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { require_not_negative("x", 0.0, "1"); }),
            "accepted");
}

} // namespace asperity::require_test
