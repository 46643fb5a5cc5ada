#include "theory/persson/absorbed_flux.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

void check(const MovingBoundary& wall) {
  const std::size_t n = wall.time.size();
  if (n < 2 || wall.distance.size() != n || wall.rate.size() != n)
    refuse_argument("number of times", static_cast<double>(n),
                    ">= 2, and as many distances and rates");
  if (wall.time.front() != 0.0)
    refuse_argument("first time", wall.time.front(), "0");
  for (std::size_t i = 0; i < n; ++i) {
    require_positive("distance", wall.distance[i], "unit of stress");
    if (i > 0 && !(wall.time[i] > wall.time[i - 1]))
      refuse_argument("time", wall.time[i], "above the time before it");
  }
}

// 2 Psi after the time `elapsed`, for a boundary at the distance `away` from
// the source.
double twice_psi(double away, double elapsed, double rate) {
  const double slope = away / elapsed;
  return (rate - slope) * std::exp(-0.25 * away * slope) /
         std::sqrt(4.0 * std::numbers::pi * elapsed);
}

} // namespace

Absorption absorbed_flux(const MovingBoundary& wall) {
  check(wall);
  const std::size_t n = wall.time.size();
  std::vector<double> width(n); // trapezoidal weights, except at the last node
  for (std::size_t i = 0; i + 1 < n; ++i)
    width[i] = 0.5 * (wall.time[i + 1] - wall.time[i == 0 ? 0 : i - 1]);
  Absorption result{std::vector<double>(n, 0.0), std::vector<double>(n, 1.0)};
  std::vector<double>& flux = result.flux;
  for (std::size_t j = 1; j < n; ++j) {
    flux[j] = -twice_psi(wall.distance[j], wall.time[j], wall.rate[j]);
    for (std::size_t i = 1; i < j; ++i)
      if (flux[i] > 0.0)
        flux[j] += width[i] * flux[i] *
                   twice_psi(wall.distance[j] - wall.distance[i],
                             wall.time[j] - wall.time[i], wall.rate[j]);
    flux[j] = std::max(0.0, flux[j]);
    const double lost =
        0.5 * (flux[j] + flux[j - 1]) * (wall.time[j] - wall.time[j - 1]);
    result.survival[j] = std::max(0.0, result.survival[j - 1] - lost);
  }
  return result;
}

} // namespace asperity::theory
