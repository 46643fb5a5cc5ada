#include "results/observables/observables.hpp"

#include "base/require.hpp"
#include "results/types/map_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::results {
namespace {

/// Returns the weighted mean of value_at(i).
template <class ValueAt>
double mean_over(std::size_t size, std::span<const double> weights,
                 const SharedRows* rows, ValueAt value_at) {
  if (!weights.empty())
    require_size("weights", weights.size(), size);
  const double sum = in_order(rows, 0.0, [&](double& so_far) {
    double own = so_far;
    for (std::size_t i = 0; i < size; ++i)
      own += weights.empty() ? value_at(i) : weights[i] * value_at(i);
    so_far = own;
  });
  return sum / static_cast<double>(all_nodes(rows, size));
}

/// Pairs of neighbours of which one is in contact, those across the border
/// included.
struct BoundaryPairCount {
  std::size_t along_x = 0, along_y = 0;
};

BoundaryPairCount pairs_in_map(const Grid& grid,
                               std::span<const double> pressure,
                               Border border) {
  const auto holds = [&](int ix, int iy) {
    return pressure[grid.index(ix, iy)] > 0.0;
  };
  const int nx = grid.points_x;
  const int ny = grid.points_y;
  BoundaryPairCount pairs;
  for (int iy = 0; iy < ny; ++iy)
    for (int ix = 0; ix < nx; ++ix) {
      if (ix + 1 < nx)
        pairs.along_x += holds(ix, iy) != holds(ix + 1, iy);
      if (iy + 1 < ny)
        pairs.along_y += holds(ix, iy) != holds(ix, iy + 1);
    }
  const auto across = [&](bool last, bool first) {
    return static_cast<std::size_t>(border == Border::periodic ? last != first
                                                               : last + first);
  };
  for (int iy = 0; iy < ny; ++iy)
    pairs.along_x += across(holds(nx - 1, iy), holds(0, iy));
  for (int ix = 0; ix < nx; ++ix)
    pairs.along_y += across(holds(ix, ny - 1), holds(ix, 0));
  return pairs;
}

/// The same on the rows of all ranks.
BoundaryPairCount pairs_in_rows(const SharedRows& rows,
                                std::span<const double> pressure) {
  const std::size_t nx = rows.width();
  const std::vector<double> after = rows.row_after(pressure);
  BoundaryPairCount own;
  for (std::size_t row = 0; row < pressure.size(); row += nx)
    for (std::size_t ix = 0; ix < nx; ++ix) {
      const bool here = pressure[row + ix] > 0.0;
      const std::size_t above = row + ix + nx;
      own.along_x += here != (pressure[row + (ix + 1) % nx] > 0.0);
      own.along_y += here != ((above < pressure.size() ? pressure[above]
                                                       : after[ix]) > 0.0);
    }
  return {sum_of_ranks(&rows, own.along_x), sum_of_ranks(&rows, own.along_y)};
}

} // namespace

double weighted_mean(std::span<const double> field,
                     std::span<const double> weights, const SharedRows* rows) {
  require_size("field", field.size(), field.size());
  return mean_over(field.size(), weights, rows,
                   [&](std::size_t i) { return field[i]; });
}

double counted_area_fraction(std::span<const double> pressure,
                             std::span<const double> weights,
                             const SharedRows* rows) {
  require_size("pressure", pressure.size(), pressure.size());
  const double share =
      mean_over(pressure.size(), weights, rows,
                [&](std::size_t i) { return pressure[i] > 0.0 ? 1.0 : 0.0; });
  return std::clamp(share, 0.0, 1.0); // the weights have mean 1 only up to
                                      // roundoff
}

double contact_perimeter(const Grid& grid, std::span<const double> pressure,
                         Border border, const SharedRows* rows) {
  require_size("pressure", pressure.size(),
               rows != nullptr ? rows->size() : grid.size());
  const BoundaryPairCount pairs = rows != nullptr
                                      ? pairs_in_rows(*rows, pressure)
                                      : pairs_in_map(grid, pressure, border);
  return (static_cast<double>(pairs.along_x) * grid.spacing_y() +
          static_cast<double>(pairs.along_y) * grid.spacing_x()) /
         grid.area();
}

double isotropic_perimeter(double contact_perimeter) {
  require_not_negative("contact_perimeter", contact_perimeter, "1/m");
  return 0.25 * std::numbers::pi * contact_perimeter;
}

PressureCentre pressure_centre(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights,
                               const SharedRows* rows) {
  const int first_row = rows != nullptr ? rows->first() : 0;
  const std::size_t size = rows != nullptr ? rows->size() : grid.size();
  require_size("pressure", pressure.size(), size);
  const auto nx = static_cast<std::size_t>(grid.points_x);
  const auto mean_of = [&](auto lever_of) {
    return mean_over(size, weights, rows, [&](std::size_t i) {
      return pressure[i] * lever_of(static_cast<int>(i % nx),
                                    first_row + static_cast<int>(i / nx));
    });
  };
  const double mean = mean_of([](int, int) { return 1.0; });
  if (!(mean > 0.0))
    return {};
  return {grid.spacing_x() / mean *
              mean_of([&](int ix, int) { return ix - grid.points_x / 2; }),
          grid.spacing_y() / mean *
              mean_of([&](int, int iy) { return iy - grid.points_y / 2; })};
}

double elastic_energy(std::span<const double> pressure,
                      std::span<const double> displacement,
                      std::span<const double> weights, const SharedRows* rows) {
  require_size("pressure", pressure.size(), pressure.size());
  require_size("displacement", displacement.size(), pressure.size());
  return 0.5 * mean_over(pressure.size(), weights, rows, [&](std::size_t i) {
           return pressure[i] * displacement[i];
         });
}

double contact_energy(std::span<const double> pressure, double local_compliance,
                      std::span<const double> weights, const SharedRows* rows) {
  require_size("pressure", pressure.size(), pressure.size());
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  return 0.5 * local_compliance *
         mean_over(pressure.size(), weights, rows,
                   [&](std::size_t i) { return pressure[i] * pressure[i]; });
}

} // namespace asperity::results
