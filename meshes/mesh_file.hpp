#pragma once

// A mesh from a user's own file.

#include "cases/types/block_spec.hpp"
#include "meshes/block_mesh.hpp"

#include <cstdint>
#include <string>

namespace asperity::meshes {

/// What gmsh may take of the machine for one file.
struct MeshFileLimits {
  double wall_time = 600.0;                        ///< [s]
  std::uintmax_t memory = std::uintmax_t{8} << 30; ///< of address space [B]
};

/// Reads a .msh (2.2 or 4.1, ASCII or binary) or meshes a .geo with gmsh.
///
/// Cells are hexahedra of eight or tetrahedra of four vertices. The file names
/// physical surfaces: `contact`, flat with z constant, all of the block on one
/// side of it; `fixed`, which holds the block; and, if it likes, `sides`. What
/// else is boundary is a side too. Physical volumes become the groups of cells
/// in the order of their tags, with their names.
///
/// The mesh is scaled and moved so that the contact face is at z = 0 and its
/// bounds begin at x = y = 0; a block below its contact face is mirrored in z,
/// so that x and y stay those of the file. If every side is on one of the four
/// planes through the bounds of the contact face, sides are left, right, front
/// and back, and the block may be periodic.
///
/// A .geo is a program of gmsh's: read only those of people you trust. gmsh
/// runs in a process of its own (asperity_mesh), so a file that keeps it busy,
/// takes all memory or makes it crash is refused like any other bad file.
///
/// @param path   its ending says which it is
/// @param unit   metres a unit of the file                          [m]  > 0
/// @param sides  periodic: opposite sides must match to 1e-6 of the block, and
///               are then aligned
/// @return       length_x, length_y the bounds of the contact face, depth the
///               largest z
/// @throws std::domain_error  beginning with the path: no such file, another
///                            ending, gmsh's own words, a missing group (with
///                            the names there are), a contact face that is not
///                            flat (the vertex), all of require_sound, and a
///                            limit that gmsh exceeded
/// @throws std::runtime_error asperity_mesh is not there or cannot be started
BlockMesh read_mesh_file(const std::string& path, double unit,
                         cases::BlockSides sides,
                         const MeshFileLimits& limits = {});

} // namespace asperity::meshes
