#pragma once

// Which rows of a grid this process holds, and completes them by the rows
// beside them, which other processes may hold.

#include "base/grid.hpp"
#include "base/ranks/rank_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace asperity {

/// The rows of a grid that this process holds: all of them, or its share of the
/// rows that the ranks of a group hold together. Local fields have size()
/// values and begin with row first().
class SharedRows {
public:
  /// This process holds all rows.
  explicit SharedRows(const Grid& grid)
      : grid_(grid), bounds_{0, grid.points_y} {}

  /// @param ranks   must outlive this object
  /// @param bounds  rank r holds the rows bounds[r]..bounds[r+1]-1, at least
  ///                one; ranks.size() + 1 values from 0 to grid.points_y
  /// @throws std::domain_error  the bounds are not of this kind
  SharedRows(const Grid& grid, RankGroup& ranks, std::vector<int> bounds)
      : grid_(grid),
        ranks_(&ranks),
        bounds_(std::move(bounds)),
        own_(static_cast<std::size_t>(ranks.rank())) {
    if (bounds_.size() != static_cast<std::size_t>(ranks.size()) + 1 ||
        bounds_.front() != 0 || bounds_.back() != grid.points_y ||
        std::ranges::adjacent_find(bounds_, std::greater_equal<>()) !=
            bounds_.end())
      refuse_argument("the last of bounds", bounds_.back(),
                      "points_y, after increasing values from 0 for each rank");
  }

  const Grid& grid() const { return grid_; }

  /// The group of ranks, null if this process holds all rows.
  RankGroup* ranks() const { return ranks_; }

  const std::vector<int>& bounds() const { return bounds_; }

  int first() const { return bounds_[own_]; }

  int count() const { return bounds_[own_ + 1] - bounds_[own_]; }

  /// Number of nodes in the rows of this process.
  std::size_t size() const {
    return static_cast<std::size_t>(count()) * width();
  }

  std::size_t width() const { return static_cast<std::size_t>(grid_.points_x); }

  /// Copies the rows beside those of this process into the first and last row
  /// of an array, on the periodic continuation of the grid. Collective.
  /// @param rows  count() + 2 rows of equal length; the inner ones are read
  template <class Value>
  void fill_ghost_rows(std::span<Value> rows) const {
    const std::size_t n = rows.size() / (static_cast<std::size_t>(count()) + 2);
    const std::span<Value> first = rows.subspan(n, n);
    const std::span<Value> last = rows.last(2 * n).first(n);
    const std::span<Value> before = rows.first(n);
    const std::span<Value> after = rows.last(n);
    if (ranks_ == nullptr) {
      std::copy_n(last.data(), n, before.data());
      std::copy_n(first.data(), n, after.data());
    } else {
      ranks_->swap_edges({std::as_bytes(first), std::as_bytes(last),
                          std::as_writable_bytes(before),
                          std::as_writable_bytes(after)});
    }
  }

  /// The rows of this process of a whole field.
  template <class Value>
  std::span<const Value> own(std::span<const Value> whole) const {
    return whole.subspan(grid_.index(0, first()), size());
  }

  std::span<const double> own(const std::vector<double>& whole) const {
    return own(std::span<const double>(whole));
  }

  /// All rows of a field, on every rank. Collective.
  /// @param own_rows  size() values, or none
  std::vector<double> gathered(std::span<const double> own_rows) const {
    return values_of_ranks<double>(ranks_, own_rows);
  }

private:
  Grid grid_;
  RankGroup* ranks_ = nullptr;
  std::vector<int> bounds_;
  std::size_t own_ = 0; ///< number of this rank
};

/// Largest number of rows of which those of each rank but the last are a
/// multiple: the side of the largest cells of contact::BoundaryExtension whose
/// rows are shared on any grid.
inline constexpr int rows_in_cell = 8;

/// Rows of each rank but the last.
inline int rows_of_rank(const Grid& grid, int n_ranks) {
  const int cells = (grid.points_y + rows_in_cell - 1) / rows_in_cell;
  return (cells + n_ranks - 1) / n_ranks * rows_in_cell;
}

/// Whether so many ranks can share the rows of a grid: each has some.
inline bool can_share(const Grid& grid, int n_ranks) {
  return (n_ranks - 1) * rows_of_rank(grid, n_ranks) < grid.points_y;
}

/// Bounds of the rows of each rank, see SharedRows.
inline std::vector<int> row_bounds(const Grid& grid, int n_ranks) {
  std::vector<int> bounds;
  for (int r = 0; r <= n_ranks; ++r)
    bounds.push_back(std::min(grid.points_y, r * rows_of_rank(grid, n_ranks)));
  return bounds;
}

} // namespace asperity
