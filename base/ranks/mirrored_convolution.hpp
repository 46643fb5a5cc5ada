#pragma once

// Periodic convolutions of fields that equal their mirror images, on a quarter
// of the cell.

#include "base/grid.hpp"
#include "base/ranks/convolution.hpp"

#include <complex>
#include <span>
#include <vector>

namespace asperity {

/// A quarter of the cell of a field f(ix, iy) = f(n_x - 1 - ix, iy) =
/// f(ix, n_y - 1 - iy): its first columns and rows.
/// @param cell  of even numbers of points
Grid quarter_of(const Grid& cell);

/// Computes what Convolution does on the cell of such a field, from its quarter
/// alone. The transform of the cell is the cosine transform of the quarter
/// (DCT-II), which follows from the Fourier transform V of the quarter whose
/// rows and columns are taken in the order 0, 2, 4, ..., 5, 3, 1. On n_x n_y
/// nodes, with w_x = exp(-i pi j_x/(2 n_x)) and w_y likewise,
///
///     T(j_x, j_y) = w_x [w_y V(j_x, j_y) + conj(w_y) V(j_x, n_y - j_y)]/2
///
/// has the modes of (j_x, j_y) and, times -1, of (n_x - j_x, j_y) as its real
/// and imaginary part (J. Makhoul, IEEE Trans. Acoust. 28, 27 (1980)). The bits
/// do not depend on the number of threads. Real is float or double. Use one
/// instance per thread.
template <class Real>
class MirroredConvolution {
public:
  /// @param cell     of even numbers of points
  /// @param threads  >= 1
  explicit MirroredConvolution(const Grid& cell, int threads = 1);

  /// Applies the convolution.
  /// @param field        of the quarter
  /// @param multipliers  of the modes of the cell
  /// @param answer       as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real, as Convolution
  void apply(std::span<const Real> field, const EvenColumn& multipliers,
             std::span<Real> answer);

private:
  using Complex = std::complex<Real>;

  std::size_t height() const {
    return static_cast<std::size_t>(quarter_.points_y);
  }

  /// The multipliers of the columns jx and n_x - jx over the number of nodes,
  /// one after the other.
  void take_columns(int jx, const EvenColumn& multipliers, Real* pair) const;
  /// Multiplies the modes of a column of V.
  void multiply(int jx, const Real* pair, Complex* column) const;

  Grid quarter_;
  Convolution<Real> convolution_;        ///< on the quarter
  std::vector<Complex> turn_x_, turn_y_; ///< w_x, w_y
  std::vector<Real> reordered_;
};

extern template class MirroredConvolution<float>;
extern template class MirroredConvolution<double>;

} // namespace asperity
