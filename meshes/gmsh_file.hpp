#pragma once

// A user's file read or meshed by gmsh in the calling process. The program
// asperity_mesh uses it on behalf of mesh_file.hpp.

#include "mechanics/fem_settings.hpp"
#include "meshes/block_mesh.hpp"

#include <string>

namespace asperity::meshes {

/// As read_mesh_file, but without its limits: a file may occupy gmsh forever,
/// use up all memory, or end the process.
BlockMesh gmsh_file(const std::string& path, double unit,
                    mechanics::BlockSides sides);

} // namespace asperity::meshes
