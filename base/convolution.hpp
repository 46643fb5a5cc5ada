#pragma once

// This file computes periodic convolutions of real fields on a Grid: forward
// transform, product with a real symbol, backward transform, in three passes
// over memory. It partitions the work into rows and blocks of columns.

#include "base/grid.hpp"

#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Columns that are transformed together: in single precision one row of them
/// is a cache line.
inline constexpr std::size_t block_width = 8;

/// The transforms of Convolution on some rows of a grid. It is immutable, so
/// that threads may share it.
template <class Real>
class PairTransforms {
public:
  using Complex = std::complex<Real>;

  /// @param rows      number of rows that are held, >= 1
  /// @param width     number of their values that are not always 0
  /// @param is_dense  a pair then has points_x complex values, so that the
  ///                  spectrum of an even number of rows fits into their
  ///                  memory; otherwise pairs are padded, which is faster
  PairTransforms(const Grid& grid, int rows, int width, bool is_dense = false);
  ~PairTransforms();
  PairTransforms(const PairTransforms&) = delete;
  PairTransforms& operator=(const PairTransforms&) = delete;

  /// Complex values of one pair of rows.
  std::size_t pair_stride() const { return pair_stride_; }

  /// Number of columns of the half spectrum, rounded up to blocks.
  std::size_t n_columns() const { return n_columns_; }

  /// Values of one column of a block.
  std::size_t column_stride() const { return column_stride_; }

  /// Number of complex values of all pairs.
  std::size_t spectrum_size() const;

  /// Transforms the rows in pairs.
  /// @param field     rows * width values
  /// @param rows      pair_stride() values of scratch memory for each thread
  /// @param spectrum  spectrum_size() values, overwritten
  void forward(std::span<const Real> field, int threads, Complex* rows,
               Complex* spectrum) const;

  /// The inverse; the spectrum is destroyed.
  void backward(Complex* spectrum, int threads, Complex* rows,
                std::span<Real> answer) const;

  /// Separates the rows of each pair, for n columns from the column `first`.
  /// @param stride  values from one column to the next, at least the number of
  ///                rows that are held, rounded up to an even number
  void separate(const Complex* spectrum, std::size_t first, std::size_t n,
                std::size_t stride, Complex* columns) const;

  /// The inverse of separate(): Z(k) = A(k) + i B(k), Z(-k) = conj A(k) + i
  /// conj B(k).
  void join(const Complex* columns, std::size_t first, std::size_t n,
            std::size_t stride, Complex* spectrum) const;

  /// Transforms a block of block_width * column_stride() values.
  void transform_columns(Complex* columns) const;

  /// The inverse, without a factor.
  void transform_columns_back(Complex* columns) const;

  /// Transforms a block of columns, multiplies and transforms back.
  /// @param columns     block_width * column_stride() values
  /// @param multiplier  as many values
  void convolve(Complex* columns, const Real* multiplier) const;

private:
  struct Plans;
  template <class DoPair>
  void each_pair(int threads, Complex* rows, Complex* spectrum,
                 const DoPair& do_pair) const;

  std::size_t width_; ///< points_x of the grid
  std::size_t held_rows_, held_width_;
  bool is_dense_; ///< without Z(-0) at the end of a pair
  std::size_t pair_stride_, n_columns_, column_stride_;
  std::unique_ptr<Plans> plans_;
};

/// Computes answer = F^-1 [ multiplier(q) F field ], with the sign of
/// RealFourier.
///
/// Rows are transformed in pairs: a + i b has the transform Z, and
///
///     A(k) = (Z(k) + conj Z(-k))/2,   B(k) = (Z(k) - conj Z(-k))/(2i),
///
/// which takes less time than two real transforms. Then blocks of columns are
/// gathered, with the pairs of rows separated, transformed, multiplied,
/// transformed back and scattered while they are in the cache; then the pairs
/// are transformed back. FFTW only sees single pairs and columns, so the result
/// is bitwise independent of the number of threads, and because of
/// FFTW_ESTIMATE it is the same in every run. Real is float or double.
///
/// A field may occupy the first rows and columns of the grid only and be 0
/// elsewhere, as in a convolution without periodic images: the rows of zeros
/// are then neither stored nor transformed, and the answer is computed on the
/// same part of the grid.
///
/// An instance is immutable: threads may share it, each with its own Scratch.
template <class Real>
class Convolution {
public:
  /// Multipliers in the order in which the columns are processed.
  class Symbol {
    friend class Convolution;
    std::vector<Real> values_;
  };

  /// Spectrum and buffers for one application at a time; allocated at first
  /// use.
  class Scratch {
    friend class Convolution;
    std::vector<std::complex<Real>> spectrum_;
    std::vector<std::complex<Real>> columns_; ///< one block per thread
    std::vector<std::complex<Real>> pairs_;   ///< one pair of rows per thread
  };

  /// @param threads  >= 1, used by each application
  explicit Convolution(const Grid& grid, int threads = 1);

  /// @param held  points of the part that a field occupies, at most those of
  ///              the grid; its lengths are not read
  Convolution(const Grid& grid, const Grid& held, int threads);
  ~Convolution();
  Convolution(Convolution&&) noexcept;
  Convolution& operator=(Convolution&&) noexcept;

  const Grid& grid() const { return grid_; }

  int threads() const { return threads_; }

  /// Arranges multipliers for use in apply().
  /// @param multiplier  grid.half_spectrum_size() values in the order of
  ///                    Grid::half_spectrum_size
  Symbol arranged(std::span<const double> multiplier) const;

  /// The value of the modes (jx, jy) and (jx, -jy), jx = 0..points_x/2, jy =
  /// 0..points_y/2. Threads call it at the same time.
  using MultiplierAt = std::function<double(int jx, int jy)>;

  /// The same for multipliers that are even in jy.
  Symbol arranged(const MultiplierAt& multiplier_at) const;

  /// Applies the convolution.
  /// @param field   held.size() values, by default grid.size()
  /// @param answer  as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real: a few ulp of the largest |multiplier|
  ///                times the rms of the field, at every wavevector
  void apply(std::span<const Real> field, const Symbol& symbol,
             Scratch& scratch, std::span<Real> answer) const;

private:
  void prepare(Scratch& scratch) const;
  void transform_columns(const Symbol& symbol, Scratch& scratch) const;

  Grid grid_;
  Grid held_;
  int threads_;
  std::unique_ptr<PairTransforms<Real>> transforms_;
};

extern template class PairTransforms<float>;
extern template class PairTransforms<double>;
extern template class Convolution<float>;
extern template class Convolution<double>;

} // namespace asperity
