#pragma once

// Which rows of a grid this process holds, and completes them by the rows
// beside them, which other processes may hold.

#include "base/grid.hpp"
#include "ranks/rank_group.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

namespace asperity {

/// The rows of a grid that this process holds: all of them, or its share of the
/// rows that the ranks of a group hold together. Local fields have size()
/// values and begin with row first().
class SharedRows {
public:
  /// This process holds all rows.
  explicit SharedRows(const Grid& grid);

  /// @param ranks   must outlive this object
  /// @param bounds  rank r holds the rows bounds[r]..bounds[r+1]-1, at least
  ///                one; ranks.size() + 1 values from 0 to grid.points_y
  /// @throws std::domain_error  the bounds are not of this kind
  SharedRows(const Grid& grid, RankGroup& ranks, std::vector<int> bounds);

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
      for (std::size_t i = 0; i < n; ++i) {
        before[i] = last[i];
        after[i] = first[i];
      }
    } else {
      ranks_->swap_edges({std::as_bytes(first), std::as_bytes(last),
                          std::as_writable_bytes(before),
                          std::as_writable_bytes(after)});
    }
  }

  /// The row after those of this process, on the periodic continuation of the
  /// grid. Collective.
  /// @param own  size() values
  std::vector<double> row_after(std::span<const double> own) const;

  /// The rows before and after those of this process.
  struct RowsBeside {
    std::vector<double> before, after;
  };

  /// The same on the periodic continuation of the grid. Collective.
  /// @param own  size() values
  RowsBeside rows_beside(std::span<const double> own) const;

  /// Some rows of a field, which other ranks may hold. Collective; each rank
  /// asks for its own rows.
  /// @param own    size() values
  /// @param first  of the rows
  /// @param count  of the rows, >= 0, inside the grid
  std::vector<double> rows_at(std::span<const double> own, int first,
                              int count) const;

  /// All rows of a field, on every rank. Collective.
  /// @param own  size() values
  std::vector<double> gathered(std::span<const double> own) const;

  /// Passes all values of a field to a function of rank 0, from the first row
  /// to the last, in pieces of at most 4 MB or one row. Collective.
  /// @param own   size() values
  /// @param take  not called on the other ranks
  void pass_to_rank_0(
      std::span<const double> own,
      const std::function<void(std::span<const double>)>& take) const;

  /// The rows of this process. Collective.
  /// @param all  grid().size() values on rank 0; not read on the others
  std::vector<double> scattered(std::span<const double> all) const;

  /// Rows of this process that the ranks of another division hold: row i of
  /// this grid is row i of the other.
  /// @param other  of the same ranks; its grid may have fewer or more rows
  /// @return       number of rows for each rank
  std::vector<std::size_t> rows_on(const SharedRows& other) const;

private:
  /// Place of the first node of a rank, and number of its nodes.
  std::size_t first_of(std::size_t rank) const {
    return static_cast<std::size_t>(bounds_[rank]) * width();
  }

  std::size_t size_of(std::size_t rank) const {
    return first_of(rank + 1) - first_of(rank);
  }

  std::vector<std::size_t> bytes_of_ranks() const;
  /// Sizes of which only that of rank 0 is not 0.
  std::vector<std::size_t> bytes_of_rank_0(std::size_t bytes) const;

  Grid grid_;
  RankGroup* ranks_ = nullptr;
  std::vector<int> bounds_;
  std::size_t own_ = 0; ///< number of this rank
};

} // namespace asperity
