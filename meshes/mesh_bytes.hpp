#pragma once

// A mesh on its way to another process of this program. Owns the order of its
// bytes, which is no file format: it changes with the program.

#include "meshes/block_mesh.hpp"

#include <string>
#include <string_view>

namespace asperity::meshes {

/// All of the mesh, bit for bit.
std::string bytes_of(const BlockMesh& mesh);

/// @throws std::runtime_error  the bytes end early or go on after the mesh
BlockMesh mesh_of_bytes(std::string_view bytes);

} // namespace asperity::meshes
