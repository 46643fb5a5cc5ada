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

struct MeshFile {
  std::string path;  ///< ends with .msh or .geo
  double unit = 1.0; ///< metres per unit of the file [m] > 0
  /// Whether a .geo file may start programs and write files.
  bool allow_commands = false;
};

/// The mesh of a file. Its sides are as they are in the file: see fit_sides.
struct FileMesh {
  BlockMesh mesh;
  std::string hash; ///< content_hash() of all of its bytes
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
/// gmsh runs in a separate process (asperity_mesh), so a file that does not
/// terminate, uses up all memory or crashes gmsh is refused like any other
/// invalid file. gmsh would execute the text of a .msh file that it does not
/// recognise: the file must begin with $MeshFormat, and gmsh opens a copy of it
/// in an empty folder. A .geo file is a program; it runs in its own folder, and
/// unless allow_commands is set the process is confined
/// (base/confined_process.hpp). Option files of gmsh are not read.
///
/// @return       a mesh whose length_x and length_y are the bounds of the
///               contact surface and whose depth is the largest z
/// @throws std::domain_error  the message begins with the path: the file does
///                            not exist, has another extension, does not begin
///                            as a mesh, does what it may not do (with the
///                            line), or is refused by gmsh (with its own
///                            message); a group is missing (with the names that
///                            exist); a named surface is inside the block; or
///                            gmsh exceeds a limit
/// @throws std::runtime_error  asperity_mesh does not exist or cannot be
///                             started
FileMesh read_mesh_file(const MeshFile& file,
                        const MeshFileLimits& limits = {});

/// Requires a valid mesh and aligns the sides of a periodic block.
/// @param sides  periodic: opposite sides must match within 1e-6 of the block's
///               largest extent
/// @throws std::domain_error  require_valid_mesh refuses the mesh
void fit_sides(BlockMesh& mesh, mechanics::BlockSides sides);

} // namespace asperity::meshes
