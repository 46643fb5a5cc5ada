#pragma once

// What a mesh with hanging nodes looks like after its cuts.

#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// The mesh with every cut of refine_below carried out: cells and boundary
/// faces cut at the means of their vertices, each new vertex made once, also
/// where a cut cell meets an uncut one (there it hangs: the uncut cell does
/// not name it). Children have their parent's group and follow one another in
/// deal.II's order, x fastest; refine_below is empty.
///
/// @param mesh  hexahedra
/// @throws std::domain_error  refine_below is set on tetrahedra
BlockMesh cut_mesh(const BlockMesh& mesh);

} // namespace asperity::meshes
