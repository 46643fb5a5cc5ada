#pragma once

// Periodic convolutions of real fields on a Grid, and the two transforms of
// which they consist, for a field whose rows this process holds alone or shares
// with others.

#include "base/pair_transforms.hpp"
#include "base/ranks/shared_rows.hpp"
#include "base/ranks/slab_transforms.hpp"

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// The multipliers of the modes (jx, jy) and (jx, -jy) for jy = 0, 1, ...; at
/// most points_y/2 + 1 of them. Threads call it at the same time.
using EvenColumn = std::function<void(int jx, std::span<double> of_jy)>;

/// Computes answer = F^-1 [ multiplier(q) F field ], with the sign of
/// RealFourier and real multipliers that are even in q_x and q_y. A process
/// that holds all rows does it in three passes over memory: pairs of rows are
/// transformed, blocks of columns are gathered, transformed, multiplied,
/// transformed back and scattered while they are in the cache, and the pairs of
/// rows are transformed back; the bits do not depend on the number of threads.
/// If ranks share the rows, the transforms are those of the group
/// (slab_transforms.hpp), and each rank multiplies some columns. Real is float
/// or double.
///
/// A field of one process may occupy the first rows and columns of the grid
/// only and be 0 elsewhere, as in a convolution without periodic images: the
/// rows of zeros are then neither stored nor transformed, and the answer is
/// computed on the same part of the grid.
///
/// The spectrum of one process is in the memory of the answer. Of a field that
/// occupies half of a line, half of the spectrum is in scratch memory, and of
/// one with an odd number of rows all of it.
///
/// Each instance has scratch memory of its own, which copies do not take over:
/// use one per thread. Copies share the plans of the transforms, and on ranks
/// also the memory of the spectrum.
template <class Real>
class Convolution {
public:
  /// Multipliers jy = 0..points_y/2 of the columns of this process, in the
  /// order in which they are used.
  class Symbol {
    friend class Convolution;
    std::vector<Real> values_;
  };

  /// @param threads  >= 1
  explicit Convolution(const Grid& grid, int threads = 1);

  /// @param rows  of row_bounds(), or all
  explicit Convolution(const SharedRows& rows, int threads = 1);

  /// @param held  of the part that the fields occupy; its lengths are not read
  /// @param grid  of the convolution, of at least as many points
  Convolution(const Grid& held, const Grid& grid, int threads);

  int threads() const { return threads_; }

  const Grid& grid() const { return grid_; }

  /// The columns that this rank multiplies.
  SpectrumColumns columns() const { return columns_; }

  /// Finds the multipliers of this rank.
  Symbol arranged(const EvenColumn& multipliers) const;

  /// Applies the convolution. Collective.
  /// @param field   of the rows of this process
  /// @param answer  as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real: a few ulp of the largest |multiplier|
  ///                times the rms of the field, at every wavevector
  void apply(std::span<const Real> field, const Symbol& symbol,
             std::span<Real> answer);

  /// The same with multipliers that are found when they are needed and not
  /// stored.
  /// @param lent  memory that is used in place of own scratch memory for what
  ///              the answer cannot hold, if it is large enough: as large as a
  ///              field on a quarter of a grid of multiples of 16 points. It
  ///              may be that of the field, which is then lost.
  void apply(std::span<const Real> field, const EvenColumn& multipliers,
             std::span<Real> answer, std::span<std::byte> lent = {});

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
  /// @param answer  of the rows of this process, overwritten
  void synthesise(const FillColumn& fill, std::span<Real> answer);

  /// The half spectrum of a field, by the forward transform of RealFourier.
  /// Collective.
  /// @param field  of the rows of this process
  /// @param take   called once for each column of this rank
  void analyse(std::span<const Real> field, const TakeColumn& take);

  using ChangeColumn = std::function<void(int jx, std::span<Complex> column)>;

  /// Transforms a field, changes each column of its half spectrum and
  /// transforms back, without a factor, where all rows are in this process.
  /// @param change  called once for each column; threads call it at the same
  ///                time
  /// @param answer  as many values, overwritten; may be `field`
  void change(std::span<const Real> field, const ChangeColumn& change,
              std::span<Real> answer);

private:
  std::size_t height() const {
    return static_cast<std::size_t>(grid_.points_y);
  }

  /// Values of a column of even multipliers.
  std::size_t half_height() const { return height() / 2 + 1; }

  /// Completes a column of which the first half_height() values are known.
  void mirror(Real* column) const;
  /// The multipliers of the column jx, divided by the number of nodes.
  void take_column(int jx, const EvenColumn& multipliers, Real* half) const;
  /// @param put_multipliers  called with the number of an own column and
  /// memory,
  ///                         puts multipliers jy = 0..points_y/2 there
  template <class PutMultipliers>
  void transform(std::span<const Real> field,
                 const PutMultipliers& put_multipliers, std::span<Real> answer,
                 std::span<std::byte> lent);

  /// What happens to the columns: they come from the rows, and their values are
  /// returned to the rows.
  struct Ways {
    bool from_rows = true, to_rows = true;
  };

  using Spectrum = typename PairTransforms<Real>::Spectrum;

  void prepare();
  /// In the memory of the answer as far as it holds a spectrum.
  Spectrum spectrum_in(std::span<Real> answer, std::span<std::byte> lent = {});
  /// Calls change(first own column, their number, columns, worker) for each
  /// block of columns of this process alone.
  template <class Change>
  void each_block(const Spectrum& spectrum, const Ways& ways,
                  const Change& change);
  /// Calls change(own column, column) for each column of this rank.
  template <class Change>
  void each_slab_column(const Change& change);
  /// Sets to 0 what is beyond the rows of the fields and the n columns of a
  /// block.
  void clear_rest(Complex* columns, std::size_t n) const;

  Grid held_; ///< points of the fields
  Grid grid_; ///< of the convolution
  int threads_;
  SpectrumColumns columns_;
  std::shared_ptr<const PairTransforms<Real>> transforms_; ///< null on ranks
  std::shared_ptr<SlabTransforms<Real>> slabs_;            ///< on ranks

  /// Memory of one application.
  struct Scratch {
    std::vector<Complex> beyond;   ///< modes that no answer holds
    std::vector<Complex> pairs;    ///< one pair per thread
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
