#pragma once

// Solves for the displacement of a block on a lattice of boxes by conjugate
// gradients, preconditioned by geometric multigrid.

#include "fem/multigrid/lattice_slab.hpp"
#include "fem/multigrid/mesh_multigrid.hpp"
#include "fem/multigrid/multigrid_cycle.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// MeshMultigrid on a lattice and its coarser ones. Ranks may share the rows of
/// cells, as slab() says. Displacements, forces and contact are then those of
/// the rank's rows.
///
/// Rigid motions that nothing prevents (rigid_modes.hpp) require forces that
/// are in balance; the solution then contains any such motion.
class LatticeMultigrid : public MeshMultigrid {
public:
  /// @throws std::domain_error  under the conditions of require_lattice, or if
  ///                            the block can tilt
  /// @param ranks  may be null; otherwise it must outlive this object
  explicit LatticeMultigrid(const BoxLattice& lattice,
                            RankGroup* ranks = nullptr);

  /// The cycle refers to this object.
  LatticeMultigrid(const LatticeMultigrid&) = delete;
  LatticeMultigrid& operator=(const LatticeMultigrid&) = delete;

  NodeLayout layout() const { return slab_.layout(lattice_); }

  const BoxLattice& lattice() const { return lattice_; } ///< without moduli

  /// The rows of this rank: all rows if there are too few to share.
  const LatticeSlab& slab() const { return slab_; }

  /// @param contact  springs [N/m]
  void set_contact(MeshContact contact);

  std::size_t levels() const { return cycle_.levels() + 1; }

  std::size_t bytes() const; ///< on this rank

private:
  LatticeMultigrid(const BoxLattice& lattice, const LatticeSlab& slab);

  BoxLattice lattice_;
  LatticeSlab slab_;
  MultigridCycle cycle_;
};

} // namespace asperity::fem
