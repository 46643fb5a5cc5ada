#include "surfaces/maps/corrections.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace asperity::surfaces {
namespace {

/// The median; the mean of the middle two for an even number, and NaN for none.
/// The order of the numbers changes.
double median_of(std::vector<double>& numbers) {
  if (numbers.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle =
      numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  if (numbers.size() % 2 == 1)
    return *middle;
  return 0.5 * (*middle + *std::max_element(numbers.begin(), middle));
}

/// First point and number of points with centres from `begin` on.
struct PixelRange {
  int first = 0;
  int count = 0;
};

PixelRange pixels_within(double begin, double length, double spacing,
                         int points, const char* side) {
  const double whole = spacing * points;
  if (begin < 0.0 || length <= 0.0 || begin + length > whole * (1.0 + 1e-6))
    throw std::domain_error(fmt::format(
        "crop: {:.6g} m from {:.6g} m along {} is not inside the map of {:.6g} "
        "m",
        length, begin, side, whole));
  const auto number = [&](double position) {
    return std::clamp(
        static_cast<int>(std::ceil(position / spacing - 0.5 - 1e-9)), 0,
        points);
  };
  const int first = number(begin);
  const int count = number(begin + length) - first;
  if (count < 2)
    throw std::domain_error(
        fmt::format("crop: {} point(s) remain along {}, but a map must have at "
                    "least two",
                    count, side));
  return {first, count};
}

/// The measured heights among the up to 8 neighbours.
void take_neighbours(const FlaggedMap& map, int ix, int iy,
                     std::vector<double>& heights) {
  const Grid& grid = map.map.grid;
  heights.clear();
  for (int y = std::max(iy - 1, 0); y <= std::min(iy + 1, grid.points_y - 1);
       ++y)
    for (int x = std::max(ix - 1, 0); x <= std::min(ix + 1, grid.points_x - 1);
         ++x)
      if ((x != ix || y != iy) && map.is_measured(grid.index(x, y)))
        heights.push_back(map.map.heights[grid.index(x, y)]);
}

/// |h - m| of each point; 0 where there is nothing to compare.
std::vector<double> deviations_of(const FlaggedMap& map) {
  const Grid& grid = map.map.grid;
  std::vector<double> deviations(grid.size(), 0.0);
  std::vector<double> neighbours;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const std::size_t index = grid.index(ix, iy);
      take_neighbours(map, ix, iy, neighbours);
      if (map.is_measured(index) && !neighbours.empty())
        deviations[index] =
            std::abs(map.map.heights[index] - median_of(neighbours));
    }
  return deviations;
}

/// Robust standard deviation of the measured points.
double robust_scale(const FlaggedMap& map,
                    const std::vector<double>& deviations) {
  std::vector<double> measured;
  double sum = 0.0;
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (map.is_measured(i)) {
      measured.push_back(deviations[i]);
      sum += deviations[i];
    }
  constexpr double gaussian = 1.4826; // of the median absolute deviation
  const double mean = sum / static_cast<double>(measured.size());
  const double median = median_of(measured);
  return median > 0.0 ? gaussian * median
                      : std::sqrt(std::numbers::pi / 2.0) * mean;
}

} // namespace

PixelWindow pixels_of(const Grid& grid, const mechanics::MapWindow& window) {
  const PixelRange x = pixels_within(window.x, window.length_x,
                                     grid.spacing_x(), grid.points_x, "x");
  const PixelRange y = pixels_within(window.y, window.length_y,
                                     grid.spacing_y(), grid.points_y, "y");
  return {x.first,
          y.first,
          {x.count, y.count, x.count * grid.spacing_x(),
           y.count * grid.spacing_y()}};
}

void crop(FlaggedMap& map, const PixelWindow& pixels) {
  const Grid old = map.map.grid;
  FlaggedMap kept;
  kept.map.grid = pixels.grid;
  for (int iy = 0; iy < pixels.grid.points_y; ++iy)
    for (int ix = 0; ix < pixels.grid.points_x; ++ix) {
      const std::size_t index =
          old.index(pixels.first_x + ix, pixels.first_y + iy);
      kept.map.heights.push_back(map.map.heights[index]);
      if (!map.is_missing.empty())
        kept.is_missing.push_back(map.is_missing[index]);
    }
  map = std::move(kept);
}

void align_lines(FlaggedMap& map) {
  const Grid& grid = map.map.grid;
  std::vector<double> before(map.map.heights.begin(),
                             map.map.heights.begin() + grid.points_x);
  std::vector<double> differences;
  double offset = 0.0;
  for (int iy = 1; iy < grid.points_y; ++iy) {
    differences.clear();
    for (int ix = 0; ix < grid.points_x; ++ix)
      if (map.is_measured(grid.index(ix, iy)) &&
          map.is_measured(grid.index(ix, iy - 1)))
        differences.push_back(map.map.heights[grid.index(ix, iy)] -
                              before[static_cast<std::size_t>(ix)]);
    if (!differences.empty())
      offset += median_of(differences);
    for (int ix = 0; ix < grid.points_x; ++ix) {
      double& height = map.map.heights[grid.index(ix, iy)];
      before[static_cast<std::size_t>(ix)] = height;
      height -= offset;
    }
  }
}

std::size_t mark_spikes(FlaggedMap& map, double threshold) {
  if (!(threshold >= 3.0))
    refuse_argument("threshold", threshold, ">= 3");
  const std::vector<double> deviations = deviations_of(map);
  const double limit = threshold * robust_scale(map, deviations);
  std::size_t count = 0;
  std::vector<char> flags = map.is_missing;
  flags.resize(deviations.size(), 0);
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (deviations[i] > limit) {
      flags[i] = 1;
      ++count;
    }
  if (count > 0)
    map.is_missing = std::move(flags);
  return count;
}

} // namespace asperity::surfaces
