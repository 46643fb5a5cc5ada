#pragma once

// Multiplies the Fourier amplitudes of the four node classes of a Q2 surface by
// blocks, on rows that ranks may share.

#include "base/ranks/convolution.hpp"
#include "fem/waves/condensed_q2.hpp"

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace asperity::fem {

/// Computes u = G W p for fields on all nodes of the surface, where W are the
/// relative nodal areas w_k: with the amplitudes
///
///     p_k(q) = 1/cells sum_cells p(x) exp(-i q.x),                     (Q2.3)
///
/// where x are the actual places of the nodes of class k, u_k is that of
/// (Q2.1). Each class has one value per cell and is transformed on the grid of
/// the cells.
template <class Real>
class Q2Convolution {
public:
  using Block = std::array<Real, node_classes * node_classes>;

  /// @param nodes  rows of nodes; their bounds but the last are multiples of 4
  /// @param cells  rows of cells, of half the bounds
  /// Both must outlive this object.
  Q2Convolution(const SharedRows& nodes, const SharedRows& cells, int threads);

  /// The columns jx of cell wavevectors that this rank multiplies.
  SpectrumColumns columns() const { return transforms_.columns(); }

  /// Collective.
  /// @param blocks  G of the columns of this rank, jy = 0..cells/2 of each
  /// @param field   of the nodes of this process
  /// @param answer  likewise, overwritten; may be `field`
  void apply(std::span<const Block> blocks, std::span<const Real> field,
             std::span<Real> answer);

private:
  using Complex = std::complex<Real>;

  /// Copies the values of a node class from a field, or back.
  void take_class(std::size_t node_class, std::span<const Real> field);
  void return_class(std::size_t node_class, std::span<Real> field) const;
  void multiply_column(std::size_t k, std::span<const Block> blocks);

  /// Place of an own column in the spectrum of a class.
  std::size_t column_at(int jx) const {
    return (static_cast<std::size_t>(jx) - columns().first) * height_;
  }

  const SharedRows& nodes_;
  const SharedRows& cells_;
  int threads_;
  std::size_t height_; ///< cells in y, of all ranks
  Convolution<Real> transforms_;
  std::array<Real, node_classes> factors_; ///< w_k/cells
  std::vector<Complex> turns_y_;           ///< exp(i q_y d_y) of each jy
  std::vector<Real> values_;               ///< of one class
  std::array<std::vector<Complex>, node_classes> spectra_;
};

extern template class Q2Convolution<float>;
extern template class Q2Convolution<double>;

} // namespace asperity::fem
