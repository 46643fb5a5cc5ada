#include "results/observables/distributions.hpp"

#include "base/require.hpp"
#include "results/types/map_size.hpp"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace asperity::results {
namespace {

/// Returns the density of the first map over the nodes for which
/// is_counted(values, node) is true, normalised by the number of all nodes.
template <std::size_t n, class IsCounted>
Histogram histogram(const std::array<MapView, n>& maps, int bins,
                    std::span<const double> weights,
                    const IsCounted& is_counted) {
  require_between("bins", bins, 1, 1e6, "1");
  const std::size_t size = maps[0].size();
  if (!weights.empty())
    require_size("weights", weights.size(), size);
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
  const double weight_unit =
      1.0 / (static_cast<double>(size) * result.bin_width());
  each_piece(maps, [&](std::size_t first, const auto& values) {
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      if (!is_counted(values, i))
        continue;
      const double position = std::max(0.0, values[0][i] / result.bin_width());
      const auto bin = std::min(static_cast<std::size_t>(position),
                                result.density.size() - 1);
      result.density[bin] +=
          weight_unit * (weights.empty() ? 1.0 : weights[first + i]);
    }
  });
  return result;
}

using Sets = boost::disjoint_sets<std::size_t*, std::size_t*>;

/// Joins each node in contact with its next neighbours in x and y.
void join_neighbours(const Grid& grid, std::span<const double> pressure,
                     Sets& sets) {
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const std::size_t here = grid.index(ix, iy);
      if (!(pressure[here] > 0.0))
        continue;
      const std::size_t right = grid.index((ix + 1) % grid.points_x, iy);
      const std::size_t above = grid.index(ix, (iy + 1) % grid.points_y);
      if (pressure[right] > 0.0)
        sets.union_set(here, right);
      if (pressure[above] > 0.0)
        sets.union_set(here, above);
    }
}

/// Renumbers the patches in descending order of area.
void sort_by_area(ContactPatches& patches) {
  std::vector<int> order(patches.areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return patches.areas[static_cast<std::size_t>(a)] >
           patches.areas[static_cast<std::size_t>(b)];
  });
  std::vector<int> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  for (int& patch : patches.patch_of_node)
    if (patch >= 0)
      patch = rank[static_cast<std::size_t>(patch)];
  std::sort(patches.areas.begin(), patches.areas.end(), std::greater<>());
}

} // namespace

Histogram pressure_histogram(const MapView& pressure, int bins,
                             std::span<const double> weights) {
  require_size("pressure", pressure.size(), pressure.size());
  return histogram(
      std::array{pressure}, bins, weights,
      [](const auto& values, std::size_t i) { return values[0][i] > 0.0; });
}

Histogram gap_histogram(const MapView& gap, const MapView& pressure, int bins,
                        std::span<const double> weights, double closed) {
  require_size("gap", gap.size(), gap.size());
  require_size("pressure", pressure.size(), gap.size());
  return histogram(std::array{gap, pressure}, bins, weights,
                   [=](const auto& values, std::size_t i) {
                     return !(values[1][i] > 0.0) || values[0][i] > closed;
                   });
}

ContactPatches contact_patches(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights) {
  require_size("pressure", pressure.size(), grid.size());
  if (!weights.empty())
    require_size("weights", weights.size(), grid.size());
  std::vector<std::size_t> rank(grid.size(), 0);
  std::vector<std::size_t> parent(grid.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  Sets sets(rank.data(), parent.data());
  join_neighbours(grid, pressure, sets);

  ContactPatches patches;
  patches.patch_of_node.assign(grid.size(), -1);
  std::vector<int> patch_of_root(grid.size(), -1);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!(pressure[i] > 0.0))
      continue;
    int& patch = patch_of_root[sets.find_set(i)];
    if (patch < 0) {
      patch = static_cast<int>(patches.areas.size());
      patches.areas.push_back(0.0);
    }
    patches.patch_of_node[i] = patch;
    patches.areas[static_cast<std::size_t>(patch)] +=
        grid.cell_area() * (weights.empty() ? 1.0 : weights[i]);
  }
  sort_by_area(patches);
  return patches;
}

} // namespace asperity::results
