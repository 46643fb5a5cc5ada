// Tests of theory/exact/elliptic_hertz.hpp: a sphere is Hertz's, and the
// pressure deforms the surface to the shape of the body.
#include "theory/exact/elliptic_hertz.hpp"
#include "theory/exact/hertz.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::elliptic_hertz_test {

using std::numbers::pi;

constexpr double modulus = 3e9, indentation = 2e-7;

/// One elliptic Hertzian contact, p = p_0 sqrt(1 - x^2/a^2 - y^2/b^2).
struct EllipticContact {
  double load = 0.0;          ///< F = (2 pi/3) a b p_0 [N]
  double major_radius = 0.0;  ///< a, along the smaller curvature [m]
  double minor_radius = 0.0;  ///< b <= a [m]
  double peak_pressure = 0.0; ///< p_0 [Pa]
};

/// The contact at an approach, from the factors.
EllipticContact elliptic_contact(double approach, double first_curvature,
                                 double second_curvature) {
  const double mean = 0.5 * (first_curvature + second_curvature);
  const EllipticFactors factors = elliptic_factors(
      0.5 * std::abs(first_curvature - second_curvature) / mean);
  const double stretch = 1.0 / std::sqrt(1.0 - factors.squared_eccentricity);
  const double product = approach / mean * factors.area_factor; // a b
  const double load = 4.0 / 3.0 * modulus * approach *
                      std::sqrt(approach / mean) * factors.load_factor;
  return {load, std::sqrt(product * stretch), std::sqrt(product / stretch),
          1.5 * load / (pi * product)};
}

// Equal curvatures give Hertz's sphere; nearly equal ones are close to it.
TEST(EllipticHertz, OfEqualCurvaturesIsASphere) {
  for (const double contrast : {0.0, 1e-9, 1e-6}) {
    const EllipticContact spot = elliptic_contact(
        indentation, 100.0 * (1.0 + contrast), 100.0 * (1.0 - contrast));
    const double radius = std::sqrt(indentation / 100.0);
    const HertzContact sphere =
        hertz_contact(hertz_load(radius, 0.01, modulus), 0.01, modulus);

    EXPECT_NEAR(spot.load / sphere.load, 1.0, 1e-14 + contrast);
    EXPECT_NEAR(spot.major_radius / radius, 1.0, 1e-14 + contrast);
    EXPECT_NEAR(spot.minor_radius / radius, 1.0, 1e-14 + contrast);
    EXPECT_NEAR(spot.peak_pressure / sphere.peak_pressure, 1.0,
                1e-14 + contrast);
  }
}

// Verifies int p/(pi E* r) = delta - (k_1 x^2 + k_2 y^2)/2 in the entire
// contact, by polar quadrature about (x, y): along a ray p^2 is a quadratic,
// and the integral of its root up to the contact boundary is elementary.
// Tolerance: 4 x 40 Gauss points in the angle.
TEST(EllipticHertz, PressureDeformsTheSurfaceToTheBody) {
  for (const double ratio : {1.0, 3.0, 40.0}) {
    const double flat = 100.0, steep = ratio * flat;
    const EllipticContact spot = elliptic_contact(indentation, steep, flat);
    const double a = spot.major_radius, b = spot.minor_radius;
    const auto ray = [&](double x, double y, double angle) {
      const double ex = std::cos(angle) / a, ey = std::sin(angle) / b;
      const double square = ex * ex + ey * ey;
      const double half = (ex * x / a + ey * y / b) / square;
      const double depth = 1.0 - x * x / a / a - y * y / b / b;
      const double reach = std::sqrt(depth / square + half * half);
      // int_0 sqrt(square (reach^2 - (s + half)^2)) ds up to the contact
      // boundary
      return 0.5 * std::sqrt(square) *
             (reach * reach * std::acos(half / reach) -
              half * std::sqrt(reach * reach - half * half));
    };
    for (const auto& [at_x, at_y] :
         {std::pair{0.0, 0.0}, {0.7, 0.0}, {0.0, 0.6}, {0.5, -0.5}}) {
      const double x = at_x * a, y = at_y * b;
      double displacement = 0.0;
      for (int quarter = 0; quarter < 64; ++quarter)
        displacement += boost::math::quadrature::gauss<double, 20>::integrate(
            [&](double angle) { return ray(x, y, angle); }, quarter * pi / 32.0,
            (quarter + 1) * pi / 32.0);
      displacement *= spot.peak_pressure / (pi * modulus);

      EXPECT_NEAR((displacement + 0.5 * (flat * x * x + steep * y * y)) /
                      indentation,
                  1.0, 1e-9)
          << ratio << ' ' << at_x << ' ' << at_y;
    }
  }
}

TEST(EllipticHertz, RefusesALine) {
  EXPECT_THROW(elliptic_factors(1.0), std::domain_error);
}

} // namespace asperity::theory::elliptic_hertz_test
