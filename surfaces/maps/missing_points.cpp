#include "surfaces/maps/missing_points.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace asperity::surfaces {
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
