#include "surfaces/maps/corrections.hpp"

#include "base/require.hpp"

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
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

/// A row; empty outside the map.
std::span<const double> row_of(const HeightMap& map, int row) {
  if (row < 0 || row >= map.grid.points_y)
    return {};
  return std::span(map.heights)
      .subspan(map.grid.index(0, row),
               static_cast<std::size_t>(map.grid.points_x));
}

/// The measured heights among the up to 8 neighbours.
void take_neighbours(const HeightMap& map, int row, std::size_t x,
                     std::vector<double>& neighbours) {
  neighbours.clear();
  for (int y = row - 1; y <= row + 1; ++y) {
    const std::span<const double> heights = row_of(map, y);
    const std::size_t end = std::min(x + 2, heights.size());
    for (std::size_t at = x - std::min<std::size_t>(x, 1); at < end; ++at)
      if ((at != x || y != row) && std::isfinite(heights[at]))
        neighbours.push_back(heights[at]);
  }
}

/// |h - m| of each point; 0 where there is nothing to compare, and NaN at
/// missing points.
std::vector<double> deviations_of(const HeightMap& map) {
  std::vector<double> deviations;
  deviations.reserve(map.heights.size());
  std::vector<double> neighbours;
  const auto width = static_cast<std::size_t>(map.grid.points_x);
  for (int row = 0; row < map.grid.points_y; ++row)
    for (std::size_t x = 0; x < width; ++x) {
      const double height = row_of(map, row)[x];
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

/// Robust standard deviation of the measured points.
double robust_scale(const std::vector<double>& deviations) {
  std::vector<double> measured;
  std::ranges::copy_if(deviations, std::back_inserter(measured),
                       [](double deviation) { return !std::isnan(deviation); });
  constexpr double gaussian = 1.4826; // of the median absolute deviation
  const double sum = std::accumulate(measured.begin(), measured.end(), 0.0);
  const auto count = static_cast<double>(measured.size());
  const double median = median_of(measured);
  return median > 0.0 ? gaussian * median
                      : std::sqrt(std::numbers::pi / 2.0) * sum / count;
}

/// Median difference of each row from the row before it; NaN if they have no
/// point in common or if there is none.
std::vector<double> steps_of_lines(const HeightMap& map) {
  std::vector<double> steps;
  std::vector<double> differences;
  for (int row = 0; row < map.grid.points_y; ++row) {
    const std::span<const double> before = row_of(map, row - 1);
    const std::span<const double> line = row_of(map, row);
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

void align_lines(HeightMap& map) {
  const auto width = static_cast<std::size_t>(map.grid.points_x);
  double offset = 0.0;
  std::size_t first = 0;
  for (const double step : steps_of_lines(map)) {
    if (!std::isnan(step))
      offset += step;
    for (std::size_t i = first; i < first + width; ++i)
      map.heights[i] -= offset;
    first += width;
  }
}

std::size_t mark_spikes(HeightMap& map, double threshold) {
  if (!(threshold >= 3.0))
    refuse_argument("threshold", threshold, ">= 3");
  const std::vector<double> deviations = deviations_of(map);
  const double limit = threshold * robust_scale(deviations);
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (deviations[i] > limit) {
      map.heights[i] = std::numeric_limits<double>::quiet_NaN();
      ++count;
    }
  return count;
}

FoundSpikes find_spikes(const HeightMap& map, double threshold, double least) {
  const std::vector<double> deviations = deviations_of(map);
  const double limit = std::max(least, threshold * robust_scale(deviations));
  const auto width = static_cast<std::size_t>(map.grid.points_x);
  FoundSpikes found;
  std::vector<double> neighbours;
  for (std::size_t i = 0; i < map.heights.size(); ++i) {
    if (!(deviations[i] > limit))
      continue;
    take_neighbours(map, static_cast<int>(i / width), i % width, neighbours);
    const auto near = std::ranges::count_if(neighbours, [&](double neighbour) {
      return std::abs(neighbour - map.heights[i]) < 0.5 * deviations[i];
    });
    if (near > 1)
      continue;
    ++found.count;
    found.highest = std::max(found.highest, deviations[i]);
  }
  return found;
}

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Laplace equation for the missing points.
class LaplaceProblem {
public:
  /// @param missing  indices of the points, ascending
  LaplaceProblem(const HeightMap& map, const std::vector<std::size_t>& missing)
      : grid_(map.grid),
        missing_(missing),
        heights_(map.heights),
        right_side_(
            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(missing.size()))) {
    const auto width = static_cast<std::size_t>(grid_.points_x);
    for (std::size_t i = 0; i < missing.size(); ++i)
      add_row(static_cast<int>(i), static_cast<int>(missing[i] % width),
              static_cast<int>(missing[i] / width));
  }

  /// Heights of the missing points, in the order of the map.
  Eigen::VectorXd solution() const {
    SparseMatrix matrix(right_side_.size(), right_side_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<SparseMatrix> factors(matrix);
    if (factors.info() != Eigen::Success)
      throw std::runtime_error("the equations of the missing points are "
                               "singular");
    return factors.solve(right_side_);
  }

private:
  void add_row(int row, int ix, int iy) {
    // Weights relative to that along x: only their ratio matters.
    const double ratio = grid_.spacing_x() / grid_.spacing_y();
    double diagonal = 0.0;
    for (const auto& [step_x, step_y] :
         {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
      diagonal += add_neighbour(row, ix + step_x, iy + step_y,
                                step_x != 0 ? 1.0 : ratio * ratio);
    entries_.emplace_back(row, row, diagonal);
  }

  /// Returns the weight of the neighbour, 0 outside the map.
  double add_neighbour(int row, int ix, int iy, double weight) {
    if (ix < 0 || iy < 0 || ix >= grid_.points_x || iy >= grid_.points_y)
      return 0.0;
    const std::size_t index = grid_.index(ix, iy);
    const auto place = std::ranges::lower_bound(missing_, index);
    if (place != missing_.end() && *place == index)
      entries_.emplace_back(row, static_cast<int>(place - missing_.begin()),
                            -weight);
    else
      right_side_[row] += weight * heights_[index];
    return weight;
  }

  const Grid& grid_;
  const std::vector<std::size_t>& missing_;
  const std::vector<double>& heights_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_side_;
};

} // namespace

std::size_t count_missing(const HeightMap& map) {
  return static_cast<std::size_t>(std::ranges::count_if(
      map.heights, [](double h) { return !std::isfinite(h); }));
}

void fill_missing(HeightMap& map) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (!std::isfinite(map.heights[i]))
      missing.push_back(i);
  if (missing.empty())
    return;
  if (missing.size() == map.grid.size())
    throw std::domain_error("one point of a map must be measured");
  const Eigen::VectorXd solution = LaplaceProblem(map, missing).solution();
  for (std::size_t i = 0; i < missing.size(); ++i)
    map.heights[missing[i]] = solution[static_cast<Eigen::Index>(i)];
}

} // namespace asperity::surfaces
