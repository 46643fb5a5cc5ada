#pragma once

// Real two-dimensional discrete Fourier transforms on a Grid, with stored
// plans. FFTW is not visible outside this module.

#include "base/grid.hpp"

#include <complex>
#include <memory>
#include <span>
#include <string>

namespace asperity {

/// The transform pair of one grid,
///
///     forward:   F(j) = sum_x f(x) exp(-i q_j . x)        (no factor)
///     backward:  f(x) = sum_j F(j) exp(+i q_j . x)        (no factor)
///
/// so that backward(forward(f)) = f * grid.size(), and the coefficient of mode
/// j is F(j) / grid.size(). Spectra are half spectra in the order of
/// Grid::half_spectrum_size. Plans are made with FFTW_ESTIMATE, so the results
/// are bitwise the same in every run. An instance holds no scratch memory and
/// may be shared by threads. Arrays must begin on a 16-byte boundary, as every
/// std::vector does.
class RealFourier {
public:
  explicit RealFourier(const Grid& grid, int threads = 1);
  ~RealFourier();
  RealFourier(RealFourier&&) noexcept;
  RealFourier& operator=(RealFourier&&) noexcept;

  const Grid& grid() const { return grid_; }

  /// Forward transform.
  /// @param field    grid.size() values, not changed
  /// @param spectrum grid.half_spectrum_size() values, overwritten
  void forward(std::span<const double> field,
               std::span<std::complex<double>> spectrum) const;

  /// Backward transform.
  /// @param spectrum grid.half_spectrum_size() values, destroyed
  /// @param field    grid.size() values, overwritten
  void backward(std::span<std::complex<double>> spectrum,
                std::span<double> field) const;

private:
  struct Plans;
  Grid grid_;
  std::unique_ptr<Plans> plans_;
};

/// Name and version of the FFT library.
std::string fourier_library();

} // namespace asperity
