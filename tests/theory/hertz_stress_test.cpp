// Tests of hertz_axis_stress() of theory/exact/hertz.hpp: it is the integral of
// Boussinesq's point loads, and the largest shear has the known value and
// depth.
#include "theory/exact/hertz.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace asperity::theory::hertz_stress_test {

const HertzContact contact = hertz_contact(2.0, 5e-3, 70e9);

// With rho^2 = r^2 + z^2, point loads p 2 pi r dr give on the axis
//
//   sigma_z = -int 3 z^3 p/rho^5 r dr,
//   sigma_r = int p [(1 - 2 nu) z/rho^3 - 3 z r^2/rho^5]/2 r dr.
//
// Tolerance: the quadrature's, whose integrand near the surface has a pole at
// depth z.
TEST(HertzAxisStress, IsTheSumOfBoussinesqsPointLoads) {
  const double a = contact.contact_radius;
  for (const double poisson : {0.0, 0.3, 0.5})
    for (const double ratio : {0.05, 0.48, 2.0, 19.9, 20.1, 300.0}) {
      const double z = ratio * a;
      const auto sum = [&](auto kernel) {
        return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
            [&](double t) { // r = a sqrt(1 - t^2): p = p_0 t, r dr = a^2 t dt
              const double square = a * a * (1.0 - t * t);
              return contact.peak_pressure * t * t * a * a *
                     kernel(square, std::sqrt(square + z * z));
            },
            0.0, 1.0, 15, 1e-13);
      };
      const double axial = sum([&](double, double rho) {
        return -3.0 * z * z * z / std::pow(rho, 5);
      });
      const double radial = sum([&](double square, double rho) {
        return 0.5 * ((1.0 - 2.0 * poisson) * z / std::pow(rho, 3) -
                      3.0 * z * square / std::pow(rho, 5));
      });

      const AxisStress stress = hertz_axis_stress(contact, z, poisson);

      EXPECT_NEAR(stress.axial / axial, 1.0, 1e-11) << ratio;
      EXPECT_NEAR(stress.radial, radial, 1e-11 * std::abs(axial)) << ratio;
    }
}

// The largest shear is 0.310 p_0 at a depth of 0.48 a for nu = 0.3 (Johnson's
// printed digits), and the stresses at the surface are -p_0 and -(1/2 + nu)
// p_0.
TEST(HertzAxisStress, HasItsLargestShearBelowTheSurface) {
  const double a = contact.contact_radius, peak = contact.peak_pressure;
  const auto deepest = boost::math::tools::brent_find_minima(
      [&](double z) {
        return -hertz_axis_stress(contact, z * a, 0.3).largest_shear() / peak;
      },
      0.0, 2.0, 26);

  EXPECT_NEAR(deepest.first, 0.48, 5e-3);
  EXPECT_NEAR(-deepest.second, 0.310, 5e-4);
  const AxisStress surface = hertz_axis_stress(contact, 0.0, 0.3);
  EXPECT_NEAR(surface.axial / peak, -1.0, 1e-15);
  EXPECT_NEAR(surface.radial / peak, -0.8, 1e-15);
}

TEST(HertzAxisStress, RefusesWhatIsOutsideItsRange) {
  EXPECT_THROW(hertz_axis_stress(contact, -1.0, 0.3), std::domain_error);
  EXPECT_THROW(hertz_axis_stress(contact, 1.0, 0.6), std::domain_error);
  EXPECT_THROW(hertz_axis_stress(hertz_contact(0.0, 1.0, 1.0), 1.0, 0.3),
               std::domain_error);
}

} // namespace asperity::theory::hertz_stress_test
