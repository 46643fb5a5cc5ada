#pragma once

// Interpolation of displacements from a coarse grid of boxes to a fine one, and
// its transpose for forces.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/box_grid_slab.hpp"
#include "fem/multigrid/level_transfer.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The product of the interpolations along the three axes. A coarse node is
/// held in contact if the fine node nearest to it is. If ranks share the fine
/// rows, they may share the coarse rows as well, in the same places, or each
/// may have all of them.
class BoxGridTransfer final : public LevelTransfer {
public:
  BoxGridTransfer(const BoxGrid& fine, const BoxGridSlab& fine_slab,
                  const BoxGrid& coarse, const BoxGridSlab& coarse_slab);

  void add_interpolated(const std::vector<float>& coarse,
                        std::vector<float>& fine) override {
    add_product(weights_, coarse_, coarse, fine_, fine);
  }

  std::size_t bytes() const override;

private:
  void add_restricted(const std::vector<float>& fine,
                      std::vector<float>& coarse) override {
    add_product(transposed_, fine_, fine, coarse_, coarse);
  }

  void add_contact(const SparseRows& along_y,
                   const std::vector<std::size_t>& nearest_x,
                   const std::vector<std::size_t>& nearest_y,
                   std::size_t first);

  /// Adds the product of the matrices along the three axes with `from`.
  void add_product(const std::array<SparseRows, 3>& matrices,
                   const NodeLayout& from_layout,
                   const std::vector<float>& from, const NodeLayout& to_layout,
                   std::vector<float>& to);

  void add_along_x(const SparseRows& matrix, const float* from,
                   std::size_t from_stride, float* to,
                   std::size_t to_stride) const;

  NodeLayout fine_, coarse_;
  std::array<SparseRows, 3> weights_;    ///< row: fine node
  std::array<SparseRows, 3> transposed_; ///< row: coarse node
  std::vector<float> slice_, row_;
};

} // namespace asperity::fem
