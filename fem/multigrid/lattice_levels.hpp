#pragma once

// Which coarser lattices a multigrid method uses for a lattice of boxes.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <array>
#include <vector>

namespace asperity::fem {

/// The axes x, y and z of a lattice.
std::array<LatticeAxis, 3> axes_of(const BoxLattice& lattice);

/// The next coarser lattice. Cells are merged only in the directions in which
/// they are short: columns and layers up to 1.5 times twice the smallest side
/// of a cell, so that the cells of graded layers become cubes first. An odd
/// number of columns is halved upwards; the lattices are then not nested.
/// Moduli are means over the merged volume.
BoxLattice coarser(const BoxLattice& lattice);

/// Whether the lattice is solved on coarser ones, because it has too many
/// unknowns for an exact solution and cells to merge.
bool has_coarser(const BoxLattice& lattice);

} // namespace asperity::fem
