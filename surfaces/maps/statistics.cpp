#include "surfaces/maps/statistics.hpp"

#include "base/require.hpp"
#include "ranks/in_order.hpp"
#include "ranks/one_rank.hpp"
#include "ranks/rank_sums.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::surfaces {
namespace {

/// Sums of powers of the heights above their mean.
struct Powers {
  double square = 0.0, cube = 0.0, fourth = 0.0;
};

/// Sums over the modes of a column.
struct ColumnSums {
  double square_slope = 0.0, square_laplacian = 0.0;
};

Powers powers_of(const SharedRows& rows, std::span<const double> heights,
                 double mean) {
  return in_order(&rows, Powers{}, [&](Powers& sum) {
    for (const double node : heights) {
      const double height = node - mean;
      sum.square += height * height;
      sum.cube += height * height * height;
      sum.fourth += height * height * height * height;
    }
  });
}

/// Adds moments and extreme values, which need no transform.
void add_heights(const SharedRows& rows, std::span<const double> heights,
                 Statistics& result) {
  const auto count = static_cast<double>(rows.grid().size());
  const double mean = mean_height(rows, heights);
  const Powers sums = powers_of(rows, heights, mean);
  const double square = sums.square / count;
  result.rms_height = std::sqrt(square);
  result.skewness = sums.cube / count / (square * result.rms_height);
  result.kurtosis = sums.fourth / count / (square * square);
  const auto [lowest, highest] =
      std::minmax_element(heights.begin(), heights.end());
  result.lowest = -rank_max(rows.ranks(), -*lowest) - mean;
  result.highest = rank_max(rows.ranks(), *highest) - mean;
}

} // namespace

Statistics statistics(const HeightMap& map) {
  return statistics(rows_of_one(map.grid), map.heights);
}

Statistics statistics(const SharedRows& rows, std::span<const double> heights,
                      int threads) {
  Statistics result;
  add_heights(rows, heights, result);
  const Grid& grid = rows.grid();
  std::vector<ColumnSums> columns(grid.half_spectrum_columns());
  each_column(
      rows, heights, threads, [&](int jx, std::span<const double> power) {
        ColumnSums& sums = columns[static_cast<std::size_t>(jx)];
        for (std::size_t jy = 0; jy < power.size(); ++jy) {
          const double q = mode_wavevector(grid, jx, static_cast<int>(jy));
          sums.square_slope += q * q * power[jy];
          sums.square_laplacian += q * q * (q * q) * power[jy];
        }
      });
  // The columns of other ranks are 0 here.
  const ColumnSums sums = in_order(&rows, ColumnSums{}, [&](ColumnSums& sum) {
    for (const ColumnSums& column : columns) {
      sum.square_slope += column.square_slope;
      sum.square_laplacian += column.square_laplacian;
    }
  });
  result.rms_slope = std::sqrt(sums.square_slope);
  result.rms_curvature = 0.5 * std::sqrt(sums.square_laplacian);
  return result;
}

double rms_height(const SharedRows& rows, std::span<const double> heights) {
  const Powers sums = powers_of(rows, heights, mean_height(rows, heights));
  return std::sqrt(sums.square / static_cast<double>(rows.grid().size()));
}

} // namespace asperity::surfaces
