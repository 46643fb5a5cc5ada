#pragma once

// Periodic convolutions of real fields on a Grid, and the two transforms of
// which they consist, for a field whose rows this process holds alone or shares
// with others.

#include "base/pair_transforms.hpp"
#include "ranks/shared_rows.hpp"

#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Adjacent columns of a half spectrum.
struct SpectrumColumns {
  std::size_t first = 0, count = 0;
};

/// The multipliers of the modes (jx, jy) and (jx, -jy) for jy = 0, 1, ...; at
/// most points_y/2 + 1 of them. Threads call it at the same time.
using EvenColumn = std::function<void(int jx, std::span<double> of_jy)>;

/// Computes answer = F^-1 [ multiplier(q) F field ], with the sign of
/// RealFourier and real multipliers that are even in q_x and q_y, in three
/// passes over memory: pairs of rows are transformed, blocks of columns are
/// gathered, transformed, multiplied, transformed back and scattered while they
/// are in the cache, and the pairs of rows are transformed back.
///
/// If ranks share the rows, each transforms its own pairs of rows and owns some
/// blocks of columns, which are exchanged in rounds of a few blocks per rank.
/// The answer has bitwise the same values on any number of ranks and threads.
/// Real is float or double.
///
/// A field may occupy the first rows and columns of the grid only and be 0
/// elsewhere, as in a convolution without periodic images: the rows of zeros
/// are then neither stored nor transformed nor sent, and the answer is computed
/// on the same part of the grid.
///
/// Each instance has scratch memory of its own, which copies do not take over:
/// use one per thread. Copies share the plans of the transforms.
template <class Real>
class Convolution {
public:
  /// Multipliers jy = 0..points_y/2 of the columns of this process, in the
  /// order in which they are used.
  class Symbol {
    friend class Convolution;
    std::vector<Real> values_;
  };

  /// @param rows     if a group of ranks shares them, all bounds but the last
  /// are
  ///                 even. The spectrum is then in the memory of the answer if
  ///                 points_x and the number of rows are even, so that a rank
  ///                 only holds the blocks of one round beside its fields; rows
  ///                 without a group have a padded spectrum, which is faster.
  /// @param threads  >= 1, used by each rank
  /// @throws std::domain_error  a bound is odd
  explicit Convolution(SharedRows rows, int threads = 1);

  /// @param rows  of the part that the fields occupy; the lengths of its grid
  ///              are not read
  /// @param grid  of the convolution, of at least as many points
  Convolution(SharedRows rows, const Grid& grid, int threads);

  int threads() const { return threads_; }

  const Grid& grid() const { return grid_; }

  /// The columns that this rank multiplies.
  SpectrumColumns columns() const;

  /// Finds the multipliers of this rank.
  Symbol arranged(const EvenColumn& multipliers) const;

  /// Applies the convolution. Collective.
  /// @param field   rows.size() values
  /// @param answer  as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real: a few ulp of the largest |multiplier|
  ///                times the rms of the field, at every wavevector
  void apply(std::span<const Real> field, const Symbol& symbol,
             std::span<Real> answer);

  /// The same with multipliers that are found when they are needed and not
  /// stored.
  void apply(std::span<const Real> field, const EvenColumn& multipliers,
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
  void free_scratch() { scratch_ = {}; }

private:
  /// Some adjacent blocks of columns.
  struct Blocks {
    std::size_t first = 0, count = 0;
  };

  bool is_alone() const { return n_ranks_ == 1; }

  /// The blocks of a rank in a round.
  Blocks blocks_of(std::size_t rank, std::size_t round) const;
  /// Rows of a rank, rounded up to pairs.
  std::size_t padded_rows(std::size_t rank) const;
  std::size_t columns_in(std::size_t block) const;
  /// Calls do_block(block, its columns in by_rows) for all blocks of a round.
  template <class DoBlock>
  void each_block(std::size_t round, const DoBlock& do_block);

  /// Values of a column of even multipliers.
  std::size_t half_height() const {
    return static_cast<std::size_t>(grid_.points_y) / 2 + 1;
  }

  /// Completes a column of which the first half_height() values are known.
  void mirror(Real* column) const;
  /// The multipliers of the column jx, divided by the number of nodes.
  void take_column(int jx, const EvenColumn& multipliers, Real* half) const;
  /// @param put_multipliers  called with the first of some own columns, their
  ///                         number and memory for a block, puts multipliers
  ///                         jy = 0..points_y/2 of each column there
  template <class PutMultipliers>
  void transform(std::span<const Real> field,
                 const PutMultipliers& put_multipliers, std::span<Real> answer);

  /// What happens to the columns: they come from the rows, and their values are
  /// returned to the rows.
  struct Ways {
    bool from_rows = true, to_rows = true;
  };

  /// The spectrum of the own rows, in the memory of the answer if it fits.
  Complex* prepared(std::span<Real> answer);
  /// Calls change(first own column, their number, columns, worker) for each
  /// block of own columns.
  template <class Change>
  void each_own_block(Complex* spectrum, const Ways& ways,
                      const Change& change);
  template <class Change>
  void each_block_alone(Complex* spectrum, const Ways& ways,
                        const Change& change);
  template <class Change>
  void change_own(const Blocks& own, const Ways& ways, const Change& change);
  /// Sets to 0 what is beyond the rows of the fields and the n columns of a
  /// block.
  void clear_rest(Complex* columns, std::size_t n) const;
  /// Calls copy(piece in by_ranks, place in the columns of a block, number of
  /// rows) for the n columns of one of n_blocks own blocks.
  template <class Copy>
  void each_piece(std::size_t block, std::size_t n_blocks, std::size_t n,
                  const Copy& copy);

  SharedRows rows_;
  Grid grid_; ///< of the convolution
  int threads_;
  std::shared_ptr<const PairTransforms<Real>> transforms_;
  std::size_t n_ranks_ = 1, own_ = 0;
  std::vector<std::size_t> first_blocks_; ///< of each rank, and their number
  std::size_t n_columns_;                 ///< of the half spectrum
  std::size_t blocks_a_round_ = 1, n_rounds_ = 1;
  bool is_dense_; ///< the spectrum fits into the memory of a field

  /// Memory of one application.
  struct Scratch {
    std::vector<Complex> spectrum; ///< of the own rows, if it is not dense
    std::vector<Complex> pairs;    ///< one pair per thread
    std::vector<Complex> by_rows;  ///< own rows of the columns of a round
    std::vector<Complex> by_ranks; ///< pieces of own columns of a round
    std::vector<Complex> columns;  ///< one block per thread
    std::vector<Real> multipliers; ///< likewise

    Scratch() = default;
    Scratch(Scratch&&) noexcept = default;
    Scratch& operator=(Scratch&&) noexcept = default;

    Scratch(const Scratch& /*other*/) {}

    Scratch& operator=(const Scratch& /*other*/) { return *this; }

    ~Scratch() = default;
  };

  Scratch scratch_;
};

extern template class Convolution<float>;
extern template class Convolution<double>;

} // namespace asperity
