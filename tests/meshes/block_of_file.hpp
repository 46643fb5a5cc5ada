#pragma once

// A mesh file as a block uses it, for the tests of meshes.

#include "meshes/mesh_file.hpp"

#include <string>

namespace asperity::meshes::test {

inline BlockMesh block_of_file(const std::string& path, double unit,
                               mechanics::BlockSides sides,
                               const MeshFileLimits& limits = {}) {
  BlockMesh mesh = read_mesh_file({path, unit}, limits).mesh;
  fit_sides(mesh, sides);
  return mesh;
}

} // namespace asperity::meshes::test
