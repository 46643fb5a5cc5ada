#pragma once

// Conversion of the mesh of gmsh's current model to the plain data of this
// project.

#include "meshes/block_mesh.hpp"

#include <cstddef>
#include <map>

namespace asperity::meshes {

struct GmshMesh {
  BlockMesh mesh; ///< without faces and extents
  std::map<std::size_t, unsigned int> vertex_of_node; ///< by gmsh's node
                                                      ///< numbers
};

/// Converts the vertices and cells of gmsh's current model; to be called inside
/// in_gmsh. Cells are hexahedra of eight or tetrahedra of four vertices and are
/// renumbered from gmsh's order to deal.II's. Vertices keep the order of gmsh's
/// numbers; those without a cell are dropped. Physical volumes become the
/// groups of cells, in the order of their tags and with their names ("volume 3"
/// for an unnamed one). Without physical volumes all cells are in the group
/// "block".
///
/// @throws std::domain_error  there are no cells; there are cells of another
///                            type or of both types (the message names the type
///                            and the first cell's number); a volume is in no
///                            physical group although others are, or in two
GmshMesh cells_of_gmsh();

} // namespace asperity::meshes
