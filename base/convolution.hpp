#pragma once

// This file computes periodic convolutions of real fields on a Grid: forward
// transform, product with a real symbol, backward transform, in three passes
// over memory. It partitions the work into rows and blocks of columns.

#include "base/grid.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

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

  /// Applies the convolution.
  /// @param field   held.size() values, by default grid.size()
  /// @param answer  as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real: a few ulp of the largest |multiplier|
  ///                times the rms of the field, at every wavevector
  void apply(std::span<const Real> field, const Symbol& symbol,
             Scratch& scratch, std::span<Real> answer) const;

private:
  struct Plans;
  void prepare(Scratch& scratch) const;
  void transform_columns(const Symbol& symbol, Scratch& scratch) const;
  void gather(const std::complex<Real>* spectrum, std::size_t first,
              std::size_t n, std::complex<Real>* columns) const;
  void scatter(const std::complex<Real>* columns, std::size_t first,
               std::size_t n, std::complex<Real>* spectrum) const;

  Grid grid_;
  Grid held_;
  int threads_;
  std::size_t pair_stride_;   ///< complex values per pair of rows
  std::size_t n_columns_;     ///< of the half spectrum, rounded up to blocks
  std::size_t column_stride_; ///< values per column of a block
  std::unique_ptr<Plans> plans_;
};

extern template class Convolution<float>;
extern template class Convolution<double>;

} // namespace asperity
