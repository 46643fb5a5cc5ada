#pragma once

// Solves for the displacement of a block on a grid of boxes by conjugate
// gradients, preconditioned by geometric multigrid.

#include "fem/multigrid/box_grid_slab.hpp"
#include "fem/multigrid/mesh_multigrid.hpp"
#include "fem/multigrid/multigrid_cycle.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// MeshMultigrid on a grid of boxes and its coarser ones. Ranks may share the
/// rows of cells, as slab() says. Displacements, forces and contact are then
/// those of the rank's rows.
///
/// Rigid motions that nothing prevents (rigid_modes.hpp) require forces that
/// are in balance; the solution then contains any such motion.
class BoxGridMultigrid : public MeshMultigrid {
public:
  /// @throws std::domain_error  under the conditions of require_box_grid, or if
  ///                            the block can tilt
  /// @param ranks  may be null; otherwise it must outlive this object
  explicit BoxGridMultigrid(const BoxGrid& box_grid,
                            RankGroup* ranks = nullptr);

  /// The cycle refers to this object.
  BoxGridMultigrid(const BoxGridMultigrid&) = delete;
  BoxGridMultigrid& operator=(const BoxGridMultigrid&) = delete;

  NodeLayout layout() const { return slab_.layout(box_grid_); }

  const BoxGrid& box_grid() const { return box_grid_; } ///< without moduli

  /// The rows of this rank: all rows if there are too few to share.
  const BoxGridSlab& slab() const { return slab_; }

  /// @param contact  springs [N/m]
  void set_contact(MeshContact contact);

  std::size_t levels() const { return cycle_.levels() + 1; }

  std::size_t bytes() const; ///< on this rank

private:
  BoxGridMultigrid(const BoxGrid& box_grid, const BoxGridSlab& slab);

  BoxGrid box_grid_;
  BoxGridSlab slab_;
  MultigridCycle cycle_;
};

} // namespace asperity::fem
