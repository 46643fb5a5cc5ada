#pragma once

// Explicit form of a mesh with hanging nodes: the mesh after its refinement.

#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Returns the mesh with every refinement of refine_below carried out. Cells
/// and boundary faces are cut at the means of their vertices. Each new vertex
/// is created once, also where a cut cell meets an uncut one; there it is a
/// hanging node, which is not listed among the vertices of the uncut cell.
/// Children have the group of their parent and are consecutive in deal.II's
/// order, x fastest; refine_below of the result is empty.
///
/// @param mesh  a mesh of hexahedra
/// @throws std::domain_error  refine_below is set for tetrahedra
BlockMesh cut_mesh(const BlockMesh& mesh);

} // namespace asperity::meshes
