#pragma once

// Fourier transforms of a real field whose rows several processes hold in
// slabs: what a library of distributed transforms must provide.

#include <complex>
#include <cstddef>
#include <span>

namespace asperity {

/// Adjacent columns of a half spectrum.
struct SpectrumColumns {
  std::size_t first = 0, count = 0;
};

/// The transforms of RealFourier on slabs of rows, and the memory of the
/// spectrum. All calls but those that return columns are collective.
template <class Real>
class SlabTransforms {
public:
  using Complex = std::complex<Real>;
  virtual ~SlabTransforms() = default;

  /// The columns of the half spectrum that this rank has; there may be none.
  virtual SpectrumColumns columns() const = 0;

  /// These columns, one after the other, as points_y values each.
  virtual std::span<Complex> spectrum() = 0;

  /// Sets the columns to the transform of a field.
  /// @param field  of the rows of this rank
  virtual void forward(std::span<const Real> field) = 0;

  /// The inverse, without a factor; the spectrum is destroyed.
  virtual void backward(std::span<Real> answer) = 0;
};

} // namespace asperity
