#pragma once

// Structured hexahedra: equal columns over the contact surface, divided into
// layers.

#include "base/grid.hpp"
#include "meshes/block_mesh.hpp"

#include <vector>

namespace asperity::meshes {

/// Generates boxes in points_x times points_y equal columns, divided into
/// layers. Vertices and cells are numbered x fastest, then y, then z; all cells
/// are in group 0. Opposite sides match vertex to vertex, so the block may be
/// periodic.
///
/// @param face       grid of the contact surface with one point per cell; both
///                   lengths [m]
/// @param thickness  thicknesses of the layers, starting at the contact surface
///                   [m] > 0
/// @return           a mesh with depth = sum of the thicknesses; x, y and z of
///                   the outermost vertices are exactly 0, the lengths and the
///                   depth
/// @throws std::domain_error  an argument is outside its range, or the mesh
///                            would have more than 2^31 vertices
BlockMesh layered_mesh(const Grid& face, const std::vector<double>& thickness);

} // namespace asperity::meshes
