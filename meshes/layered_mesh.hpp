#pragma once

// Structured hexahedra: equal columns over the contact face, cut by layers.

#include "base/grid.hpp"
#include "meshes/block_mesh.hpp"

#include <vector>

namespace asperity::meshes {

/// Boxes in points_x times points_y equal columns, cut by the layers. Vertices
/// and cells are numbered x fastest, then y, then z; all cells are of group 0.
/// Opposite sides match vertex to vertex, so the block may be periodic.
///
/// @param face      of the contact face: a point a cell, both lengths  [m]
/// @param thickness of the layers, the contact face's first            [m] > 0
/// @return          depth = sum of the thicknesses; x, y and z of the
///                  outermost vertices are 0, the lengths and the depth to
///                  the bit
/// @throws std::domain_error  an argument is outside its range, or the mesh
///                            would have more than 2^31 vertices
BlockMesh layered_mesh(const Grid& face, const std::vector<double>& thickness);

} // namespace asperity::meshes
