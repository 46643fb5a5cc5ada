#pragma once

// Serialisation of a mesh for another process of this program. This file
// defines the order of the bytes, which is not a file format: it changes with
// the program.

#include "meshes/block_mesh.hpp"

#include <string>
#include <string_view>

namespace asperity::meshes {

/// Serialises the complete mesh, bit for bit.
std::string bytes_of(const BlockMesh& mesh);

/// @throws std::runtime_error  the bytes end early or continue after the mesh
BlockMesh mesh_of_bytes(std::string_view bytes);

} // namespace asperity::meshes
