// Tests of theory/exact/adhesive_sphere.hpp: energy balance, the pressure of
// each solution, pull-off forces, and the limits between the three.
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

// JKR is Griffith's balance. The elastic energy of a paraboloid at approach
// delta with a prescribed radius a is U = E* (a delta^2 - 2 a^3 delta/(3 R) +
// a^5/(5 R^2)); dU/da = 2 pi a w and dU/ddelta = F, by central differences.
// Tolerance: their second order with steps of 1e-5.
TEST(JkrContact, BalancesElasticAndSurfaceEnergy) {
  for (const double a : {1e-4, 3e-4, 1e-3}) {
    const AdhesiveContact contact = jkr_contact(sphere, a);
    const double radius = sphere.sphere_radius;
    const auto energy = [&](double at, double approach) {
      return sphere.contact_modulus *
             (at * approach * approach -
              2.0 / 3.0 * std::pow(at, 3) * approach / radius +
              std::pow(at, 5) / (5.0 * radius * radius));
    };
    const double step = 1e-5 * a, rise = 1e-5 * a * a / radius;
    const double delta = contact.approach;

    const double release =
        (energy(a + step, delta) - energy(a - step, delta)) / (2.0 * step);
    const double force =
        (energy(a, delta + rise) - energy(a, delta - rise)) / (2.0 * rise);

    EXPECT_NEAR(release / (2.0 * pi * a * sphere.work_of_adhesion), 1.0, 1e-6);
    EXPECT_NEAR(force / contact.load, 1.0, 1e-6);
  }
}

// JKR's pressure deforms the surface to the shape of the sphere and carries the
// load. Tolerance: the quadrature next to the edge's singularity, sqrt(eps).
TEST(JkrContact, PressureDeformsTheSurfaceToTheSphere) {
  const double a = 4e-4;
  const AdhesiveContact contact = jkr_contact(sphere, a);
  const auto pressure = [&](double s) {
    return s < a ? jkr_pressure(sphere, a, s) : 0.0;
  };

  EXPECT_NEAR(load_of(pressure, {0.0, a}) / contact.load, 1.0, 1e-6);
  for (const double r : {0.0, 0.5 * a, 0.9 * a})
    EXPECT_NEAR(
        displacement_under(pressure, {0.0, a}, sphere.contact_modulus, r) +
            0.5 * r * r / sphere.sphere_radius,
        contact.approach, 1e-7 * a * a / sphere.sphere_radius);
}

// (3/2) pi w R is the minimum load, at a^3 = 9 pi w R^2/(8 E*); of the two
// contacts under a load, the returned one is that which grows with it.
TEST(JkrContact, PullsOffAtItsMinimumLoad) {
  const double radius = std::cbrt(9.0 * pi * sphere.work_of_adhesion *
                                  std::pow(sphere.sphere_radius, 2) /
                                  (8.0 * sphere.contact_modulus));
  const double least = -jkr_pull_off_force(sphere);

  EXPECT_NEAR(least, -1.5 * unit_force, 1e-18);
  EXPECT_NEAR(jkr_contact(sphere, radius).load / least, 1.0, 1e-14);
  EXPECT_GT(jkr_contact(sphere, 1.01 * radius).load, least);
  EXPECT_GT(jkr_contact(sphere, 0.99 * radius).load, least);
  for (const double load : {least, 0.5 * least, 0.0, 1e-2}) {
    const AdhesiveContact contact = jkr_contact_at_load(sphere, load);
    EXPECT_GE(contact.contact_radius, radius * (1.0 - 1e-7));
    EXPECT_NEAR(jkr_contact(sphere, contact.contact_radius).load, load,
                1e-13 * (unit_force + std::abs(load)));
  }
  EXPECT_THROW(jkr_contact_at_load(sphere, 1.001 * least), std::domain_error);
}

// DMT is Hertz under F + 2 pi w R; far above pi w R both JKR and DMT tend to
// Hertz with the relative corrections sqrt(6 pi w R/F) and 2 pi w R/F.
TEST(DmtContact, IsHertzUnderMoreLoad) {
  const AdhesiveContact contact = dmt_contact(sphere, 3e-4);
  const HertzContact hertz =
      hertz_contact(contact.load + dmt_pull_off_force(sphere), 1e-2, 3e6);

  EXPECT_NEAR(hertz.contact_radius / 3e-4, 1.0, 1e-14);
  EXPECT_NEAR(hertz.approach / contact.approach, 1.0, 1e-14);
  EXPECT_EQ(dmt_contact(sphere, 0.0).load, -2.0 * unit_force);
  for (const double a : {0.1, 1.0}) {
    const double load = hertz_load(a, 1e-2, 3e6);
    EXPECT_NEAR(jkr_contact(sphere, a).load / load,
                1.0 - std::sqrt(6.0 * unit_force / load), 1e-14);
    EXPECT_NEAR(dmt_contact(sphere, a).load / load,
                1.0 - 2.0 * unit_force / load, 1e-14);
  }
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

// lambda -> infinity tends to JKR as lambda^-2 and lambda -> 0 tends to DMT,
// for each of load, approach and pull-off, whose factor goes from 2 to 3/2.
TEST(MaugisSphere, TendsToJkrAndToDmt) {
  const double a = radius_of(1.5);
  const AdhesiveContact jkr = jkr_contact(sphere, a),
                        dmt = dmt_contact(sphere, a);
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
  EXPECT_THROW(jkr_contact({1e-2, 3e6, 0.0}, 1e-4), std::domain_error);
}

} // namespace asperity::theory::adhesive_sphere_test
