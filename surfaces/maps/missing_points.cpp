#include "surfaces/maps/missing_points.hpp"

#include "ranks/rank_sums.hpp"
#include "ranks/workers.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Laplace equation for the missing points.
class LaplaceProblem {
public:
  /// @param missing  indices of the points, ascending
  /// @param beside   heights of their measured neighbours
  LaplaceProblem(const Grid& grid, const std::vector<std::size_t>& missing,
                 const std::unordered_map<std::size_t, double>& beside)
      : grid_(grid),
        missing_(missing),
        beside_(beside),
        right_side_(
            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(missing.size()))) {
    const auto width = static_cast<std::size_t>(grid.points_x);
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
      right_side_[row] += weight * beside_.at(index);
    return weight;
  }

  const Grid& grid_;
  const std::vector<std::size_t>& missing_;
  const std::unordered_map<std::size_t, double>& beside_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_side_;
};

/// A measured point.
struct KnownPoint {
  std::size_t index = 0; ///< on the grid
  double height = 0.0;   ///< [m]
};

/// The missing points of the rows of this process, in their order, and the
/// measured points of these rows and of the rows beside them that are
/// neighbours of missing points of this process.
struct MissingPoints {
  std::vector<std::size_t> indices;
  std::vector<KnownPoint> beside;
};

MissingPoints missing_points(const SharedRows& rows,
                             std::span<const double> heights) {
  MissingPoints points;
  const SharedRows::RowsBeside beside = rows.rows_beside(heights);
  const std::size_t width = rows.width();
  const std::size_t first = rows.grid().index(0, rows.first());
  const auto take = [&](std::size_t index, double height) {
    if (std::isfinite(height))
      points.beside.push_back({index, height});
  };
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isfinite(heights[i]))
      continue;
    const std::size_t index = first + i;
    const std::size_t x = i % width;
    points.indices.push_back(index);
    if (x > 0)
      take(index - 1, heights[i - 1]);
    if (x + 1 < width)
      take(index + 1, heights[i + 1]);
    if (index >= width)
      take(index - width, i >= width ? heights[i - width] : beside.before[x]);
    if (index + width < rows.grid().size())
      take(index + width,
           i + width < heights.size() ? heights[i + width] : beside.after[x]);
  }
  return points;
}

} // namespace

std::size_t count_missing(const SharedRows& rows,
                          std::span<const double> heights) {
  return total_count({1, rows},
                     static_cast<std::size_t>(std::ranges::count_if(
                         heights, [](double h) { return !std::isfinite(h); })));
}

void fill_missing(const SharedRows& rows, std::span<double> heights) {
  const MissingPoints own = missing_points(rows, heights);
  const auto indices = values_of_ranks<std::size_t>(rows.ranks(), own.indices);
  if (indices.empty())
    return;
  if (indices.size() == rows.grid().size())
    throw std::domain_error("one point of a map must be measured");
  std::unordered_map<std::size_t, double> beside;
  for (const auto& [index, height] :
       values_of_ranks<KnownPoint>(rows.ranks(), own.beside))
    beside[index] = height;
  const Eigen::VectorXd solution =
      LaplaceProblem(rows.grid(), indices, beside).solution();
  const std::size_t first = rows.grid().index(0, rows.first());
  auto place = std::ranges::lower_bound(indices, first) - indices.begin();
  for (const std::size_t index : own.indices)
    heights[index - first] = solution[place++];
}

} // namespace asperity::surfaces
