#include "results/observables/observables.hpp"

#include "base/require.hpp"
#include "ranks/node_sums.hpp"
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
double mean_over(std::size_t size, std::span<const double> weights,
                 const Workers& workers, const ValueAt& value_at) {
  require_weights(weights, size);
  return weighted_sum(weights, size, workers, value_at) /
         static_cast<double>(workers.all_nodes(size));
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
/// @param after  the field of the row above the last one
BoundaryPairCount pairs_in_map(std::size_t width, const ContactNodes& nodes,
                               std::span<const double> after,
                               const Workers& workers) {
  return chunked_sum<BoundaryPairCount>(
      nodes.size(), workers, [&](std::size_t begin, std::size_t end) {
        BoundaryPairCount pairs;
        for (std::size_t i = begin; i < end;) {
          const std::size_t row = i / width * width;
          const std::size_t last = std::min(end, row + width);
          const std::span<const double> above =
              row + width < nodes.size() ? nodes.field().subspan(row + width)
                                         : after;
          for (; i < last; ++i) {
            const bool here = nodes.in_contact(i);
            const std::size_t right = i + 1 < row + width ? i + 1 : row;
            pairs.along_x += here != nodes.in_contact(right);
            pairs.along_y += here != nodes.criterion().holds(above[i - row]);
          }
        }
        return pairs;
      });
}

/// Adds the edges of nodes in contact at a free border which a periodic border
/// does not have: two for each pair at opposite borders.
void free_border(const Grid& grid, const ContactNodes& nodes,
                 const Workers& workers, BoundaryPairCount& pairs) {
  const SharedRows rows =
      workers.rows != nullptr ? *workers.rows : SharedRows(grid);
  const std::vector<double> after = rows.row_after(nodes.field());
  const bool ends = rows.first() + rows.count() == grid.points_y;
  std::size_t both_x = 0, both_y = 0;
  for (int iy = 0; iy < rows.count(); ++iy)
    both_x += nodes.in_contact(grid.index(0, iy)) &&
              nodes.in_contact(grid.index(grid.points_x - 1, iy));
  for (std::size_t ix = 0; ends && ix < rows.width(); ++ix)
    both_y += nodes.criterion().holds(after[ix]) &&
              nodes.in_contact(rows.size() - rows.width() + ix);
  pairs.along_x += 2 * total_count(workers, both_x);
  pairs.along_y += 2 * total_count(workers, both_y);
}

} // namespace

double weighted_mean(std::span<const double> field,
                     std::span<const double> weights, const Workers& workers) {
  require_size("field", field.size(), field.size());
  return mean_over(field.size(), weights, workers,
                   [&](std::size_t i) { return field[i]; });
}

double counted_area_fraction(const ContactNodes& nodes,
                             std::span<const double> weights,
                             const Workers& workers) {
  require_size("nodes", nodes.size(), nodes.size());
  const double share =
      mean_over(nodes.size(), weights, workers,
                [&](std::size_t i) { return nodes.in_contact(i) ? 1.0 : 0.0; });
  return std::clamp(share, 0.0, 1.0); // the weights have mean 1 only up to
                                      // roundoff
}

double contact_perimeter(const Grid& grid, const ContactNodes& nodes,
                         Border border, const Workers& workers) {
  const SharedRows* const rows = workers.rows;
  require_size("nodes", nodes.size(),
               rows != nullptr ? rows->size() : grid.size());
  const auto width = static_cast<std::size_t>(grid.points_x);
  BoundaryPairCount pairs =
      rows != nullptr
          ? pairs_in_map(width, nodes, rows->row_after(nodes.field()), workers)
          : pairs_in_map(width, nodes, nodes.field().first(width), workers);
  if (border == Border::free)
    free_border(grid, nodes, workers, pairs);
  return (static_cast<double>(pairs.along_x) * grid.spacing_y() +
          static_cast<double>(pairs.along_y) * grid.spacing_x()) /
         grid.area();
}

PressureCentre pressure_centre(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights,
                               const Workers& workers) {
  const SharedRows* const rows = workers.rows;
  const int first_row = rows != nullptr ? rows->first() : 0;
  require_size("pressure", pressure.size(),
               rows != nullptr ? rows->size() : grid.size());
  require_weights(weights, pressure.size());
  const auto nx = static_cast<std::size_t>(grid.points_x);
  const int middle_x = grid.points_x / 2;
  const int middle_y = grid.points_y / 2;
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    SeveralSums<3> sums;
    for (std::size_t i = begin; i < end; ++i) {
      const double load = weight_of(weights, i) * pressure[i];
      const int ix = static_cast<int>(i % nx);
      const int iy = first_row + static_cast<int>(i / nx);
      sums.values[0] += load;
      sums.values[1] += load * (ix - middle_x);
      sums.values[2] += load * (iy - middle_y);
    }
    return sums;
  };
  const auto [force, moment_x, moment_y] =
      chunked_sum<SeveralSums<3>>(pressure.size(), workers, sums_of).values;
  if (!(force > 0.0))
    return {};
  return {grid.spacing_x() * (moment_x / force),
          grid.spacing_y() * (moment_y / force)};
}

double elastic_energy(std::span<const double> pressure,
                      std::span<const double> displacement,
                      std::span<const double> weights, const Workers& workers) {
  require_size("pressure", pressure.size(), pressure.size());
  require_size("displacement", displacement.size(), pressure.size());
  return 0.5 * mean_over(pressure.size(), weights, workers, [&](std::size_t i) {
           return pressure[i] * displacement[i];
         });
}

double contact_energy(std::span<const double> pressure, double local_compliance,
                      std::span<const double> weights, const Workers& workers) {
  require_size("pressure", pressure.size(), pressure.size());
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  return 0.5 * local_compliance *
         mean_over(pressure.size(), weights, workers,
                   [&](std::size_t i) { return pressure[i] * pressure[i]; });
}

} // namespace asperity::results
