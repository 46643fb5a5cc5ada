// Tests of theory/exact/adhesive_sphere.hpp: the pressure of the solution, its
// pull-off force, and its limits.
#include "tests/theory/axisymmetric.hpp"
#include "theory/exact/adhesive_sphere.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::adhesive_sphere_test {

using std::numbers::pi;

constexpr AdhesiveSphere sphere{1e-2, 3e6, 0.05};
constexpr double unit_force = pi * 0.05 * 1e-2; // pi w R

// sigma_0 of a transition parameter lambda.
MaugisSphere maugis(double lambda) {
  const double stiffness = 4.0 / 3.0 * sphere.contact_modulus;
  return MaugisSphere(sphere,
                      0.5 * lambda *
                          std::cbrt(pi * sphere.work_of_adhesion * stiffness *
                                    stiffness / sphere.sphere_radius));
}

// a in units of (pi w R^2/K)^{1/3}
double radius_of(double reduced) {
  return reduced *
         std::cbrt(pi * sphere.work_of_adhesion * sphere.sphere_radius *
                   sphere.sphere_radius / (4.0 / 3.0 * sphere.contact_modulus));
}

// Maugis' equations are verified with the pressure of the solution: it deforms
// the surface to the shape of the sphere, carries the load, and the gap is
// w/sigma_0 at r = c. Tolerance: the quadrature's.
TEST(MaugisSphere, PressureSatisfiesItsEquations) {
  for (const double lambda : {0.1, 1.0, 4.0})
    for (const double reduced : {0.3, 1.0, 2.0}) {
      const MaugisSphere sticky = maugis(lambda);
      const AdhesiveContact contact = sticky.contact(radius_of(reduced));
      const double a = contact.contact_radius, c = contact.adhesive_radius;
      const auto pressure = [&](double s) {
        return sticky.pressure(contact, s);
      };
      const auto shape = [&](double r) { // u + r^2/2R: delta inside
        return displacement_under(pressure, {0.0, a, c}, sphere.contact_modulus,
                                  r) +
               0.5 * r * r / sphere.sphere_radius;
      };
      const double stress = -sticky.pressure(contact, 0.5 * (a + c));
      const double scale = radius_of(1.0) * radius_of(1.0) / 1e-2;

      EXPECT_NEAR(load_of(pressure, {0.0, a, c}), contact.load,
                  1e-8 * (unit_force + std::abs(contact.load)));
      EXPECT_NEAR(shape(0.0), contact.approach, 1e-7 * scale);
      EXPECT_NEAR(shape(0.8 * a), contact.approach, 1e-7 * scale);
      EXPECT_NEAR((shape(c) - contact.approach) * stress /
                      sphere.work_of_adhesion,
                  1.0, 1e-6)
          << lambda << ' ' << reduced;
    }
}

// lambda -> infinity tends to JKR, F = 4 E* a^3/(3 R) - sqrt(8 pi w E* a^3) and
// delta = a^2/R - sqrt(2 pi w a/E*), as lambda^-2, and lambda -> 0 tends to
// DMT, Hertz's F - 2 pi w R and delta; the factor of the pull-off goes from 2
// to 3/2.
TEST(MaugisSphere, TendsToJkrAndToDmt) {
  const double a = radius_of(1.5);
  const auto& [radius, modulus, work] = sphere;
  const double hertz = hertz_load(a, radius, modulus);
  const AdhesiveContact jkr{
      a, a, a * a / radius - std::sqrt(2.0 * pi * work * a / modulus),
      hertz - std::sqrt(8.0 * pi * work * modulus * a * a * a)};
  const AdhesiveContact dmt{a, a, a * a / radius, hertz - 2.0 * unit_force};
  for (const double lambda : {10.0, 30.0}) {
    const AdhesiveContact contact = maugis(lambda).contact(a);
    const double distance = 1.0 / lambda / lambda;
    EXPECT_NEAR(contact.load, jkr.load, distance * unit_force);
    EXPECT_NEAR(contact.approach, jkr.approach, distance * a * a / 1e-2);
    EXPECT_NEAR(maugis(lambda).pull_off_force() / unit_force, 1.5, distance);
  }
  for (const double lambda : {1e-2, 1e-3}) {
    const AdhesiveContact contact = maugis(lambda).contact(a);
    EXPECT_NEAR(contact.load, dmt.load, 3.0 * std::sqrt(lambda) * unit_force);
    EXPECT_NEAR(contact.approach, dmt.approach,
                3.0 * std::sqrt(lambda) * a * a / 1e-2);
    EXPECT_NEAR(maugis(lambda).pull_off_force() / unit_force, 2.0,
                3.0 * lambda);
  }
  double last = 2.0 * unit_force;
  for (const double lambda : {0.01, 0.1, 0.3, 1.0, 3.0}) {
    EXPECT_LT(maugis(lambda).pull_off_force(), last);
    last = maugis(lambda).pull_off_force();
  }
}

// Verifies that the stable contact is found for a load, down to the pull-off
// and no further.
TEST(MaugisSphere, FindsTheContactOfALoad) {
  const MaugisSphere sticky = maugis(1.0);
  const double pull = sticky.pull_off_force();
  double last = 0.0;
  for (const double load : {-0.999 * pull, -0.5 * pull, 0.0, 10.0 * pull}) {
    const AdhesiveContact contact = sticky.contact_at_load(load);
    EXPECT_NEAR(contact.load, load, 1e-12 * (pull + std::abs(load)));
    EXPECT_GT(contact.contact_radius, last);
    last = contact.contact_radius;
  }
  EXPECT_NEAR(sticky.transition_parameter(), 1.0, 1e-14);
  EXPECT_THROW(sticky.contact_at_load(-1.01 * pull), std::domain_error);
  EXPECT_THROW(MaugisSphere(sphere, 0.0), std::domain_error);
  EXPECT_THROW(MaugisSphere({1e-2, 3e6, 0.0}, 1e6), std::domain_error);
}

} // namespace asperity::theory::adhesive_sphere_test
