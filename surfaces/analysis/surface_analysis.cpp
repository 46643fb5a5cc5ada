#include "surfaces/analysis/surface_analysis.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace asperity::surfaces {

MapAnalysis analyse_map(HeightMap map, bool is_periodic,
                        std::optional<double> tip_radius) {
  const Grid& grid = map.grid;
  require_between("points per side", std::min(grid.points_x, grid.points_y), 4,
                  1e6, "1");
  MapAnalysis result;
  result.is_periodic = is_periodic;
  result.spectrum = estimate_spectrum(map, is_periodic);
  result.heights = height_parameters(map, is_periodic);
  result.neighbours = local_differences(map, 1, 1, is_periodic);
  result.scales = scale_dependence(map, is_periodic);
  result.nayak =
      nayak_parameter(result.heights.sq * result.heights.sq, result.neighbours);
  result.range = reliable_range(result.spectrum, result.scales, tip_radius);
  const double high = result.range.tip_wavevector
                          ? std::min(*result.range.tip_wavevector,
                                     result.spectrum.wavevector_high)
                          : result.spectrum.wavevector_high;
  result.fit = fit_self_affine(
      rings_between(result.spectrum.rings, result.range.low, high), high);
  result.map = std::move(map);
  return result;
}

LineAnalysis analyse_line(LineScan line) {
  constexpr double per_decade = 8.0;
  LineAnalysis result;
  result.profile = profile_parameters(line);
  require_positive("rms height", result.profile.pq, "m");
  const std::vector<SpectrumRing> modes = line_spectrum(line);
  result.low = 2.0 * modes.front().wavevector;
  result.high = 0.5 * std::numbers::pi / line.spacing;
  const std::vector<SpectrumRing> trusted =
      rings_between(modes, result.low, std::numbers::pi / line.spacing);
  result.line_rows = joined_rings(trusted, per_decade);
  if (result.line_rows.size() >= 3)
    result.rows = isotropic_from_line(result.line_rows);
  result.line = std::move(line);
  return result;
}

std::vector<SpectrumRing> reliable_rows(const MapAnalysis& analysis) {
  constexpr double per_decade = 10.0;
  const ReliableRange& range = analysis.range;
  if (!(range.low < range.high)) // a ring may be at both
    return {};
  return joined_rings(
      rings_between(analysis.spectrum.rings, range.low, range.high),
      per_decade);
}

std::vector<SpectrumRing> reliable_rows(const LineAnalysis& analysis) {
  return rings_between(analysis.rows, analysis.low, analysis.high);
}

} // namespace asperity::surfaces
