#pragma once

// Reads a mesh from a file supplied by the user.

#include "meshes/block_mesh.hpp"

#include <string>

namespace asperity::fem {

/// The mesh of a file. Its sides are as they are in the file: see
/// meshes::fit_sides.
struct FileMesh {
  meshes::BlockMesh mesh;
  std::string hash; ///< content_hash() of all of it
};

/// Reads a mesh by deal.II (GridIn) from a .msh (gmsh, as text), .inp (Abaqus),
/// .vtk or .unv file.
///
/// Cells are hexahedra of eight or tetrahedra of four vertices. The file must
/// have the groups of faces `contact`, which is flat with constant z and has
/// the complete block on one side, and `fixed`, which holds the block; it may
/// have `sides`. Where groups have numbers and no names, these are 1, 2 and 3.
/// All other boundary facets belong to the sides too. Groups of volumes become
/// the groups of cells in the order of their numbers, with their names.
///
/// The mesh is scaled and moved so that the contact surface is at z = 0 and its
/// bounds begin at x = y = 0. A block below its contact surface is mirrored in
/// z, so that x and y remain those of the file. If every side facet lies on one
/// of the four planes through the bounds of the contact surface, the sides
/// become left, right, front and back, and the block may be periodic.
///
/// The readers check little of a damaged file. They run in a child process, so
/// that one at which they crash, do not end or take more than 8 GiB of memory
/// is refused like any other.
///
/// @param unit   metres per unit of the file [m] > 0
/// @return       a mesh whose length_x and length_y are the bounds of the
///               contact surface and whose depth is the largest z
/// @throws std::domain_error  the message begins with the path: the file does
///                            not exist, has another extension, or is refused
///                            by its reader; a group is missing (with the names
///                            that exist); a named face is inside the block or
///                            in two groups
FileMesh read_mesh_file(const std::string& path, double unit);

} // namespace asperity::fem
