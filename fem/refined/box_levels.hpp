#pragma once

// Coarser and coarser meshes for a mesh of halved boxes. This file does not
// depend on deal.II.

#include "fem/refined/box_operator.hpp"
#include "fem/refined/mesh_plan.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity::fem {

/// Boxes that are halved from the cells of a lattice, and their moduli.
struct HalvedBoxes {
  std::vector<BoxCell> cells;
  std::vector<CellModuli> moduli;

  /// Whether all cells are those of the lattice.
  bool is_lattice() const;
};

/// The boxes after merging all those that may merge.
/// @param lattice    the coarsest cells; its moduli are not used
/// @param merged_in  receives the number of the new cell that covers each cell
/// @throws std::logic_error  nothing can merge
HalvedBoxes merged(const BoxLattice& lattice, const HalvedBoxes& boxes,
                   std::vector<std::uint32_t>& merged_in);

/// The edges of a cell.
std::array<double, 3> edges_of(const BoxLattice& lattice, const BoxCell& cell);

/// First-order functions on halved boxes with hanging nodes, periodic or free
/// sides, and the far boundary that the lattice holds. Periodic images are the
/// same node. Nodes are numbered by their places, x fastest, then y and z.
struct BoxLevel {
  BoxLevel(const BoxLattice& lattice, HalvedBoxes own);

  bool is_constrained(std::size_t unknown) const;

  HalvedBoxes boxes;
  BoxMesh mesh; ///< in the units of the lattice
};

} // namespace asperity::fem
