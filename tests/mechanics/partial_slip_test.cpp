// Tests of mechanics/partial_slip.hpp with Hertz' contact, against Cattaneo and
// Mindlin.
#include "mechanics/partial_slip.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::mechanics::partial_slip_test {
namespace {

// The test "cattaneo" of the program CONTACT, in mm and N: equal bodies with
// G = 200, nu = 0.42, the radius 50 of their gap, and mu = 0.4, pressed by F_n
// = 9.1954, which makes a = 1, and pulled by F_x = 7/8 mu F_n: they shift by
// 0.00817241.
constexpr double shear_modulus = 200.0, poisson = 0.42, friction = 0.4,
                 force = 9.1954, radius = 50.0;

MaterialSpec equal_bodies() {
  const double youngs_modulus = 2.0 * shear_modulus * (1.0 + poisson);
  const BodyModuli body{youngs_modulus, poisson};
  return {.contact_modulus = youngs_modulus / (2.0 * (1.0 - poisson * poisson)),
          .poisson_ratio = poisson,
          .counter = body};
}

/// Hertz' contact, per unit of nominal area.
NormalContact hertz(double load) {
  const double modulus = equal_bodies().contact_modulus;
  const double a = std::cbrt(0.75 * load * radius / modulus);
  const double ratio = tangential_ratio(equal_bodies());
  return {load,
          a * a / radius,
          std::numbers::pi * a * a,
          0.4 * load * a * a / radius,
          {ratio, ratio}};
}

PartialSlip at(double share) {
  const std::array path{hertz(force * (1.0 - share)), hertz(force)};
  return partial_slip(path, friction);
}

} // namespace

TEST(PartialSlip, IsThatOfCattaneo) {
  const PartialSlip slip = at(0.875);

  EXPECT_NEAR(slip.tangential_stress, 0.875 * friction * force, 1e-14);
  EXPECT_NEAR(slip.stick_area / hertz(force).area_fraction, 0.25, 1e-14);
  EXPECT_NEAR(slip.stick_area + slip.slip_area, hertz(force).area_fraction,
              1e-14);
  EXPECT_NEAR(std::sqrt(hertz(force).area_fraction / std::numbers::pi), 1.0,
              1e-5);
  EXPECT_NEAR(slip.displacement.x, 0.00817241, 1e-8);
  EXPECT_NEAR(slip.displacement.y, 0.00817241, 1e-8);
}

// Loads between P' and P change nothing while kappa is the same.
TEST(PartialSlip, DoesNotDependOnTheLoadsBetween) {
  const std::array path{hertz(0.3 * force), hertz(0.5 * force),
                        hertz(0.9 * force), hertz(force)};
  const PartialSlip slip = partial_slip(path, friction);

  EXPECT_NEAR(slip.displacement.x / at(0.7).displacement.x, 1.0, 1e-14);
  EXPECT_NEAR(slip.loss.x / at(0.7).loss.x, 1.0, 1e-13);
}

// kappa rises linearly with the approach, as of a contact whose spots become
// longer: the displacement is mu times the integral of kappa dD, for any number
// of loads between, and the loss tends to that of many.
TEST(PartialSlip, FollowsTheRatiosOfTheContactsBetween) {
  const auto path_of = [](int steps) {
    std::vector<NormalContact> path;
    for (int i = 0; i <= steps; ++i) {
      path.push_back(hertz(force * (0.5 + 0.5 * i / steps)));
      const double approach = path.back().approach / hertz(force).approach;
      path.back().ratio = {1.0 + 0.2 * approach, 1.4 - 0.2 * approach};
    }
    return path;
  };
  const double high = hertz(force).approach;
  const double low = hertz(0.5 * force).approach;
  const double exact =
      friction * (high - low) * (1.0 + 0.1 * (1.0 + low / high));
  const PartialSlip fine = partial_slip(path_of(1000), friction);
  for (const int steps : {1, 3}) {
    const PartialSlip slip = partial_slip(path_of(steps), friction);
    EXPECT_NEAR(slip.displacement.x / exact, 1.0, 1e-13);
    EXPECT_NEAR(slip.loss.x / fine.loss.x, 1.0, 2e-3);
    EXPECT_NEAR(slip.loss.y / fine.loss.y, 1.0, 2e-3);
  }
}

// Johnson, Contact Mechanics (1985), Eq. (7.62), with s = 1 - Q/(mu F):
//     (9 mu^2 F^2/(10 a)) 2 (2 - nu)/G
//     {1 - s^{5/3} - (5/6) (1 - s) [1 + s^{2/3}]}.
TEST(PartialSlip, LosesWhatMindlinAndDeresiewiczGive) {
  for (const double share : {0.1, 0.5, 0.9}) {
    const double left = 1.0 - share;
    const double exact =
        9.0 * friction * friction * force * force * 2.0 * (2.0 - poisson) /
        (10.0 * shear_modulus) *
        (1.0 - std::pow(left, 5.0 / 3.0) -
         5.0 / 6.0 * share * (1.0 + std::pow(left, 2.0 / 3.0)));
    EXPECT_NEAR(at(share).loss.x / exact, 1.0, 1e-4) << share;
  }
}

TEST(PartialSlip, RatioAndCouplingOfKnownPairs) {
  EXPECT_NEAR(coupling(equal_bodies()), 0.0, 1e-15);
  EXPECT_NEAR(tangential_ratio(equal_bodies()),
              (2.0 - poisson) / (2.0 - 2.0 * poisson), 1e-14);
  const MaterialSpec rigid{.contact_modulus = 1.0, .poisson_ratio = 0.3};
  EXPECT_NEAR(coupling(rigid), 0.4 / 1.4, 1e-15);
  EXPECT_NEAR(tangential_ratio(rigid), 1.7 / 1.4, 1e-15);
  // Waves along the traction have the normal compliance, for any nu.
  for (const MaterialSpec& pair : {equal_bodies(), rigid})
    EXPECT_NEAR(tangential_ratio(pair) - 0.5 * tangential_anisotropy(pair), 1.0,
                1e-14);
}

} // namespace asperity::mechanics::partial_slip_test
