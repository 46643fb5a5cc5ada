#pragma once

// Periodic convolutions of fields that equal their mirror images, on a quarter
// of the cell.

#include "base/grid.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// A quarter of the cell of a field f(ix, iy) = f(n_x - 1 - ix, iy) =
/// f(ix, n_y - 1 - iy): its first columns and rows.
/// @param cell  of even numbers of points
Grid quarter_of(const Grid& cell);

/// Computes what Convolution (base/ranks/convolution.hpp) does on the cell of
/// such a field, from its quarter alone: the cosine transforms of N values
/// (DCT-II, and DCT-III back) are those of 2N values that equal their mirror
/// image, so that all costs a quarter. The bits do not depend on the number of
/// threads. Real is float or double. Each instance has scratch memory of its
/// own, which copies do not take over: use one per thread.
template <class Real>
class MirroredConvolution {
public:
  /// The multipliers of the modes (jx, jy) of the cell for jy = 0, 1, ...,
  /// points_y/2. Threads call it at the same time.
  using Multipliers = std::function<void(int jx, std::span<double> of_jy)>;

  /// @param cell     of even numbers of points
  /// @param threads  >= 1
  explicit MirroredConvolution(const Grid& cell, int threads = 1);

  /// Applies the convolution.
  /// @param field        of the quarter
  /// @param answer       as many values, overwritten; may be `field`
  /// @par Accuracy  roundoff of Real, as Convolution
  void apply(std::span<const Real> field, const Multipliers& multipliers,
             std::span<Real> answer);

private:
  struct Plans;

  Grid quarter_;
  int threads_;
  std::shared_ptr<const Plans> plans_;

  /// Memory of one application.
  struct Scratch {
    std::vector<Real> spectrum; ///< of the quarter
    std::vector<Real> lines;    ///< one row or block of columns per thread

    Scratch() = default;
    Scratch(Scratch&&) noexcept = default;
    Scratch& operator=(Scratch&&) noexcept = default;

    Scratch(const Scratch& /*other*/) {}

    Scratch& operator=(const Scratch& /*other*/) { return *this; }

    ~Scratch() = default;
  };

  Scratch scratch_;
};

extern template class MirroredConvolution<float>;
extern template class MirroredConvolution<double>;

} // namespace asperity
