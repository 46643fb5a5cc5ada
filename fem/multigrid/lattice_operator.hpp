#pragma once

// The stiffness of a block on a lattice of boxes as an operator without a
// matrix.

#include "fem/multigrid/box_lattice.hpp"
#include "fem/multigrid/cell_kernel.hpp"
#include "fem/multigrid/face_contact.hpp"
#include "fem/multigrid/lattice_slab.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// Computes K u cell by cell. The cells of a layer share their matrix up to a
/// factor, or if their Poisson's ratios differ, two matrices, of lambda = 1 and
/// mu = 1; see ParitySlots for how a product is split. The supports of the far
/// boundary are not part of K. If ranks share the rows of cells, each has the
/// displacements and forces of its own, and calls are collective.
/// @tparam Number  float or double
template <class Number>
class LatticeOperator {
public:
  /// @throws std::domain_error  under the conditions of require_lattice
  explicit LatticeOperator(const BoxLattice& lattice)
      : LatticeOperator(lattice, LatticeSlab(lattice)) {}

  /// @param lattice  with all rows
  LatticeOperator(const BoxLattice& lattice, LatticeSlab slab);

  const NodeLayout& layout() const { return layout_; }

  const LatticeSlab& slab() const { return slab_; }

  /// Computes force = (K + S) displacement.
  /// @param displacement  layout().size() values; the images are overwritten
  /// @param force         layout().size() values; zero at images
  /// @param springs       S
  void apply(Number* displacement, Number* force,
             const FaceSprings& springs = {}) const;

  /// The diagonal of K, zero at images and padding.
  std::vector<Number> diagonal() const;

  /// A bound on the eigenvalues of diag(K)^-1 K, which also holds after
  /// unknowns have been held.
  double jacobi_bound() const { return bound_; }

  std::size_t bytes() const;

private:
  struct Layer {
    std::vector<Number> blocks;
    std::vector<Number> factor, shear;       ///< of the cells
    std::vector<double> of_factor, of_shear; ///< diagonals of one cell
    std::size_t factor_row = 0;
  };

  void add_layer(const BoxLattice& lattice, int layer);
  void take_factors(const BoxLattice& lattice, int layer, Layer& own) const;
  void add_diagonal(const Layer& layer, std::size_t plane, int x, int y,
                    std::vector<Number>& sum) const;

  int degree_;
  std::size_t cells_x_, cells_y_;
  LatticeSlab slab_;
  NodeLayout layout_;
  std::vector<Layer> layers_;
  double bound_ = 0.0;
};

} // namespace asperity::fem
