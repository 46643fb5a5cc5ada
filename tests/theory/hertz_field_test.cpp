// Tests of tests/theory/hertz_stress.hpp: the stress is in balance and has the
// known values at the boundary and on the axis; the displacement satisfies
// Hooke's law and has the known limits.
#include "tests/theory/hertz_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::hertz_field_test {

constexpr double modulus = 70e9; // E*, Pa
const HertzContact contact = hertz_contact(2.0, 5e-3, modulus);
const double a = contact.contact_radius;
const double peak = contact.peak_pressure;
const double scale = peak * a / modulus; // of a displacement

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

// Towards the axis the field tends to hertz_axis_stress. Tolerance: the field
// is even in r, so (r/a)^2 of a curvature of some units.
TEST(HertzStress, TendsToTheAxis) {
  for (const double nu : {0.0, 0.3, 0.5})
    for (const double z : {0.05 * a, 0.48 * a, 3.0 * a}) {
      const AxisymmetricStress near = hertz_stress(contact, 1e-3 * a, z, nu);
      const AxisStress axis = hertz_axis_stress(contact, z, nu);

      EXPECT_NEAR(near.axial / peak, axis.axial / peak, 5e-6);
      EXPECT_NEAR(near.radial / peak, axis.radial / peak, 5e-5);
      EXPECT_NEAR(near.hoop / peak, axis.radial / peak, 5e-5);
    }
}

// Each plane z = const carries the entire load: int -sigma_z 2 pi r dr = F.
// Tolerance: the midpoint rule in ln r, and the tail 3 F z^3/(2 pi r^5).
TEST(HertzStress, CarriesTheLoadAtEveryDepth) {
  for (const double z : {0.2 * a, 1.0 * a}) {
    double load = 0.0;
    const int n = 20000;
    const double low = std::log(1e-4);
    const double step = (std::log(1e3) - low) / n;
    for (int i = 0; i < n; ++i) {
      const double r = a * std::exp(low + (i + 0.5) * step);
      load -= hertz_stress(contact, r, z, 0.3).axial * 2.0 * std::numbers::pi *
              r * r * step;
    }

    EXPECT_NEAR(load / contact.load, 1.0, 1e-6);
  }
}

TEST(HertzStress, RefusesInvalidPositionsAndBodies) {
  EXPECT_THROW(hertz_stress(contact, -1e-6, 0.0, 0.3), std::domain_error);
  EXPECT_THROW(hertz_stress(contact, 0.0, -1e-6, 0.3), std::domain_error);
  EXPECT_THROW(hertz_stress(contact, 0.0, 0.0, 0.6), std::domain_error);
}

double shear_modulus(double poisson) {
  return 0.5 * modulus * (1.0 - poisson);
}

// Hooke's law on central differences of the displacement.
AxisymmetricStress stress_of_strain(double r, double z, double poisson) {
  const double h = 1e-4 * a;
  const auto at = [&](double dr, double dz) {
    return hertz_displacement_field(contact, r + dr, z + dz, poisson);
  };
  const double radial = (at(h, 0.0).radial - at(-h, 0.0).radial) / (2.0 * h);
  const double hoop = at(0.0, 0.0).radial / r;
  const double axial = (at(0.0, h).axial - at(0.0, -h).axial) / (2.0 * h);
  const double shear = (at(0.0, h).radial - at(0.0, -h).radial +
                        at(h, 0.0).axial - at(-h, 0.0).axial) /
                       (2.0 * h);
  const double mu = shear_modulus(poisson);
  const double lambda = 2.0 * mu * poisson / (1.0 - 2.0 * poisson);
  const double all = lambda * (radial + hoop + axial);
  return {all + 2.0 * mu * radial, all + 2.0 * mu * hoop,
          all + 2.0 * mu * axial, mu * shear};
}

// The strain of this displacement has the stress of Huber. Tolerance: central
// differences over h = 1e-4 a, h^2 of third derivatives of some 100 scale/a^3,
// times lambda = 8.2 E* (1 - nu)/2 at nu = 0.45.
TEST(HertzDisplacement, HasHubersStress) {
  for (const double poisson : {-0.3, 0.0, 0.3, 0.45})
    for (const double r : {0.02 * a, 0.3 * a, 0.9 * a, 1.2 * a, 3.0 * a})
      for (const double z : {0.1 * a, 0.5 * a, 2.0 * a, 9.0 * a}) {
        const AxisymmetricStress stress = hertz_stress(contact, r, z, poisson);

        const AxisymmetricStress found = stress_of_strain(r, z, poisson);

        EXPECT_NEAR(found.radial / peak, stress.radial / peak, 3e-6);
        EXPECT_NEAR(found.hoop / peak, stress.hoop / peak, 3e-6);
        EXPECT_NEAR(found.axial / peak, stress.axial / peak, 3e-6);
        EXPECT_NEAR(found.shear / peak, stress.shear / peak, 3e-6);
      }
}

// The displacement of an incompressible body has no divergence, the limit in
// which Hooke's law has no lambda. Tolerance: as above without lambda.
TEST(HertzDisplacement, ConservesTheVolumeOfAnIncompressibleBody) {
  const double h = 1e-4 * a;
  for (const double r : {0.3 * a, 1.2 * a})
    for (const double z : {0.2 * a, 1.0 * a}) {
      const auto at = [&](double dr, double dz) {
        return hertz_displacement_field(contact, r + dr, z + dz, 0.5);
      };
      const double volume =
          (at(h, 0.0).radial - at(-h, 0.0).radial) / (2.0 * h) +
          at(0.0, 0.0).radial / r +
          (at(0.0, h).axial - at(0.0, -h).axial) / (2.0 * h);

      EXPECT_NEAR(volume * a / scale, 0.0, 1e-6);
    }
}

// At the surface u_z is Hertz's displacement for any nu, and u_r, towards the
// axis, follows from the load within r: -(1 - 2 nu)/(4 pi mu) F(r)/r with F(r)
// = (2/3) pi a^2 p_0 [1 - (1 - r^2/a^2)^{3/2}]. Tolerance: roundoff, amplified
// by r^2/a^2 where hertz_displacement() subtracts, and by a/r where 1 - (1 -
// r^2/a^2)^{3/2} does.
TEST(HertzDisplacement, IsHertzsAtTheSurface) {
  for (const double poisson : {0.0, 0.3, 0.5})
    for (const double ratio : {0.0, 1e-3, 0.5, 0.99, 1.0, 1.01, 4.0, 500.0}) {
      const double r = ratio * a;
      const double inside = std::sqrt(std::fmax(0.0, 1.0 - ratio * ratio));
      const double load = 2.0 / 3.0 * std::numbers::pi * a * a * peak *
                          (1.0 - std::pow(inside, 3));

      const auto surface = hertz_displacement_field(contact, r, 0.0, poisson);

      EXPECT_NEAR(surface.axial / hertz_displacement(contact, r), 1.0,
                  (1.0 + ratio * ratio) * 1e-15);
      const double inwards =
          r > 0.0 ? (1.0 - 2.0 * poisson) * load /
                        (4.0 * std::numbers::pi * shear_modulus(poisson) * r)
                  : 0.0;
      const double rounding = r > 0.0 ? 1e-15 * (1.0 + 1.0 / ratio) : 0.0;
      EXPECT_NEAR(surface.radial / scale, -inwards / scale, rounding) << ratio;
    }
}

// Far away the displacement is Boussinesq's of a point load. Tolerance: the
// second moment of the pressure, 2 a^2/5, with a curvature of a few 1/rho^2:
// (a/rho)^2 of it.
TEST(HertzDisplacement, IsBoussinesqsFarAway) {
  for (const double poisson : {0.0, 0.3, 0.5})
    for (const double distance : {1e3, 1e6})
      for (const double angle : {0.1, 0.8, 1.5}) {
        const double rho = distance * a;
        const double r = rho * std::sin(angle);
        const double z = rho * std::cos(angle);
        const double point = contact.load / (4.0 * std::numbers::pi *
                                             shear_modulus(poisson) * rho);
        const double cosine = z / rho;

        const auto far = hertz_displacement_field(contact, r, z, poisson);

        const double tolerance = 1.0 / (distance * distance) +
                                 100.0 * std::numeric_limits<double>::epsilon();
        EXPECT_NEAR(far.axial / point, 2.0 * (1.0 - poisson) + cosine * cosine,
                    tolerance);
        EXPECT_NEAR(far.radial / point,
                    std::sin(angle) *
                        (cosine - (1.0 - 2.0 * poisson) / (1.0 + cosine)),
                    tolerance);
      }
}

TEST(HertzDisplacement, RefusesInvalidPositionsAndBodies) {
  EXPECT_THROW(hertz_displacement_field(contact, -1e-6, 0.0, 0.3),
               std::domain_error);
  EXPECT_THROW(hertz_displacement_field(contact, 0.0, 0.0, 0.6),
               std::domain_error);
  EXPECT_THROW(
      hertz_displacement_field(hertz_contact(0.0, 1.0, 1.0), 1.0, 1.0, 0.3),
      std::domain_error);
}

} // namespace asperity::theory::hertz_field_test
