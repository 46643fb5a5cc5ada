// Tests of theory/exact/contact_stiffness.hpp: the stiffness is the slope of
// the load, the pair has Mindlin's ratio, and an array of contacts on a block
// gives back the contact alone.
#include "theory/exact/contact_stiffness.hpp"
#include "theory/exact/hertz.hpp"
#include "theory/exact/punches.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace asperity::theory::contact_stiffness_test {

constexpr double modulus = 2e9, radius = 1e-4, poisson = 0.3;

// The slope of Hertz's load over the approach, and load over approach of a flat
// punch. Tolerance: differences of 1e-4 of the load, to second order.
TEST(ContactStiffness, IsTheSlopeOfTheLoad) {
  const double found = halfspace_stiffness(radius, modulus, poisson).normal;
  const double load = hertz_load(radius, 0.01, modulus);
  const auto approach = [&](double part) {
    return hertz_contact(part * load, 0.01, modulus).approach;
  };
  const FlatPunch punch(radius, modulus);

  EXPECT_NEAR(2e-4 * load / (approach(1.0001) - approach(0.9999)) / found, 1.0,
              1e-8);
  EXPECT_NEAR(1.0 / punch.contact(1.0).approach / found, 1.0, 1e-14);
}

// k_t/k_n = 2 (1 - nu)/(2 - nu): 14/17 for nu = 0.3.
TEST(ContactStiffness, HasMindlinsRatio) {
  const StiffnessPair found = halfspace_stiffness(radius, modulus, poisson);

  EXPECT_NEAR(found.tangential / found.normal, 14.0 / 17.0, 1e-14);
}

// The compliance of the array is that of one contact with the strain of a
// column under a unit force, (1 + nu)(1 - 2 nu)/((1 - nu) E) H/L^2 along the
// normal and 1/G H/L^2 in shear, less what the others displace it: the far
// fields (1 - nu^2)/(pi E r) and (2 - nu)(1 + nu)/(2 pi E r), the mean over
// directions, summed over the lattice with the constant S of hertz.hpp.
TEST(ContactStiffness, OfAnArrayGivesBackTheContactAlone) {
  const double youngs = modulus * (1.0 - poisson * poisson);
  const double side = 1e-3, depth = 3e-4;
  const double s_over_l = 3.9002649200019564 / side;
  const StiffnessPair alone = halfspace_stiffness(radius, modulus, poisson);
  const StiffnessPair in_array{
      1.0 /
          (1.0 / alone.normal +
           (1.0 + poisson) * (1.0 - 2.0 * poisson) / (1.0 - poisson) / youngs *
               depth / (side * side) -
           s_over_l * (1.0 - poisson * poisson) / (std::numbers::pi * youngs)),
      1.0 / (1.0 / alone.tangential +
             2.0 * (1.0 + poisson) / youngs * depth / (side * side) -
             s_over_l * (2.0 - poisson) * (1.0 + poisson) /
                 (2.0 * std::numbers::pi * youngs))};

  const StiffnessPair found =
      stiffness_alone(in_array, {side, depth, modulus, poisson});

  EXPECT_NEAR(found.normal / alone.normal, 1.0, 1e-12);
  EXPECT_NEAR(found.tangential / alone.tangential, 1.0, 1e-12);
}

TEST(ContactStiffness, RefusesArgumentsOutsideTheirRange) {
  EXPECT_THROW(halfspace_stiffness(0.0, modulus, poisson), std::domain_error);
  EXPECT_THROW(halfspace_stiffness(radius, modulus, 0.6), std::domain_error);
  EXPECT_THROW(stiffness_alone({1.0, 1.0}, {1e-3, 1e-3, modulus, 0.5}),
               std::domain_error);
  EXPECT_THROW(stiffness_alone({0.0, 1.0}, {1e-3, 1e-3, modulus, poisson}),
               std::domain_error);
}

} // namespace asperity::theory::contact_stiffness_test
