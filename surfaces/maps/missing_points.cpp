#include "surfaces/maps/missing_points.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <stdexcept>
#include <utility>

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

} // namespace

void MissingPoints::take_flagged(std::span<const double> heights,
                                 std::vector<char> flags) {
  const std::size_t width = heights.size();
  const std::size_t begin = rows_++ * width;
  const auto keep = [&](bool is_beside, std::size_t x) {
    if (is_beside && flags[x] == 0)
      beside_[begin + x] = heights[x];
  };
  for (std::size_t x = 0; x < width; ++x) {
    const bool was_missing = !last_flags_.empty() && last_flags_[x] != 0;
    keep(was_missing, x);
    if (flags[x] == 0)
      continue;
    missing_.push_back(begin + x);
    keep(x > 0, x - std::min<std::size_t>(x, 1));
    keep(x + 1 < width, std::min(x + 1, width - 1));
    if (!last_flags_.empty() && !was_missing)
      beside_[begin - width + x] = last_heights_[x];
  }
  last_heights_.assign(heights.begin(), heights.end());
  last_flags_ = std::move(flags);
}

std::vector<FilledPoint> MissingPoints::filled() const {
  if (missing_.empty())
    return {};
  if (missing_.size() == grid_.size())
    throw std::domain_error("is_missing must leave one measured point");
  const Eigen::VectorXd heights =
      LaplaceProblem(grid_, missing_, beside_).solution();
  std::vector<FilledPoint> filled;
  filled.reserve(missing_.size());
  for (std::size_t i = 0; i < missing_.size(); ++i)
    filled.push_back({missing_[i], heights[static_cast<Eigen::Index>(i)]});
  return filled;
}

void fill_missing(HeightMap& map, const std::vector<char>& is_missing) {
  if (is_missing.empty())
    return;
  if (is_missing.size() != map.heights.size())
    throw std::domain_error("is_missing must have one flag per point");
  MissingPoints points(map.grid);
  const auto width = static_cast<std::size_t>(map.grid.points_x);
  for (std::size_t at = 0; at < map.heights.size(); at += width)
    points.take_row(std::span(map.heights).subspan(at, width),
                    [&](std::size_t x) { return is_missing[at + x] != 0; });
  for (const FilledPoint& point : points.filled())
    map.heights[point.index] = point.height;
}

} // namespace asperity::surfaces
