// Tests of tests/theory/hertz_stress.hpp: the stress is in balance and has the
// known values at the boundary and on the axis.
#include "tests/theory/hertz_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace asperity::theory::hertz_field_test {

constexpr double modulus = 70e9; // E*, Pa
const HertzContact contact = hertz_contact(2.0, 5e-3, modulus);
const double a = contact.contact_radius;
const double peak = contact.peak_pressure;

// Verifies d sigma_r/dr + d tau/dz + (sigma_r - sigma_theta)/r = 0 and d tau/dr
// + d sigma_z/dz + tau/r = 0. Tolerance: central differences over h = 1e-4 a,
// h^2 of a third derivative of some 100 p_0/a^3.
TEST(HertzStress, IsInBalance) {
  const double h = 1e-4 * a;
  const double nu = 0.3;
  for (const double r : {0.3 * a, 0.9 * a, 1.2 * a, 3.0 * a})
    for (const double z : {0.1 * a, 0.5 * a, 2.0 * a}) {
      const auto at = [&](double dr, double dz) {
        return hertz_stress(contact, r + dr, z + dz, nu);
      };
      const AxisymmetricStress here = at(0.0, 0.0);
      const double radial =
          (at(h, 0.0).radial - at(-h, 0.0).radial) / (2.0 * h) +
          (at(0.0, h).shear - at(0.0, -h).shear) / (2.0 * h) +
          (here.radial - here.hoop) / r;
      const double axial = (at(h, 0.0).shear - at(-h, 0.0).shear) / (2.0 * h) +
                           (at(0.0, h).axial - at(0.0, -h).axial) / (2.0 * h) +
                           here.shear / r;
      EXPECT_NEAR(radial * a / peak, 0.0, 1e-6) << r / a << " " << z / a;
      EXPECT_NEAR(axial * a / peak, 0.0, 1e-6) << r / a << " " << z / a;
    }
}

// At the surface the normal stress is the pressure and the shear is zero;
// outside the contact sigma_r = -sigma_theta = (1 - 2 nu)/3 p_0 a^2/r^2, the
// tension that cracks glass. Tolerance: roundoff.
TEST(HertzStress, SatisfiesTheSurfaceConditions) {
  for (const double r : {0.01, 0.5, 0.99, 1.0, 1.5, 4.0}) {
    const AxisymmetricStress surface = hertz_stress(contact, r * a, 0.0, 0.25);

    EXPECT_NEAR(surface.axial / peak, -hertz_pressure(contact, r * a) / peak,
                1e-7);
    EXPECT_NEAR(surface.shear / peak, 0.0, 1e-15);
    if (r >= 1.0) {
      const double tension = 0.5 / 3.0 / (r * r);
      EXPECT_NEAR(surface.radial / peak, tension, 1e-7) << r;
      EXPECT_NEAR(surface.hoop / peak, -tension, 1e-7) << r;
    }
  }
}

// On the axis the field is hertz_axis_stress, which has another formula, at any
// depth. Tolerance: roundoff; the field is even in r, so that (r/a)^2 of a
// curvature of some units adds nothing.
TEST(HertzStress, IsThatOfTheAxis) {
  for (const double nu : {-1.0, 0.0, 0.3, 0.5})
    for (const double z : {0.0, 0.05 * a, 0.48 * a, 3.0 * a, 5e4 * a})
      for (const double r : {0.0, 1e-9 * a}) {
        const AxisymmetricStress here = hertz_stress(contact, r, z, nu);
        const AxisStress axis = hertz_axis_stress(contact, z, nu);

        const double size = std::abs(axis.axial);
        EXPECT_NEAR(here.axial / size, axis.axial / size, 1e-14);
        EXPECT_NEAR(here.radial / size, axis.radial / size, 1e-14);
        EXPECT_NEAR(here.hoop / size, axis.radial / size, 1e-14);
      }
}

TEST(HertzStress, RefusesInvalidPositionsAndBodies) {
  EXPECT_THROW(hertz_stress(contact, -1e-6, 0.0, 0.3), std::domain_error);
  EXPECT_THROW(hertz_stress(contact, 0.0, -1e-6, 0.3), std::domain_error);
  EXPECT_THROW(hertz_stress(contact, 0.0, 0.0, 0.6), std::domain_error);
}

} // namespace asperity::theory::hertz_field_test
