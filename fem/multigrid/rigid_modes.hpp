#pragma once

// The rigid motions that the supports of a grid of boxes permit.

#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/box_grid_slab.hpp"

#include <vector>

namespace asperity::fem {

/// One displacement [1] per rigid motion that neither the far boundary nor
/// contact prevents: shifts in x and y and, with free sides, the rotation about
/// z, unless the far boundary holds lateral displacements; the shift in z
/// unless it holds that or there is contact. Values are those of the slab,
/// without images.
/// @throws std::domain_error  the block can tilt: its sides are free and the
///                            far boundary does not hold u_z
std::vector<std::vector<double>>
rigid_modes(const BoxGrid& box_grid, const BoxGridSlab& slab, bool has_contact);

} // namespace asperity::fem
