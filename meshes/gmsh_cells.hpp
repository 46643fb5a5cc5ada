#pragma once

// The mesh of gmsh's current model as the plain data of this project.

#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Vertices and cells of gmsh's current model, inside in_gmsh: hexahedra of
/// eight or tetrahedra of four vertices, renumbered from gmsh's order to
/// deal.II's; vertices in the order of gmsh's numbers, without those of no
/// cell. Physical volumes become the groups of cells, in the order of their
/// tags and with their names ("volume 3" for one without); without any, all
/// cells are of the group "block". Faces and extents are left for the caller.
///
/// @throws std::domain_error  no cells; cells of another kind or of both
///                            (the kind and the first one's number are named);
///                            a volume in no physical group though others are,
///                            or in two
BlockMesh cells_of_gmsh();

} // namespace asperity::meshes
