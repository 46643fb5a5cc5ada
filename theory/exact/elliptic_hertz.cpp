#include "theory/exact/elliptic_hertz.hpp"

#include "base/require.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

namespace {

// The complete elliptic integrals at m = 1 - b^2/a^2.
struct Integrals {
  double first;  // K
  double second; // E
};

Integrals integrals(double squared_eccentricity) {
  const double modulus = std::sqrt(squared_eccentricity);
  return {boost::math::ellint_1(modulus), boost::math::ellint_2(modulus)};
}

double contrast_of(double m) {
  const double smallest = 1e-8; // the next term is of relative order m
  if (m < smallest)
    return 0.375 * m;
  const auto [first, second] = integrals(m);
  return ((2.0 - m) * second - 2.0 * (1.0 - m) * first) / (m * second);
}

} // namespace

EllipticFactors elliptic_factors(double curvature_contrast) {
  if (!(curvature_contrast >= 0.0 && curvature_contrast < 1.0))
    refuse_argument("curvature_contrast", curvature_contrast,
                    "at least 0 and below 1");
  if (curvature_contrast == 0.0)
    return {};
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double m) { return contrast_of(m) - curvature_contrast; }, 0.0,
      1.0 - 1e-16, boost::math::tools::eps_tolerance<double>(52), steps);
  const double m = 0.5 * (bracket.first + bracket.second);
  const auto [first, second] = integrals(m);
  const double stretch = 1.0 / std::sqrt(1.0 - m); // a/b
  return {m, 0.5 * pi * stretch * std::sqrt(second / first) / first,
          stretch * second / first};
}

} // namespace asperity::theory
