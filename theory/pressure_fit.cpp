#include "theory/pressure_fit.hpp"

#include "base/require.hpp"
#include "theory/pressure_distribution.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::theory {
namespace {

double squares(std::span<const PressureBin> bins, double pressure,
               double variance) {
  double sum = 0.0;
  for (const PressureBin& bin : bins) {
    const double misfit = bin.density - pressure_density(bin.contact_pressure,
                                                         pressure, variance);
    sum += misfit * misfit;
  }
  return sum;
}

} // namespace

// A scan finds the deepest valley, Brent's method its ground.
PressureFit fit_pressure_distribution(std::span<const PressureBin> bins,
                                      double nominal_pressure) {
  require_positive("nominal_pressure", nominal_pressure, "Pa");
  if (bins.empty())
    refuse_argument("number of bins", 0.0, ">= 1");
  for (const PressureBin& bin : bins) {
    require_positive("contact_pressure of a bin", bin.contact_pressure, "Pa");
    require_not_negative("density of a bin", bin.density, "1/Pa");
  }
  const double square = nominal_pressure * nominal_pressure;
  const auto misfit = [&](double log_ratio) {
    return squares(bins, nominal_pressure, square * std::exp(log_ratio));
  };
  const double widest = 8.0 * std::log(10.0), step = 0.2;
  double best = -widest, least = std::numeric_limits<double>::infinity();
  for (double at = -widest; at <= widest; at += step)
    if (const double value = misfit(at); value < least) {
      least = value;
      best = at;
    }
  const auto minimum = boost::math::tools::brent_find_minima(
      misfit, std::max(-widest, best - step), std::min(widest, best + step),
      std::numeric_limits<double>::digits / 2);
  const double variance = square * std::exp(minimum.first);
  return {std::abs(minimum.first) < widest - step, variance,
          area_fraction(nominal_pressure, variance)}; // (20), (21)
}

} // namespace asperity::theory
