#include "results/observables/distributions.hpp"

#include "base/require.hpp"
#include "results/types/map_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::results {
namespace {

/// Returns the density of the first map over the nodes for which
/// is_counted(values, node) is true, normalised by the number of all nodes.
template <std::size_t n, class IsCounted>
Histogram histogram(const std::array<MapView, n>& maps, int bins,
                    const IsCounted& is_counted) {
  require_between("bins", bins, 1, 1e6, "1");
  Histogram result;
  each_piece(maps, [&](std::size_t, const auto& values) {
    for (std::size_t i = 0; i < values[0].size(); ++i)
      if (const double value = values[0][i]; is_counted(values, i)) {
        if (!std::isfinite(value))
          refuse_argument("field", value, "finite");
        result.highest = std::max(result.highest, value);
      }
  });
  if (!(result.highest > 0.0))
    return result;

  result.density.assign(static_cast<std::size_t>(bins), 0.0);
  const double one =
      1.0 / (static_cast<double>(maps[0].size()) * result.bin_width());
  each_piece(maps, [&](std::size_t, const auto& values) {
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      if (!is_counted(values, i))
        continue;
      const double position = std::max(0.0, values[0][i] / result.bin_width());
      const auto bin = std::min(static_cast<std::size_t>(position),
                                result.density.size() - 1);
      result.density[bin] += one;
    }
  });
  return result;
}

} // namespace

Histogram pressure_histogram(const MapView& pressure, int bins) {
  require_size("pressure", pressure.size(), pressure.size());
  return histogram(std::array{pressure}, bins,
                   [](const auto& values, std::size_t i) {
                     return mechanics::ContactCriterion{}.holds(values[0][i]);
                   });
}

Histogram gap_histogram(const MapView& gap, const MapView& pressure, int bins,
                        const mechanics::ContactCriterion& criterion) {
  require_size("gap", gap.size(), gap.size());
  require_size("pressure", pressure.size(), gap.size());
  return histogram(
      std::array{gap, pressure}, bins, [=](const auto& values, std::size_t i) {
        return !mechanics::ContactNodes(criterion, values[1], values[0])
                    .in_contact(i);
      });
}

} // namespace asperity::results
