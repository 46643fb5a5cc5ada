#pragma once

// How large a whole block's problem is, before it is meshed: counted where the
// mesh is structured, from its sizes where gmsh makes it.

#include "base/grid.hpp"
#include "cases/types/case.hpp"

namespace asperity::app {

/// NaN where the mesh is a file.
struct BlockSize {
  double cells = 0.0;
  double unknowns = 0.0; ///< displacements, held and hanging ones among them
  double nodes_a_side = 0.0; ///< across the contact face
};

/// Of `solver = "full"`. To the unit for graded layers and hanging nodes;
/// gmsh's hexahedra within a few nodes a direction, its tetrahedra within a
/// factor of two.
/// @throws std::domain_error  what the mesh itself would refuse
BlockSize block_size(const cases::Case& rough_case,
                     const cases::FemSettings& settings,
                     const cases::Scales& scales, const Grid& grid);

/// Layers of cells over the depth: the first surface_cell_depth node spacings
/// thick, faces on the material's interfaces.
int n_layers(const cases::Case& rough_case, const cases::FemSettings& settings,
             const cases::Scales& scales, const Grid& grid);

} // namespace asperity::app
