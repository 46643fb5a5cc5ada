#pragma once

// A user's file read or meshed by gmsh in this very process: what asperity_mesh
// does for mesh_file.hpp.

#include "cases/types/block_spec.hpp"
#include "meshes/block_mesh.hpp"

#include <string>

namespace asperity::meshes {

/// As read_mesh_file, but for its limits: a file may keep gmsh busy for ever or
/// take all memory, and may end the process.
BlockMesh gmsh_file(const std::string& path, double unit,
                    cases::BlockSides sides);

} // namespace asperity::meshes
