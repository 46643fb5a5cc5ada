#pragma once

// The symbol of a convolution that is even in both directions, divided among
// ranks by columns.

#include "base/grid.hpp"
#include "ranks/convolution.hpp"
#include "ranks/rank_group.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace asperity::contact {

/// Some columns of a symbol that is real and even in q_x and q_y, as the
/// transform of a real and even kernel is: the values of jx = 0..points_x/2 and
/// jy = 0..points_y/2 are all. Each rank has the columns that it multiplies. It
/// is immutable.
class EvenSymbol {
public:
  /// The kernel at iy and ix = 0..points_x/2. Threads call it at the same time.
  using KernelRow = std::function<void(int iy, std::span<double> of_ix)>;

  /// Transforms a kernel: each rank computes and transforms some rows, and then
  /// its columns. Collective; the result is bitwise the same on any number of
  /// ranks and threads.
  /// @param grid   of the periodic convolution
  /// @param own    columns of this rank; those of all ranks are adjacent, in
  ///               their order, and all that there are
  /// @par Accuracy  roundoff of two one-dimensional transforms
  EvenSymbol(const Grid& grid, RankGroup& ranks, const KernelRow& kernel,
             SpectrumColumns own, int threads);

  /// A symbol whose columns are known.
  /// @param own  columns of this process
  EvenSymbol(const Grid& grid, const EvenColumn& columns, SpectrumColumns own,
             int threads);

  /// The part that a grid of half the points resolves. Collective.
  /// @param coarse  half the points of grid(), which are even
  /// @param own     columns of this rank, which others may have as well
  EvenSymbol coarsened(const Grid& coarse, RankGroup& ranks,
                       SpectrumColumns own) const;

  const Grid& grid() const { return grid_; }

  /// The values for jy = 0..points_y/2.
  /// @param jx  of a column of this rank
  std::span<const double> column(int jx) const {
    return std::span(values_).subspan(
        (static_cast<std::size_t>(jx) - own_.first) * height(), height());
  }

  /// The value (jx, 0) or (0, jy) on every rank. Collective.
  /// @param ranks  null for this process alone
  double value_on_all(int jx, int jy, RankGroup* ranks) const;

  /// The values of all columns of this process, one after the other.
  std::span<const double> values() const { return values_; }

private:
  EvenSymbol(const Grid& grid, SpectrumColumns own);

  /// Values of a column.
  std::size_t height() const {
    return static_cast<std::size_t>(grid_.points_y) / 2 + 1;
  }

  /// The transforms of the rows of this rank, column by column.
  std::vector<double> transformed_rows(const KernelRow& kernel, int first,
                                       int count, int threads) const;
  void transform_columns(std::span<const double> by_ranks,
                         std::span<const int> bounds, int threads);

  Grid grid_;
  SpectrumColumns own_;
  std::vector<double> values_; ///< height() of each own column
};

/// All columns of the half spectrum of a grid.
inline SpectrumColumns all_columns(const Grid& grid) {
  return {0, grid.half_spectrum_columns()};
}

} // namespace asperity::contact
