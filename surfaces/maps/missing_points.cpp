#include "surfaces/maps/missing_points.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <stdexcept>

namespace asperity::surfaces {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The Laplace equation for the missing points.
class LaplaceProblem {
public:
  LaplaceProblem(const HeightMap& map, const std::vector<char>& is_missing)
      : map_(map), numbers_(is_missing.size(), -1) {
    int count = 0;
    for (std::size_t i = 0; i < is_missing.size(); ++i)
      if (is_missing[i] != 0)
        numbers_[i] = count++;
    right_side_ = Eigen::VectorXd::Zero(count);
    for (int iy = 0; iy < map.grid.points_y; ++iy)
      for (int ix = 0; ix < map.grid.points_x; ++ix)
        if (numbers_[map.grid.index(ix, iy)] >= 0)
          add_row(ix, iy);
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
  void add_row(int ix, int iy) {
    // Weights relative to that along x: only their ratio matters.
    const double ratio = map_.grid.spacing_x() / map_.grid.spacing_y();
    const int row = numbers_[map_.grid.index(ix, iy)];
    double diagonal = 0.0;
    for (const auto& [step_x, step_y] :
         {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
      diagonal += add_neighbour(row, ix + step_x, iy + step_y,
                                step_x != 0 ? 1.0 : ratio * ratio);
    entries_.emplace_back(row, row, diagonal);
  }

  /// Returns the weight of the neighbour, 0 outside the map.
  double add_neighbour(int row, int ix, int iy, double weight) {
    if (ix < 0 || iy < 0 || ix >= map_.grid.points_x ||
        iy >= map_.grid.points_y)
      return 0.0;
    const std::size_t index = map_.grid.index(ix, iy);
    if (numbers_[index] >= 0)
      entries_.emplace_back(row, numbers_[index], -weight);
    else
      right_side_[row] += weight * map_.heights[index];
    return weight;
  }

  const HeightMap& map_;
  std::vector<int> numbers_; ///< of the unknowns; -1: measured
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_side_;
};

} // namespace

void fill_missing(HeightMap& map, const std::vector<char>& is_missing) {
  if (is_missing.empty())
    return;
  if (is_missing.size() != map.heights.size())
    throw std::domain_error("is_missing must have one flag per point");
  const auto count = std::count_if(is_missing.begin(), is_missing.end(),
                                   [](char flag) { return flag != 0; });
  if (count == 0)
    return;
  if (static_cast<std::size_t>(count) == is_missing.size())
    throw std::domain_error("is_missing must leave one measured point");
  const Eigen::VectorXd filled = LaplaceProblem(map, is_missing).solution();
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < is_missing.size(); ++i)
    if (is_missing[i] != 0)
      map.heights[i] = filled[next++];
}

} // namespace asperity::surfaces
