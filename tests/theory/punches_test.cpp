// Tests of theory/exact/punches.hpp: the stated pressure causes the stated
// displacement, inside and outside, and carries the stated load.
#include "tests/theory/axisymmetric.hpp"
#include "theory/exact/punches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::punches_test {

constexpr double modulus = 2e9, load = 3.0;

// The displacement of both punches is that of their pressure. Tolerance: the
// quadrature of root and logarithmic singularities at its ends, which resolves
// distances to a no finer than eps a: sqrt(eps).
TEST(Punches, PressureCausesTheDisplacement) {
  const FlatPunch punch(1e-3, modulus);
  const Cone cone(0.1, modulus);
  const double a = cone.contact(load).contact_radius;
  for (const double ratio : {0.0, 0.3, 0.9, 1.1, 2.0, 30.0, 1e4}) {
    const double flat = displacement_under(
        [&](double s) { return s < 1e-3 ? punch.pressure(load, s) : 0.0; },
        {0.0, 1e-3}, modulus, 1e-3 * ratio);
    const double pointed = displacement_under(
        [&](double s) { return s > 0.0 ? cone.pressure(load, s) : 0.0; },
        {0.0, a}, modulus, ratio * a);

    EXPECT_NEAR(flat / punch.displacement(load, 1e-3 * ratio), 1.0, 1e-7)
        << ratio;
    EXPECT_NEAR(pointed / cone.displacement(load, a * ratio), 1.0, 1e-7)
        << ratio;
  }
}

// The load is the integral of the pressure and the rigid depth is u(0).
TEST(Punches, CarryTheirLoad) {
  const FlatPunch punch(1e-3, modulus);
  const Cone cone(0.1, modulus);
  const PunchContact spot = cone.contact(load);
  const auto flat = [&](double s) {
    return s < 1e-3 ? punch.pressure(load, s) : 0.0;
  };
  const auto pointed = [&](double s) {
    return s > 0.0 ? cone.pressure(load, s) : 0.0;
  };

  EXPECT_NEAR(load_of(flat, {0.0, 1e-3}) / load, 1.0, 1e-7);
  EXPECT_NEAR(load_of(pointed, {0.0, spot.contact_radius}) / load, 1.0, 1e-10);
  EXPECT_EQ(cone.displacement(load, 0.0), spot.approach);
  EXPECT_NEAR(punch.contact(load).approach * 2.0 * modulus * 1e-3, load, 1e-14);
}

// A tilted end has the pressure (2 E* angle/pi) x/sqrt(a^2 - r^2) (Johnson,
// Sec. 3.8), whose moment is the integral of x p over the end: after that over
// the angle, 2 E* angle times the integral of r^3/sqrt(a^2 - r^2), here by
// quadrature. Its edge lifts where this exceeds the pressure of the load, at an
// approach of 2 a angle. Tolerance: that of a root singularity.
TEST(Punches, HaveTheMomentOfTheirPressure) {
  const double a = 1e-3, angle = 1e-4;
  const FlatPunch punch(a, modulus);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double integral = quadrature.integrate(
      [&](double r, double from_end) {
        return r * r * r /
               std::sqrt((a + r) * (r < 0.5 * a ? a - r : std::abs(from_end)));
      },
      0.0, a);
  const double least = 2.0 * modulus * a * 2.0 * a * angle; // load
  const double edge = 0.999 * a;

  EXPECT_NEAR(punch.moment(angle) / (2.0 * modulus * angle * integral), 1.0,
              1e-7);
  EXPECT_NEAR(punch.pressure(least, edge) /
                  (2.0 * modulus * angle / std::numbers::pi * a /
                   std::sqrt(a * a - edge * edge)),
              1.0, 1e-12);
}

TEST(Punches, RefuseWhatIsOutsideTheirRange) {
  EXPECT_THROW(FlatPunch(0.0, 1.0), std::domain_error);
  EXPECT_THROW(Cone(-0.1, 1.0), std::domain_error);
  EXPECT_THROW(Cone(0.1, 1.0).contact(-1.0), std::domain_error);
  EXPECT_NO_THROW(FlatPunch(1.0, 1.0).contact(-1.0));
  EXPECT_THROW(FlatPunch(1.0, 1.0).pressure(1.0, -1.0), std::domain_error);
  EXPECT_THROW(FlatPunch(1.0, 1.0).moment(NAN), std::domain_error);
}

// Potentials of unit charges on a square lattice of period 1 and a neutralising
// background: -3.90026492 at a charge due to all others, and -1.61554263 midway
// between four charges, which is minus the sum of (-1)^(i+j)/|R| of a chequered
// lattice (Borwein, Borwein and Taylor, J. Math. Phys. 26, 2999, 1985).
// Tolerance: the printed digits.
TEST(FlatPunch, SinksToItsRecessInAnArray) {
  const double radius = 0.1, soft = 2.0, period = 1.0, recess = 1e-3;
  const FlatPunch punch(radius, soft);

  const double touching = punch.touching_load_in_array(recess, period);

  const double scale = touching / (std::numbers::pi * soft * period);
  const double at_punch = punch.contact(touching).approach - 3.90026492 * scale;
  const double midway = -1.61554263 * scale;
  EXPECT_NEAR((at_punch - midway) / recess, 1.0, 1e-8);
}

TEST(FlatPunch, SinksToItsRecessAtADistance) {
  const FlatPunch punch(0.1, 2.0);

  const double touching = punch.touching_load(1e-3, 0.5);

  EXPECT_NEAR(punch.contact(touching).approach -
                  punch.displacement(touching, 0.5),
              1e-3, 1e-15);
}

// The pressure of a rounded punch is (E*/pi) int g'(x) dx/sqrt(x^2 - r^2) from
// r or b to a, with g' of its header. It carries the load, and its displacement
// is the stated one: within the contact that of the rigid shape. Tolerances:
// nested quadrature of root singularities, outside the stated 1e-6 of the
// approach.
TEST(RoundedPunch, HasTheLoadAndTheDisplacementOfItsPressure) {
  const double b = 1e-3, edge = 0.5;
  const RoundedPunch punch(b, edge, modulus);
  for (const double force : {0.01, 3.0, 1e3}) {
    const PunchContact spot = punch.contact(force);
    const double a = spot.contact_radius;
    const auto pressure = [&](double r) {
      if (r >= a)
        return 0.0;
      const double from = std::max(r, b);
      // x = sqrt(r^2 + y^2): dx/sqrt(x^2 - r^2) = dy/x
      const auto inner = [&](double y) {
        const double x = std::hypot(r, y);
        const double s = std::sqrt(std::max((x - b) * (x + b), 0.0));
        return (2.0 * s - b * std::atan(s / b)) / x;
      };
      boost::math::quadrature::tanh_sinh<double> quadrature;
      return modulus / (std::numbers::pi * edge) *
             quadrature.integrate(inner, std::sqrt((from - r) * (from + r)),
                                  std::sqrt((a - r) * (a + r)), 1e-10);
    };

    EXPECT_NEAR(load_of(pressure, {0.0, b, a}) / force, 1.0, 1e-7) << force;
    for (const double radius : {0.0, 0.7 * b, 0.5 * (a + b), 1.02 * a, 3.0 * a})
      EXPECT_NEAR(displacement_under(pressure, {0.0, b, a}, modulus, radius),
                  punch.displacement(spot, radius), 2e-6 * spot.approach)
          << force << " at " << radius / a;
  }
}

// A light load is that of a flat punch, and a flat end that is small against
// the contact leaves Hertz' sphere, to (b/a)^2 and (s/b)^2. No load does not
// press.
TEST(RoundedPunch, IsAFlatPunchOrASphereInItsLimits) {
  const double edge = 0.5;
  const PunchContact sphere = RoundedPunch(1e-6, edge, modulus).contact(load);
  const double a = std::cbrt(0.75 * load * edge / modulus);
  const RoundedPunch flat(1e-3, 1e-9, modulus);

  EXPECT_NEAR(sphere.contact_radius / a, 1.0, 2e-3);
  EXPECT_NEAR(sphere.approach / (a * a / edge), 1.0, 4e-3);
  EXPECT_NEAR(flat.contact(load).approach /
                  FlatPunch(1e-3, modulus).contact(load).approach,
              1.0, 1e-2);
  EXPECT_EQ(flat.contact(0.0).approach, 0.0);
  EXPECT_EQ(flat.contact(0.0).contact_radius, 1e-3);
  EXPECT_THROW(flat.contact(-1.0), std::domain_error);
  EXPECT_THROW(RoundedPunch(1e-3, 0.0, modulus), std::domain_error);
}

} // namespace asperity::theory::punches_test
