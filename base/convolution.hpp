#pragma once

// Periodic convolutions of real fields on a Grid: transform, multiply by a real
// symbol, transform back, in three passes over memory. Owns the split of the
// work into rows and blocks of columns.

#include "base/grid.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// answer = F^-1 [ multiplier(q) F field ], with RealFourier's sign.
///
/// Rows are transformed one at a time; then blocks of columns are gathered,
/// transformed, multiplied, transformed back and scattered while they are in
/// the cache; then the rows again. FFTW sees only single rows and columns, so
/// the number of threads changes no bit of the answer, and FFTW_ESTIMATE gives
/// the same bits in every run. Real is float or double.
///
/// An instance is immutable: threads share it, each with its own Scratch.
template <class Real>
class Convolution {
public:
  /// Multipliers in the order in which the columns meet them.
  class Symbol {
    friend class Convolution;
    std::vector<Real> values;
  };

  /// Spectrum and buffers of one application at a time; grows when first used.
  class Scratch {
    friend class Convolution;
    std::vector<std::complex<Real>> spectrum;
    std::vector<std::complex<Real>> columns; ///< a block for each thread
    std::vector<Real> rows;                  ///< a row for each thread
  };

  /// @param threads  >= 1, used by each application
  explicit Convolution(const Grid& grid, int threads = 1);
  ~Convolution();
  Convolution(Convolution&&) noexcept;
  Convolution& operator=(Convolution&&) noexcept;

  const Grid& grid() const { return grid_; }

  int threads() const { return threads_; }

  /// @param multiplier  grid.half_spectrum_size() values in the order of
  ///                    Grid::half_spectrum_size
  Symbol arranged(std::span<const double> multiplier) const;

  /// @param field   grid.size() values
  /// @param answer  grid.size() values, overwritten; may be `field`
  /// @par Accuracy  rounding of Real: some ulp of the largest |multiplier|
  ///                times the rms of the field, at every wavevector
  void apply(std::span<const Real> field, const Symbol& symbol,
             Scratch& scratch, std::span<Real> answer) const;

private:
  struct Plans;
  void prepare(Scratch& scratch) const;
  void transform_columns(const Symbol& symbol, Scratch& scratch) const;

  Grid grid_;
  int threads_;
  std::size_t row_stride_;    ///< complex values a row of the spectrum
  std::size_t column_stride_; ///< values a column of a block
  std::unique_ptr<Plans> plans_;
};

extern template class Convolution<float>;
extern template class Convolution<double>;

} // namespace asperity
