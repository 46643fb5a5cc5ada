#pragma once

// One cycle of geometric multigrid over coarser and coarser lattices, in single
// precision.

#include "fem/multigrid/coarsest_lattice.hpp"
#include "fem/multigrid/face_contact.hpp"
#include "fem/multigrid/lattice_operator.hpp"
#include "fem/multigrid/lattice_transfer.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Approximates (K + S)^-1 by a V-cycle, where S are the springs of contact and
/// held unknowns are left out. It is symmetric and positive up to rounding.
///
/// The smoother is a Chebyshev polynomial of the fourth kind, which needs an
/// upper bound on the eigenvalues only: that of a single cell
/// (LatticeOperator::jacobi_bound). A spring matrix S adds the sums of its rows
/// |S_ij| over that bound to the diagonal of K, so that the bound holds for any
/// springs.
/// @see  J. Lottes, Numer. Linear Algebra Appl. 30, e2518 (2023)
class MultigridCycle {
public:
  /// @param lattice  in the units of normalised()
  explicit MultigridCycle(const BoxLattice& lattice)
      : MultigridCycle(lattice, LatticeSlab(lattice)) {}

  /// @param slab  the rows of this rank, which may be shared only if the
  ///              lattice has coarser ones. All calls are then collective.
  MultigridCycle(const BoxLattice& lattice, LatticeSlab slab);
  ~MultigridCycle();

  /// Transfers contact to all lattices and factorises the coarsest.
  /// @param contact  springs in the unit of the lattice's stiffness
  void set_contact(const FaceContact& contact);

  /// The force on the finest lattice, to be written before run(), zero at
  /// images; overwritten by it.
  std::vector<float>& force();

  /// The displacement after run(); its images have no meaning.
  const std::vector<float>& displacement() const;

  void run();

  /// Whether there are coarser lattices; otherwise the cycle is an exact
  /// solution.
  static bool has_levels(const BoxLattice& lattice);

  std::size_t levels() const { return levels_.size() + 1; }

  std::size_t bytes() const;

private:
  struct Level;
  void descend(std::size_t level);

  std::vector<std::unique_ptr<Level>> levels_; ///< all but the coarsest
  std::unique_ptr<CoarsestLattice> coarsest_;
};

} // namespace asperity::fem
