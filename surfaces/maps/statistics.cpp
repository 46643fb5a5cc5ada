#include "surfaces/maps/statistics.hpp"

#include "base/require.hpp"
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

Powers powers_of(const HeightMap& map, double mean) {
  Powers sum;
  for (const double node : map.heights) {
    const double height = node - mean;
    sum.square += height * height;
    sum.cube += height * height * height;
    sum.fourth += height * height * height * height;
  }
  return sum;
}

/// Adds moments and extreme values, which need no transform.
void add_heights(const HeightMap& map, Statistics& result) {
  const auto count = static_cast<double>(map.grid.size());
  const double mean = mean_height(map);
  const Powers sums = powers_of(map, mean);
  const double square = sums.square / count;
  result.rms_height = std::sqrt(square);
  result.skewness = sums.cube / count / (square * result.rms_height);
  result.kurtosis = sums.fourth / count / (square * square);
  const auto [lowest, highest] =
      std::minmax_element(map.heights.begin(), map.heights.end());
  result.lowest = *lowest - mean;
  result.highest = *highest - mean;
}

} // namespace

Statistics statistics(const HeightMap& map) {
  Statistics result;
  add_heights(map, result);
  const Grid& grid = map.grid;
  std::vector<ColumnSums> columns(grid.half_spectrum_columns());
  each_column(map, [&](int jx, std::span<const double> power) {
    ColumnSums& sums = columns[static_cast<std::size_t>(jx)];
    for (std::size_t jy = 0; jy < power.size(); ++jy) {
      const double q = mode_wavevector(grid, jx, static_cast<int>(jy));
      sums.square_slope += q * q * power[jy];
      sums.square_laplacian += q * q * (q * q) * power[jy];
    }
  });
  ColumnSums sums;
  for (const ColumnSums& column : columns) {
    sums.square_slope += column.square_slope;
    sums.square_laplacian += column.square_laplacian;
  }
  result.rms_slope = std::sqrt(sums.square_slope);
  result.rms_curvature = 0.5 * std::sqrt(sums.square_laplacian);
  return result;
}

double rms_height(const HeightMap& map) {
  const Powers sums = powers_of(map, mean_height(map));
  return std::sqrt(sums.square / static_cast<double>(map.grid.size()));
}

} // namespace asperity::surfaces
