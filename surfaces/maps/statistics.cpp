#include "surfaces/maps/statistics.hpp"

#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace asperity::surfaces {
namespace {

/// Sums over the modes of a column.
struct ColumnSums {
  double square_slope = 0.0, square_laplacian = 0.0;
};

} // namespace

HeightMoments moments_of(std::span<const double> heights) {
  const auto count = static_cast<double>(heights.size());
  HeightMoments found;
  found.mean = std::accumulate(heights.begin(), heights.end(), 0.0) / count;
  double square = 0.0, cube = 0.0, fourth = 0.0;
  for (const double node : heights) {
    const double height = node - found.mean;
    found.mean_magnitude += std::abs(height);
    square += height * height;
    cube += height * height * height;
    fourth += height * height * height * height;
  }
  square /= count;
  found.mean_magnitude /= count;
  found.rms = std::sqrt(square);
  found.skewness = cube / count / (square * found.rms);
  found.kurtosis = fourth / count / (square * square);
  const auto [lowest, highest] = std::ranges::minmax_element(heights);
  found.lowest = *lowest - found.mean;
  found.highest = *highest - found.mean;
  return found;
}

Statistics statistics(const HeightMap& map) {
  const HeightMoments heights = moments_of(map.heights);
  Statistics result{.rms_height = heights.rms,
                    .skewness = heights.skewness,
                    .kurtosis = heights.kurtosis,
                    .highest = heights.highest,
                    .lowest = heights.lowest};
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

} // namespace asperity::surfaces
