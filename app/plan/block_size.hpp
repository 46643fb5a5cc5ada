#pragma once

// Predicts the size of the discrete problem of a full block before it is
// meshed. Structured meshes are counted; the size of gmsh meshes is estimated
// from the prescribed mesh sizes.

#include "base/grid.hpp"
#include "cases/types/case.hpp"

namespace asperity::app {

/// The size of a discrete problem. All values are NaN if the mesh is read from
/// a file.
struct BlockSize {
  double cells = 0.0;
  double unknowns = 0.0; ///< displacements, including constrained and hanging
                         ///< ones
  double nodes_per_side = 0.0; ///< per side of the contact surface
};

/// Returns the size of the problem of `solver = "full"`. The count is exact for
/// graded layers and hanging nodes. For gmsh it is within a few nodes per
/// direction for hexahedra and within a factor of two for tetrahedra.
///
/// @throws std::domain_error  the mesh itself would be rejected
BlockSize block_size(const cases::Case& contact_case,
                     const mechanics::FemSettings& settings,
                     const mechanics::Scales& scales, const Grid& grid);

/// Returns the number of cell layers over the depth. The first layer is
/// surface_cell_depth node spacings thick, and the cell faces match the
/// material interfaces.
int n_layers(const cases::Case& contact_case,
             const mechanics::FemSettings& settings,
             const mechanics::Scales& scales, const Grid& grid);

} // namespace asperity::app
