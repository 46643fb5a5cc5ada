#pragma once

// Interpolation of displacements from a coarse lattice to a fine one, and its
// transpose for forces.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"
#include "fem/multigrid/lattice_slab.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The product of the interpolations along the three axes. If ranks share the
/// fine rows, calls are collective. They may share the coarse rows as well, in
/// the same places, or each may have all of them.
class LatticeTransfer {
public:
  LatticeTransfer(const BoxLattice& fine, const LatticeSlab& fine_slab,
                  const BoxLattice& coarse, const LatticeSlab& coarse_slab);

  /// Sets the coarse force to the transposed interpolation of the fine force;
  /// zero at images.
  void restrict_force(const std::vector<float>& fine,
                      std::vector<float>& coarse);

  /// Sets the fine displacement to the interpolated coarse one, without
  /// images.
  /// @param coarse  the images are overwritten if the rows are shared
  void interpolate(std::vector<float>& coarse, std::vector<float>& fine);

  /// The interpolation along an axis (0, 1, 2).
  const SparseRows& along(std::size_t axis) const { return weights_[axis]; }

  std::size_t bytes() const;

private:
  /// Sets `to` to the product of the matrices along the three axes with `from`.
  void multiply(const std::array<SparseRows, 3>& matrices,
                const NodeLayout& from_layout, const std::vector<float>& from,
                const NodeLayout& to_layout, std::vector<float>& to);

  void add_along_x(const SparseRows& matrix, const float* from,
                   std::size_t from_stride, float* to,
                   std::size_t to_stride) const;

  void find_rows_of_ranks(const SparseRows& along_y);
  void add_rows_of_ranks(std::vector<float>& coarse) const;

  NodeLayout fine_, coarse_;
  LatticeSlab fine_slab_, coarse_slab_;
  /// If each rank has all coarse rows: those to which the fine rows of each
  /// rank contribute.
  std::vector<std::vector<std::size_t>> rows_of_ranks_;
  std::array<SparseRows, 3> weights_;    ///< row: fine node
  std::array<SparseRows, 3> transposed_; ///< row: coarse node
  std::vector<float> plane_, row_;
};

} // namespace asperity::fem
