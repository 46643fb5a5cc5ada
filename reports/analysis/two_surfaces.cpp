#include "reports/analysis/two_surfaces.hpp"

#include "reports/numbers/estimate.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// On one grid, shells have the same bins, but each reports its own
// power-weighted wavevector. The nearest wavevector therefore identifies the
// shell.
double density_near(const results::SurfaceRecord& surface, double wavevector) {
  const auto nearest = std::min_element(
      surface.spectrum.begin(), surface.spectrum.end(),
      [&](const results::SpectrumPoint& a, const results::SpectrumPoint& b) {
        return std::abs(a.wavevector - wavevector) <
               std::abs(b.wavevector - wavevector);
      });
  return nearest == surface.spectrum.end() ? not_a_number : nearest->spectrum;
}

} // namespace

std::optional<results::SurfaceRecord>
sum_of_two_surfaces(const results::Result& result) {
  const bool is_pressed = std::any_of(
      result.methods.begin(), result.methods.end(),
      [](const results::MethodRecord& m) { return m.kind != "theory"; });
  if (is_pressed || result.surfaces.size() != 2)
    return std::nullopt;
  const results::SurfaceRecord& first = result.surfaces[0];
  const results::SurfaceRecord& second = result.surfaces[1];
  if (!(first.grid == second.grid) || !first.has_heights() ||
      !second.has_heights())
    return std::nullopt;
  surfaces::HeightMap map{first.grid, first.height_map().whole()};
  std::size_t at = 0;
  results::each_piece(second.height_map(), [&](std::span<const double> piece) {
    for (const double height : piece)
      map.heights[at++] += height;
  });
  const surfaces::Statistics numbers = surfaces::statistics(map);
  results::SurfaceRecord sum;
  sum.grid = map.grid;
  sum.rms_height = numbers.rms_height;
  sum.rms_slope = numbers.rms_slope;
  sum.rms_curvature = numbers.rms_curvature;
  sum.skewness = numbers.skewness;
  sum.kurtosis = numbers.kurtosis;
  sum.highest = numbers.highest;
  for (const surfaces::Shell& shell : surfaces::spectral_shells(map))
    sum.spectrum.push_back(
        {shell.wavevector, surfaces::shell_density(shell, map.grid)});
  sum.heights = std::move(map.heights);
  return sum;
}

double sum_spectrum_ratio(const results::Result& result,
                          const results::SurfaceRecord& sum, double low,
                          double high) {
  double total = 0.0;
  int shells = 0;
  for (const results::SpectrumPoint& point : sum.spectrum) {
    if (point.wavevector < low || point.wavevector > high)
      continue;
    const double both = density_near(result.surfaces[0], point.wavevector) +
                        density_near(result.surfaces[1], point.wavevector);
    if (!(both > 0.0)) // also true for NaN
      continue;
    total += point.spectrum / both;
    ++shells;
  }
  return shells > 0 ? total / shells : not_a_number;
}

} // namespace asperity::reports
