#include "surfaces/maps/corrections.hpp"

#include "base/require.hpp"
#include "ranks/in_order.hpp"
#include "ranks/rank_sums.hpp"
#include "ranks/selection.hpp"
#include "ranks/workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

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

/// The rows of this process, and the rows beside them that are inside the map.
class RowsInMap {
public:
  RowsInMap(const SharedRows& rows, std::span<const double> heights)
      : rows_(rows), heights_(heights), beside_(rows.rows_beside(heights)) {}

  /// A row, numbered from the first of this process; empty outside the map.
  std::span<const double> operator[](int row) const {
    const int in_map = rows_.first() + row;
    if (in_map < 0 || in_map >= rows_.grid().points_y)
      return {};
    if (row < 0)
      return beside_.before;
    if (row == rows_.count())
      return beside_.after;
    return heights_.subspan(static_cast<std::size_t>(row) * rows_.width(),
                            rows_.width());
  }

private:
  const SharedRows& rows_;
  std::span<const double> heights_;
  SharedRows::RowsBeside beside_;
};

/// The measured heights among the up to 8 neighbours.
void take_neighbours(const RowsInMap& map, int row, std::size_t x,
                     std::vector<double>& neighbours) {
  neighbours.clear();
  for (int y = row - 1; y <= row + 1; ++y) {
    const std::span<const double> heights = map[y];
    const std::size_t end = std::min(x + 2, heights.size());
    for (std::size_t at = x - std::min<std::size_t>(x, 1); at < end; ++at)
      if ((at != x || y != row) && std::isfinite(heights[at]))
        neighbours.push_back(heights[at]);
  }
}

/// |h - m| of each point; 0 where there is nothing to compare, and NaN at
/// missing points.
std::vector<double> deviations_of(const SharedRows& rows,
                                  std::span<const double> heights) {
  const RowsInMap map(rows, heights);
  std::vector<double> deviations;
  deviations.reserve(heights.size());
  std::vector<double> neighbours;
  for (int row = 0; row < rows.count(); ++row)
    for (std::size_t x = 0; x < rows.width(); ++x) {
      const double height = map[row][x];
      take_neighbours(map, row, x, neighbours);
      if (std::isfinite(height) && neighbours.empty())
        deviations.push_back(0.0);
      else
        deviations.push_back(std::isfinite(height)
                                 ? std::abs(height - median_of(neighbours))
                                 : std::numeric_limits<double>::quiet_NaN());
    }
  return deviations;
}

/// The deviations of measured points, their sum and number.
struct DeviationSum {
  double sum = 0.0;
  std::size_t count = 0;
};

/// Robust standard deviation of the measured points of all ranks.
double robust_scale(const SharedRows& rows,
                    const std::vector<double>& deviations) {
  std::vector<double> measured;
  std::ranges::copy_if(deviations, std::back_inserter(measured),
                       [](double deviation) { return !std::isnan(deviation); });
  constexpr double gaussian = 1.4826; // of the median absolute deviation
  const double median = asperity::median(rows.ranks(), measured);
  if (median > 0.0)
    return gaussian * median;
  const DeviationSum all =
      in_order(&rows, DeviationSum{}, [&](DeviationSum& state) {
        for (const double deviation : measured)
          state.sum += deviation;
        state.count += measured.size();
      });
  return std::sqrt(std::numbers::pi / 2.0) * all.sum /
         static_cast<double>(all.count);
}

/// Median difference of each row of this process from the row before it; NaN if
/// they have no point in common or if there is none.
std::vector<double> steps_of_lines(const SharedRows& rows,
                                   std::span<const double> heights) {
  const RowsInMap map(rows, heights);
  std::vector<double> steps;
  std::vector<double> differences;
  for (int row = 0; row < rows.count(); ++row) {
    const std::span<const double> before = map[row - 1];
    const std::span<const double> line = map[row];
    differences.clear();
    for (std::size_t x = 0; x < before.size(); ++x)
      if (std::isfinite(before[x]) && std::isfinite(line[x]))
        differences.push_back(line[x] - before[x]);
    steps.push_back(median_of(differences));
  }
  return steps;
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

void crop(HeightMap& map, const PixelWindow& pixels) {
  HeightMap kept{pixels.grid, {}};
  for (int iy = 0; iy < pixels.grid.points_y; ++iy)
    for (int ix = 0; ix < pixels.grid.points_x; ++ix)
      kept.heights.push_back(map.heights[map.grid.index(pixels.first_x + ix,
                                                        pixels.first_y + iy)]);
  map = std::move(kept);
}

void align_lines(const SharedRows& rows, std::span<double> heights) {
  const std::vector<double> steps =
      values_of_ranks<double>(rows.ranks(), steps_of_lines(rows, heights));
  double offset = 0.0;
  for (int row = 0; row < rows.first() + rows.count(); ++row) {
    const double step = steps[static_cast<std::size_t>(row)];
    if (!std::isnan(step))
      offset += step;
    if (row >= rows.first())
      for (double& height : heights.subspan(
               static_cast<std::size_t>(row - rows.first()) * rows.width(),
               rows.width()))
        height -= offset;
  }
}

std::size_t mark_spikes(const SharedRows& rows, std::span<double> heights,
                        double threshold) {
  if (!(threshold >= 3.0))
    refuse_argument("threshold", threshold, ">= 3");
  const std::vector<double> deviations = deviations_of(rows, heights);
  const double limit = threshold * robust_scale(rows, deviations);
  std::size_t count = 0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (deviations[i] > limit) {
      heights[i] = std::numeric_limits<double>::quiet_NaN();
      ++count;
    }
  return total_count({1, rows}, count);
}

FoundSpikes find_spikes(const SharedRows& rows, std::span<const double> heights,
                        double threshold, double least) {
  const std::vector<double> deviations = deviations_of(rows, heights);
  const double limit =
      std::max(least, threshold * robust_scale(rows, deviations));
  const RowsInMap map(rows, heights);
  FoundSpikes found;
  std::vector<double> neighbours;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!(deviations[i] > limit))
      continue;
    take_neighbours(map, static_cast<int>(i / rows.width()), i % rows.width(),
                    neighbours);
    const auto near = std::ranges::count_if(neighbours, [&](double neighbour) {
      return std::abs(neighbour - heights[i]) < 0.5 * deviations[i];
    });
    if (near > 1)
      continue;
    ++found.count;
    found.highest = std::max(found.highest, deviations[i]);
  }
  found.count = total_count({1, rows}, found.count);
  found.highest = rank_max(rows.ranks(), found.highest);
  return found;
}

} // namespace asperity::surfaces
