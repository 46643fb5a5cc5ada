#include "theory/persson/highest_peak.hpp"

#include "base/require.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::theory {
namespace {

double peaks_per_height(const ProfileMoments& moments, double area) {
  require_positive("moments.height", moments.height, "m^2");
  require_positive("moments.slope", moments.slope, "1");
  require_positive("area", area, "m^2");
  return area * moments.slope / moments.height /
         std::pow(2.0 * std::numbers::pi, 1.5);
}

} // namespace

double peaks_above(const ProfileMoments& moments, double area,
                   double reduced_height) {
  return peaks_per_height(moments, area) * reduced_height *
         std::exp(-0.5 * reduced_height * reduced_height);
}

double expected_highest(const ProfileMoments& moments, double area) {
  const double scale = peaks_per_height(moments, area);
  const double most = scale * std::exp(-0.5); // n(1)
  if (!(most >= 4.0))
    refuse_argument("area", area, "so large that 4 peaks are expected [m^2]");
  // n falls for x > 1; below that, all surfaces but a fraction e^-n(1) reach
  // higher.
  const auto reaches = [scale](double x) {
    return -std::expm1(-scale * x * std::exp(-0.5 * x * x));
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  return 1.0 + Rule::integrate(reaches, 1.0,
                               std::numeric_limits<double>::infinity(), 15,
                               1e-10);
}

} // namespace asperity::theory
