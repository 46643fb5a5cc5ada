#pragma once

// Reads a mesh from a file supplied by the user.

#include "mechanics/fem_settings.hpp"
#include "meshes/block_mesh.hpp"

#include <cstdint>
#include <string>

namespace asperity::meshes {

/// Limits on the resources that gmsh may use for one file.
struct MeshFileLimits {
  double wall_time = 600.0;                        ///< [s]
  std::uintmax_t memory = std::uintmax_t{8} << 30; ///< of address space [bytes]
};

/// Reads a .msh file (2.2 or 4.1, ASCII or binary), or meshes a .geo file with
/// gmsh.
///
/// Cells are hexahedra of eight or tetrahedra of four vertices. The file must
/// name the physical surfaces `contact`, which is flat with constant z and has
/// the complete block on one side, and `fixed`, which holds the block; it may
/// name `sides`. All other boundary facets belong to the sides too. Physical
/// volumes become the groups of cells in the order of their tags, with their
/// names.
///
/// The mesh is scaled and moved so that the contact surface is at z = 0 and its
/// bounds begin at x = y = 0. A block below its contact surface is mirrored in
/// z, so that x and y remain those of the file. If every side facet lies on one
/// of the four planes through the bounds of the contact surface, the sides
/// become left, right, front and back, and the block may be periodic.
///
/// A .geo file is a program for gmsh: read only files from sources that you
/// trust. gmsh runs in a separate process (asperity_mesh), so a file that does
/// not terminate, uses up all memory or crashes gmsh is refused like any other
/// invalid file.
///
/// @param path   the file name extension determines the format
/// @param unit   metres per unit of the file [m] > 0
/// @param sides  periodic: opposite sides must match within 1e-6 of the block's
///               largest extent, and are then aligned
/// @return       a mesh whose length_x and length_y are the bounds of the
///               contact surface and whose depth is the largest z
/// @throws std::domain_error  the message begins with the path: the file does
///                            not exist, has another extension, or is refused
///                            by gmsh (with its own message); a group is
///                            missing (with the names that exist); the contact
///                            surface is not flat (with the vertex);
///                            require_valid_mesh refuses the mesh; or gmsh
///                            exceeds a limit
/// @throws std::runtime_error  asperity_mesh does not exist or cannot be
///                             started
BlockMesh read_mesh_file(const std::string& path, double unit,
                         mechanics::BlockSides sides,
                         const MeshFileLimits& limits = {});

} // namespace asperity::meshes
