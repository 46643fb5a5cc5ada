#pragma once

// This file computes the convolution of convolution.hpp, and the two transforms
// of which it consists, for a field whose rows are shared by several processes.

#include "base/convolution.hpp"

#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ranks/shared_rows.hpp"

namespace asperity {

/// Adjacent columns of a half spectrum.
struct SpectrumColumns {
  std::size_t first = 0, count = 0;
};

/// As Convolution, with bitwise the same answer on any number of ranks. Each
/// rank transforms its pairs of rows and owns some blocks of columns. The
/// columns are exchanged in rounds of a few blocks per rank, transformed,
/// multiplied, transformed back and returned. The spectrum of the own rows is
/// in the memory of the answer if points_x and the number of rows are even, so
/// that a rank only holds the blocks of one round beside its fields.
///
/// A field may occupy the first rows and columns of a larger grid only, as in
/// Convolution. The other rows, which are 0, are neither sent nor stored, but
/// the spectrum then has memory of its own.
template <class Real>
class SharedConvolution {
public:
  /// Multipliers of the columns of this rank, which are even in jy.
  class Symbol {
    friend class SharedConvolution;
    std::vector<Real> values_; ///< jy = 0..points_y/2 of each column
  };

  /// @param rows     of a group of ranks; must outlive this object. All bounds
  ///                 but the last are even.
  /// @param threads  >= 1, used by each rank
  /// @throws std::domain_error  the rows are of no group, or a bound is odd
  SharedConvolution(const SharedRows& rows, int threads);

  /// @param rows  of the part that the fields occupy; the lengths of its grid
  ///              are not read
  /// @param grid  of the convolution, of at least as many points
  SharedConvolution(const SharedRows& rows, const Grid& grid, int threads);
  ~SharedConvolution();
  SharedConvolution(const SharedConvolution&) = delete;
  SharedConvolution& operator=(const SharedConvolution&) = delete;

  int threads() const { return threads_; }

  const Grid& grid() const { return grid_; }

  using Columns = SpectrumColumns;

  /// The columns that this rank multiplies.
  Columns columns() const;

  /// The value of the modes (jx, jy) and (jx, -jy), jx = 0..points_x/2, jy =
  /// 0..points_y/2. Threads call it at the same time.
  using MultiplierAt = std::function<double(int jx, int jy)>;

  /// Finds the multipliers of this rank.
  Symbol arranged(const MultiplierAt& multiplier_at) const;

  /// Applies the convolution. Collective.
  /// @param field   rows.size() values
  /// @param answer  as many values, overwritten; may be `field`
  void apply(std::span<const Real> field, const Symbol& symbol,
             std::span<Real> answer);

  /// The same with multipliers that are found when they are needed and not
  /// stored.
  void apply(std::span<const Real> field, const MultiplierAt& multiplier_at,
             std::span<Real> answer);

  using Complex = std::complex<Real>;

  /// Column jx of the half spectrum, as points_y values by jy. Threads call it
  /// at the same time, each with other columns.
  using FillColumn = std::function<void(int jx, std::span<Complex> column)>;
  using TakeColumn =
      std::function<void(int jx, std::span<const Complex> column)>;

  /// The field with this half spectrum, by the backward transform of
  /// RealFourier. Collective.
  /// @param fill    called once for each column of this rank, with zeros;
  ///                columns 0 and points_x/2 must be those of a real field
  /// @param answer  rows.size() values, overwritten
  void synthesise(const FillColumn& fill, std::span<Real> answer);

  /// The half spectrum of a field, by the forward transform of RealFourier.
  /// Collective.
  /// @param field  rows.size() values
  /// @param take   called once for each column of this rank
  void analyse(std::span<const Real> field, const TakeColumn& take);

  /// Frees the memory of the spectrum and the buffers, which the next apply()
  /// allocates again.
  void free_scratch();

private:
  /// Some adjacent blocks of columns.
  struct Blocks {
    std::size_t first = 0, count = 0;
  };

  /// The blocks of a rank in a round.
  Blocks blocks_of(std::size_t rank, std::size_t round) const;
  /// Rows of a rank, rounded up to pairs.
  std::size_t padded_rows(std::size_t rank) const;
  std::size_t columns_in(std::size_t block) const;
  /// Calls do_block(block, its columns in by_rows_) for all blocks of a round.
  template <class DoBlock>
  void each_block(std::size_t round, const DoBlock& do_block);

  /// Values of a column of a symbol.
  std::size_t half_height() const {
    return static_cast<std::size_t>(grid_.points_y) / 2 + 1;
  }

  /// The multipliers of the own column k that are stored in a symbol.
  void take_column(std::size_t k, const MultiplierAt& multiplier_at,
                   Real* half) const;
  /// Calls take(k, half) for the multipliers of the own column k.
  template <class Take>
  void transform(std::span<const Real> field, const Take& take,
                 std::span<Real> answer);

  /// What happens to the columns in rounds: they come from the rows, and their
  /// values are returned to the rows.
  struct Ways {
    bool from_rows = true, to_rows = true;
  };

  /// The spectrum of the own rows, in the memory of the answer if it fits.
  Complex* prepared(std::span<Real> answer);
  /// Calls change(first own column, their number, columns, worker) for each
  /// block of own columns.
  template <class Change>
  void each_round(Complex* spectrum, const Ways& ways, const Change& change);
  template <class Change>
  void change_own(const Blocks& own, const Ways& ways, const Change& change);
  /// Calls copy(piece in by_ranks_, place in the columns of a block, number of
  /// rows) for the n columns of one of n_blocks own blocks.
  template <class Copy>
  void each_piece(std::size_t block, std::size_t n_blocks, std::size_t n,
                  const Copy& copy);

  const SharedRows& rows_;
  Grid grid_; ///< of the convolution
  int threads_;
  std::unique_ptr<PairTransforms<Real>> transforms_;
  std::size_t n_ranks_, own_;
  std::vector<std::size_t> first_blocks_; ///< of each rank, and their number
  std::size_t n_columns_;                 ///< of the half spectrum
  std::size_t blocks_a_round_, n_rounds_;
  bool is_dense_; ///< the spectrum fits into the memory of a field
  std::vector<Complex> spectrum_; ///< of the own rows, if it does not
  std::vector<Complex> pairs_;    ///< scratch of one pair per thread
  std::vector<Complex> by_rows_;  ///< own rows of the columns of a round
  std::vector<Complex> by_ranks_; ///< pieces of own columns of a round
  std::vector<Complex> columns_;  ///< one block per thread
  std::vector<Real> multipliers_; ///< likewise
};

extern template class SharedConvolution<float>;
extern template class SharedConvolution<double>;

} // namespace asperity
