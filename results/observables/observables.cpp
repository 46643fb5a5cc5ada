#include "results/observables/observables.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "results/types/map_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asperity::results {
namespace {

void require_weights(std::span<const double> weights, std::size_t size) {
  if (!weights.empty())
    require_size("weights", weights.size(), size);
}

/// Returns the weighted mean of value_at(i).
template <class ValueAt>
double mean_over(std::size_t size, std::span<const double> weights, int threads,
                 const ValueAt& value_at) {
  require_weights(weights, size);
  return weighted_sum(weights, size, threads, value_at) /
         static_cast<double>(size);
}

/// Pairs of neighbours of which one is in contact, those across the border
/// included.
struct BoundaryPairCount {
  std::size_t along_x = 0, along_y = 0;

  BoundaryPairCount& operator+=(const BoundaryPairCount& other) {
    along_x += other.along_x;
    along_y += other.along_y;
    return *this;
  }
};

/// Counts the pairs of the nodes with their neighbours to the right and above.
BoundaryPairCount pairs_in_map(std::size_t width, const ContactNodes& nodes,
                               int threads) {
  return chunked_sum<BoundaryPairCount>(
      nodes.size(), threads, [&](std::size_t begin, std::size_t end) {
        BoundaryPairCount pairs;
        for (std::size_t i = begin; i < end;) {
          const std::size_t row = i / width * width;
          const std::size_t last = std::min(end, row + width);
          const std::size_t above =
              row + width < nodes.size() ? row + width : 0;
          for (; i < last; ++i) {
            const bool here = nodes.in_contact(i);
            const std::size_t right = i + 1 < row + width ? i + 1 : row;
            pairs.along_x += here != nodes.in_contact(right);
            pairs.along_y += here != nodes.in_contact(above + (i - row));
          }
        }
        return pairs;
      });
}

/// Adds the edges of nodes in contact at a free border which a periodic border
/// does not have: two for each pair at opposite borders.
void free_border(const Grid& grid, const ContactNodes& nodes,
                 BoundaryPairCount& pairs) {
  for (int iy = 0; iy < grid.points_y; ++iy)
    if (nodes.in_contact(grid.index(0, iy)) &&
        nodes.in_contact(grid.index(grid.points_x - 1, iy)))
      pairs.along_x += 2;
  for (int ix = 0; ix < grid.points_x; ++ix)
    if (nodes.in_contact(grid.index(ix, 0)) &&
        nodes.in_contact(grid.index(ix, grid.points_y - 1)))
      pairs.along_y += 2;
}

} // namespace

double weighted_mean(std::span<const double> field,
                     std::span<const double> weights, int threads) {
  require_size("field", field.size(), field.size());
  return mean_over(field.size(), weights, threads,
                   [&](std::size_t i) { return field[i]; });
}

double counted_area_fraction(const ContactNodes& nodes,
                             std::span<const double> weights, int threads) {
  require_size("nodes", nodes.size(), nodes.size());
  const double share =
      mean_over(nodes.size(), weights, threads,
                [&](std::size_t i) { return nodes.in_contact(i) ? 1.0 : 0.0; });
  return std::clamp(share, 0.0, 1.0); // the weights have mean 1 only up to
                                      // roundoff
}

double contact_perimeter(const Grid& grid, const ContactNodes& nodes,
                         Border border, int threads) {
  require_size("nodes", nodes.size(), grid.size());
  BoundaryPairCount pairs =
      pairs_in_map(static_cast<std::size_t>(grid.points_x), nodes, threads);
  if (border == Border::free)
    free_border(grid, nodes, pairs);
  return (static_cast<double>(pairs.along_x) * grid.spacing_y() +
          static_cast<double>(pairs.along_y) * grid.spacing_x()) /
         grid.area();
}

PressureCentre pressure_centre(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights, int threads) {
  require_size("pressure", pressure.size(), grid.size());
  require_weights(weights, pressure.size());
  const auto nx = static_cast<std::size_t>(grid.points_x);
  const int middle_x = grid.points_x / 2;
  const int middle_y = grid.points_y / 2;
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    SeveralSums<4> sums;
    for (std::size_t i = begin; i < end; ++i) {
      const double load = weight_of(weights, i) * pressure[i];
      const int ix = static_cast<int>(i % nx);
      const int iy = static_cast<int>(i / nx);
      sums.values[0] += load;
      sums.values[1] += load * (ix - middle_x);
      sums.values[2] += load * (iy - middle_y);
      sums.values[3] += std::abs(load);
    }
    return sums;
  };
  constexpr double least_share = 1e-6;
  const auto [force, moment_x, moment_y, magnitudes] =
      chunked_sum<SeveralSums<4>>(pressure.size(), threads, sums_of).values;
  if (!(force > least_share * magnitudes))
    return {};
  return {grid.spacing_x() * (moment_x / force),
          grid.spacing_y() * (moment_y / force)};
}

double elastic_energy(std::span<const double> pressure,
                      std::span<const double> displacement,
                      std::span<const double> weights, int threads) {
  require_size("pressure", pressure.size(), pressure.size());
  require_size("displacement", displacement.size(), pressure.size());
  return 0.5 * mean_over(pressure.size(), weights, threads, [&](std::size_t i) {
           return pressure[i] * displacement[i];
         });
}

double contact_energy(std::span<const double> pressure, double local_compliance,
                      std::span<const double> weights, int threads) {
  require_size("pressure", pressure.size(), pressure.size());
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  return 0.5 * local_compliance *
         mean_over(pressure.size(), weights, threads,
                   [&](std::size_t i) { return pressure[i] * pressure[i]; });
}

} // namespace asperity::results
