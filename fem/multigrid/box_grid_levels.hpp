#pragma once

// Which coarser grids of boxes a multigrid method uses for a grid of boxes.

#include "fem/multigrid/axis_weights.hpp"
#include "fem/multigrid/box_grid.hpp"

#include <array>
#include <vector>

namespace asperity::fem {

/// The axes x, y and z of a grid of boxes.
std::array<BoxGridAxis, 3> axes_of(const BoxGrid& box_grid);

/// The next coarser grid of boxes. Cells are merged only in the directions in
/// which they are short: columns and layers up to 1.5 times twice the smallest
/// side of a cell, so that the cells of graded layers become cubes first. An
/// odd number of columns is halved upwards; the grids of boxes are then not
/// nested. Moduli are means over the merged volume.
BoxGrid coarser(const BoxGrid& box_grid);

/// Whether the grid of boxes is solved on coarser ones, because it has too many
/// unknowns for an exact solution and cells to merge.
bool has_coarser(const BoxGrid& box_grid);

} // namespace asperity::fem
