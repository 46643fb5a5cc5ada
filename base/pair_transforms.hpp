#pragma once

// The two passes of a transform of a real field on a Grid, by pairs of rows and
// by blocks of columns, and their inverses.

#include "base/grid.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Columns that are transformed together: in single precision one row of them
/// is a cache line.
inline constexpr std::size_t block_width = 8;

/// The transforms of Convolution (base/ranks/convolution.hpp) on some rows of a
/// grid. It is immutable, so that threads may share it.
///
/// Rows are transformed in pairs: a + i b has the transform Z, and
///
///     A(k) = (Z(k) + conj Z(-k))/2,   B(k) = (Z(k) - conj Z(-k))/(2i),
///
/// which takes less time than two real transforms. FFTW only sees single pairs
/// and single blocks of columns, with plans by FFTW_ESTIMATE, so that the
/// result is bitwise independent of the number of threads and the same in every
/// run.
template <class Real>
class PairTransforms {
public:
  using Complex = std::complex<Real>;

  /// @param rows   number of rows that are held, >= 1
  /// @param width  number of their values that are not always 0
  PairTransforms(const Grid& grid, int rows, int width);
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
  std::size_t pair_stride_, n_columns_, column_stride_;
  std::unique_ptr<Plans> plans_;
};

extern template class PairTransforms<float>;
extern template class PairTransforms<double>;

} // namespace asperity
