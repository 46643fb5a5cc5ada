#pragma once

// The coarser meshes of halved boxes, which end on the lattice of the coarsest
// cells. This file does not depend on deal.II.

#include "fem/multigrid/multigrid_cycle.hpp"
#include "fem/refined/box_levels.hpp"
#include "fem/refined/node_interpolation.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// The nodes of this rank on a mesh of halved boxes.
struct FinestNodes {
  NodesOfCells cells;          ///< of this rank
  std::size_t first = 0;       ///< number of the first among those of all ranks
  std::vector<bool> is_wanted; ///< of each node: whether it takes part
  const GhostValues* ghosts = nullptr; ///< null on one process
};

/// Appends first-order functions on coarser meshes to a cycle. Each merges all
/// cells that may merge (global coarsening), until the cells are those of the
/// lattice, whose coarser lattices follow. Every rank has all of these meshes.
/// Without contact, the lattice may have rigid motions that a pin of the mesh
/// prevents. Collective.
/// @param lattice  the coarsest cells, in units in which the stiffness fits
///                 into a float; its moduli are not used
/// @param boxes    all cells of the mesh, with moduli in these units
/// @param is_second_order  whether first-order functions on the mesh itself are
///                 coarser than those of the unknowns
void add_coarser_boxes(const BoxLattice& lattice, HalvedBoxes boxes,
                       FinestNodes finest, bool is_second_order,
                       MultigridCycle& cycle);

} // namespace asperity::fem
