#pragma once

// A user's file read or meshed by gmsh in the calling process. The program
// asperity_mesh uses it on behalf of mesh_file.hpp.

#include "meshes/block_mesh.hpp"

#include <functional>
#include <string>

namespace asperity::meshes {

/// The mesh of a file, scaled and placed as read_mesh_file describes it. The
/// file may occupy gmsh forever, use up all memory, or end the process.
///
/// @param path   gmsh decides by its content what it is
/// @param unit   metres per unit of the file [m] > 0
/// @param begin  called before gmsh opens the file
/// @throws std::domain_error  as read_mesh_file, without the name of the file
BlockMesh gmsh_file(
    const std::string& path, double unit,
    const std::function<void()>& begin = [] {});

} // namespace asperity::meshes
