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
  double sum = 0.0, of_line = 0.0, count = 0.0;

  void add(double difference) {
    of_line += difference * difference;
    count += 1.0;
  }

  void end_line() {
    sum += of_line;
    of_line = 0.0;
  }

  double value() const { return count > 0.0 ? sum / count : not_a_number; }
};

/// The place of the point `lag` behind another one along a side; -1: it is
/// outside of the map.
int place_behind(int at, int lag, int points, bool is_periodic) {
  const int place = at + lag;
  return is_periodic                    ? (place + points) % points
         : place >= 0 && place < points ? place
                                        : -1;
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

  std::vector<int> left, right;
  for (int x = 0; x < grid.points_x; ++x) {
    left.push_back(place_behind(x, -lag_x, grid.points_x, is_periodic));
    right.push_back(place_behind(x, lag_x, grid.points_x, is_periodic));
  }
  MeanSquare slope_x, slope_y, second_x, second_y, laplacian;
  double lowest_x = 0.0, lowest_y = 0.0; // not yet divided [m]
  for (int y = 0; y < grid.points_y; ++y) {
    const int below = place_behind(y, -lag_y, grid.points_y, is_periodic);
    const int above = place_behind(y, lag_y, grid.points_y, is_periodic);
    for (int x = 0; x < grid.points_x; ++x) {
      const auto height = [&](int column, int row) {
        return map.heights[grid.index(column, row)];
      };
      const int before = left[static_cast<std::size_t>(x)];
      const int after = right[static_cast<std::size_t>(x)];
      const double here = height(x, y);
      double bend_x = 0.0, bend_y = 0.0;
      if (after >= 0)
        slope_x.add(height(after, y) - here);
      if (above >= 0)
        slope_y.add(height(x, above) - here);
      if (before >= 0 && after >= 0) {
        bend_x = height(after, y) - 2.0 * here + height(before, y);
        second_x.add(bend_x);
        lowest_x = std::min(lowest_x, bend_x);
      }
      if (below >= 0 && above >= 0) {
        bend_y = height(x, above) - 2.0 * here + height(x, below);
        second_y.add(bend_y);
        lowest_y = std::min(lowest_y, bend_y);
        if (before >= 0 && after >= 0)
          laplacian.add(bend_x / square_x + bend_y / square_y);
      }
    }
    for (MeanSquare* const sum :
         {&slope_x, &slope_y, &second_x, &second_y, &laplacian})
      sum->end_line();
  }
  result.mean_square_slope_x = slope_x.value() / square_x;
  result.mean_square_slope_y = slope_y.value() / square_y;
  result.mean_square_second_x = second_x.value() / (square_x * square_x);
  result.mean_square_second_y = second_y.value() / (square_y * square_y);
  result.mean_square_laplacian = laplacian.value();
  result.lowest_second = std::min(lowest_x / square_x, lowest_y / square_y);
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
