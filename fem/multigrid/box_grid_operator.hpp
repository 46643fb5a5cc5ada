#pragma once

// The stiffness of a block on a grid of boxes as an operator without a
// matrix.

#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/box_grid_slab.hpp"
#include "fem/multigrid/mesh_operator.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// K of equal columns of boxes. The cells of a layer share their matrix up to a
/// factor, or if their Poisson's ratios differ, two matrices, of lambda = 1 and
/// mu = 1; see ParitySlots for how a product is split. If ranks share the rows
/// of cells, each has the displacements and forces of its own. The order of
/// unknowns lets neighbouring cells be read and written together; with numbers
/// of nodes as BoxOperator has them, a product takes 2.5 times as long.
template <class Number>
class BoxGridOperator final : public MeshOperator<Number> {
public:
  /// @param grid of boxes   with all rows
  /// @param unknowns  those of the rows of `slab`
  BoxGridOperator(const BoxGrid& box_grid, const BoxGridSlab& slab,
                  UnknownLayout unknowns);

  /// The diagonal of K, zero at constrained unknowns and those of other ranks.
  /// Collective.
  std::vector<double> diagonal() const;

  /// A bound on the eigenvalues of diag(K)^-1 K, which also holds after
  /// unknowns have been held.
  double jacobi_bound() const { return bound_; }

  std::size_t bytes() const override;

private:
  struct Layer {
    std::vector<Number> blocks;
    std::vector<Number> factor, shear;       ///< of the cells
    std::vector<double> of_factor, of_shear; ///< diagonals of one cell
    std::size_t factor_row = 0; ///< from row to row; 0 if all are equal
  };

  void add_cells(const Number* displacement, Number* force,
                 Number scale) const override;
  void add_layer(const BoxGrid& box_grid, const BoxGridSlab& slab, int layer);
  void take_factors(const BoxGrid& box_grid, const BoxGridSlab& slab, int layer,
                    Layer& own) const;
  void add_diagonal(const Layer& layer, std::size_t plane, int x, int y,
                    std::vector<double>& sum) const;

  int degree_;
  std::size_t cells_x_, cells_y_;
  NodeLayout layout_;
  std::vector<Layer> layers_;
  double bound_ = 0.0;
};

} // namespace asperity::fem
