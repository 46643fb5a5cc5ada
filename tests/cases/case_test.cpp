// Tests of input/types/case.hpp: reference units and the single block that
// represents a pair.
#include "input/types/case.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace asperity::cases::case_test {

constexpr mechanics::Scales scales{2e9, 1e-5, 2e-8, 3.4e-8, 0.25};

// A quantity is its number times its reference unit. Exact: one product.
TEST(Quantity, IsItsNumberTimesItsReferenceUnit) {
  EXPECT_EQ(
      (mechanics::Quantity{7.0, mechanics::ReferenceUnit::si}.in_si(scales)),
      7.0);
  EXPECT_EQ((mechanics::Quantity{0.5, mechanics::ReferenceUnit::contact_modulus}
                 .in_si(scales)),
            1e9);
  EXPECT_EQ((mechanics::Quantity{
                0.5, mechanics::ReferenceUnit::contact_modulus_times_slope}
                 .in_si(scales)),
            0.25e9);
  EXPECT_EQ((mechanics::Quantity{2.0, mechanics::ReferenceUnit::length}.in_si(
                scales)),
            2e-5);
  EXPECT_EQ((mechanics::Quantity{2.0, mechanics::ReferenceUnit::spacing}.in_si(
                scales)),
            4e-8);
  EXPECT_EQ(
      (mechanics::Quantity{0.5, mechanics::ReferenceUnit::rms_height}.in_si(
          scales)),
      1.7e-8);
  EXPECT_DOUBLE_EQ(
      (mechanics::Quantity{
          100.0, mechanics::ReferenceUnit::contact_modulus_per_spacing}
           .in_si(scales)),
      1e19); // 100 * 2e9 Pa / 2e-8 m
}

TEST(Quantity, RefusesAReferenceUnitThatIsNotKnown) {
  const mechanics::Quantity quantity{2.0, mechanics::ReferenceUnit::rms_height};

  EXPECT_THROW(quantity.in_si({.length = 1.0}), std::domain_error);
}

// The block of modulus E (1 - nu^2) has the E* of the pair, from E* = E / (1 -
// nu^2) solved for E.
TEST(MaterialSpec, GivesTheBlockThatRepresentsThePair) {
  const mechanics::MaterialSpec material{2e9, 0.3};

  const double youngs_modulus = material.block_youngs_modulus();

  EXPECT_DOUBLE_EQ(youngs_modulus / (1.0 - 0.3 * 0.3), 2e9);
}

TEST(MaterialSpec, NeedsPoissonsRatioForTheBlock) {
  try {
    (void)mechanics::MaterialSpec{2e9, {}}.block_youngs_modulus();
    FAIL() << "a block without Poisson's ratio was accepted";
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("poisson_ratio"),
              std::string::npos);
  }
}

} // namespace asperity::cases::case_test
