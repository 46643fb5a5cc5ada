#include "surfaces/analysis/local_differences.hpp"

#include "base/require.hpp"
#include "base/special_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity::surfaces {
namespace {

/// Mean of squares that is built line by line.
struct MeanSquare {
  double sum = 0.0;
  double count = 0.0;

  void add(double square, std::size_t number) {
    sum += square;
    count += static_cast<double>(number);
  }

  double value() const { return count > 0.0 ? sum / count : not_a_number; }
};

struct DifferenceSums {
  MeanSquare slope_x, slope_y, second_x, second_y, laplacian;
  double lowest_x = 0.0; ///< smallest second difference, not yet divided [m]
  double lowest_y = 0.0;
};

/// The rows that the differences at one row need, each with its columns
/// continued by lag_x on both sides if the map is periodic.
struct Rows {
  std::vector<double> below, here, above;
};

void copy_row(const HeightMap& map, int row, int margin,
              std::vector<double>& copy) {
  const int columns = map.grid.points_x;
  copy.clear();
  for (int i = -margin; i < columns + margin; ++i)
    copy.push_back(map.heights[map.grid.index((i + columns) % columns, row)]);
}

/// @param first, end  columns at which forward differences are defined
void add_along_x(const std::vector<double>& here, std::size_t lag,
                 std::size_t first, std::size_t end, DifferenceSums& sums) {
  double slope = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const double forward = here[i + lag] - here[i];
    slope += forward * forward;
  }
  sums.slope_x.add(slope, end - first);
  double second = 0.0;
  for (std::size_t i = lag; i + lag < here.size(); ++i) {
    const double bend = here[i + lag] - 2.0 * here[i] + here[i - lag];
    second += bend * bend;
    sums.lowest_x = std::min(sums.lowest_x, bend);
  }
  sums.second_x.add(second, here.size() - 2 * lag);
}

/// @param first, end  the columns of the map itself
void add_slope_along_y(const Rows& rows, std::size_t first, std::size_t end,
                       DifferenceSums& sums) {
  double slope = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const double forward = rows.above[i] - rows.here[i];
    slope += forward * forward;
  }
  sums.slope_y.add(slope, end - first);
}

void add_second_along_y(const Rows& rows, std::size_t first, std::size_t end,
                        DifferenceSums& sums) {
  double second = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const double bend = rows.above[i] - 2.0 * rows.here[i] + rows.below[i];
    second += bend * bend;
    sums.lowest_y = std::min(sums.lowest_y, bend);
  }
  sums.second_y.add(second, end - first);
}

void add_laplacian(const Rows& rows, std::size_t lag, double square_x,
                   double square_y, DifferenceSums& sums) {
  double laplacian = 0.0;
  for (std::size_t i = lag; i + lag < rows.here.size(); ++i) {
    const double here = 2.0 * rows.here[i];
    const double value =
        (rows.here[i + lag] - here + rows.here[i - lag]) / square_x +
        (rows.above[i] - here + rows.below[i]) / square_y;
    laplacian += value * value;
  }
  sums.laplacian.add(laplacian, rows.here.size() - 2 * lag);
}

void require_lag(const char* name, int lag, int points, bool is_periodic) {
  const int most = is_periodic ? points - 1 : (points - 1) / 2;
  require_between(name, lag, 1, most, "1");
}

} // namespace

double LocalDifferences::rms_slope() const {
  return std::sqrt(mean_square_slope_x + mean_square_slope_y);
}

double LocalDifferences::rms_curvature() const {
  return 0.5 * std::sqrt(mean_square_laplacian);
}

double LocalDifferences::distance() const {
  return std::max(distance_x, distance_y);
}

LocalDifferences local_differences(const HeightMap& map, int lag_x, int lag_y,
                                   bool is_periodic) {
  const Grid& grid = map.grid;
  require_lag("lag_x", lag_x, grid.points_x, is_periodic);
  require_lag("lag_y", lag_y, grid.points_y, is_periodic);
  LocalDifferences result;
  result.distance_x = lag_x * grid.spacing_x();
  result.distance_y = lag_y * grid.spacing_y();
  const double square_x = result.distance_x * result.distance_x;
  const double square_y = result.distance_y * result.distance_y;

  const int margin = is_periodic ? lag_x : 0;
  const auto lag = static_cast<std::size_t>(lag_x);
  const auto first = static_cast<std::size_t>(margin);
  const auto end = first + static_cast<std::size_t>(grid.points_x);
  DifferenceSums sums;
  Rows rows;
  for (int row = 0; row < grid.points_y; ++row) {
    copy_row(map, row, margin, rows.here);
    add_along_x(rows.here, lag, first, is_periodic ? end : end - lag, sums);
    if (!is_periodic && row + lag_y >= grid.points_y)
      continue;
    copy_row(map, (row + lag_y) % grid.points_y, margin, rows.above);
    add_slope_along_y(rows, first, end, sums);
    if (!is_periodic && row < lag_y)
      continue;
    copy_row(map, (row - lag_y + grid.points_y) % grid.points_y, margin,
             rows.below);
    add_second_along_y(rows, first, end, sums);
    add_laplacian(rows, lag, square_x, square_y, sums);
  }
  result.mean_square_slope_x = sums.slope_x.value() / square_x;
  result.mean_square_slope_y = sums.slope_y.value() / square_y;
  result.mean_square_second_x = sums.second_x.value() / (square_x * square_x);
  result.mean_square_second_y = sums.second_y.value() / (square_y * square_y);
  result.mean_square_laplacian = sums.laplacian.value();
  result.lowest_second =
      std::min(sums.lowest_x / square_x, sums.lowest_y / square_y);
  return result;
}

std::vector<LocalDifferences> scale_dependence(const HeightMap& map,
                                               bool is_periodic) {
  const Grid& grid = map.grid;
  if (grid.points_x < 4 || grid.points_y < 4)
    return {};
  const double spacing = std::max(grid.spacing_x(), grid.spacing_y());
  const double longest = 0.25 * std::min(grid.length_x, grid.length_y);
  constexpr double ratio = 1.25892541179416721; // ten per decade
  std::vector<LocalDifferences> scales;
  int before = 0;
  for (double multiple = 1.0; multiple * spacing <= longest * (1.0 + 1e-9);
       multiple = std::max(multiple * ratio, before + 1.0)) {
    before = static_cast<int>(std::lround(multiple));
    const double distance = before * spacing;
    const auto lag = [&](double step) {
      return std::max(1, static_cast<int>(std::lround(distance / step)));
    };
    scales.push_back(local_differences(map, lag(grid.spacing_x()),
                                       lag(grid.spacing_y()), is_periodic));
  }
  return scales;
}

double nayak_parameter(double mean_square_height,
                       const LocalDifferences& differences) {
  const double slope =
      0.5 * (differences.mean_square_slope_x + differences.mean_square_slope_y);
  const double second = 0.5 * (differences.mean_square_second_x +
                               differences.mean_square_second_y);
  return slope > 0.0 ? mean_square_height * second / (slope * slope)
                     : not_a_number;
}

} // namespace asperity::surfaces
