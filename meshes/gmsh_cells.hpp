#pragma once

// The mesh of gmsh's current model as the plain data of this project.

#include "meshes/block_mesh.hpp"

#include <cstddef>
#include <map>

namespace asperity::meshes {

struct GmshMesh {
  BlockMesh mesh; ///< without faces and extents
  std::map<std::size_t, unsigned int> vertex_of_node; ///< by gmsh's numbers
};

/// Vertices and cells of gmsh's current model, inside in_gmsh: hexahedra of
/// eight or tetrahedra of four vertices, renumbered from gmsh's order to
/// deal.II's; vertices in the order of gmsh's numbers, without those of no
/// cell. Physical volumes become the groups of cells, in the order of their
/// tags and with their names ("volume 3" for one without); without any, all
/// cells are of the group "block".
///
/// @throws std::domain_error  no cells; cells of another kind or of both
///                            (the kind and the first one's number are named);
///                            a volume in no physical group though others are,
///                            or in two
GmshMesh cells_of_gmsh();

} // namespace asperity::meshes
