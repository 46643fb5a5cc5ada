#pragma once

// Check of whether a block can be periodic: opposite sides must be translates
// of each other.

#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Accepts a mesh whose right faces are its left faces shifted by length_x
/// along x, and whose back faces are its front faces shifted by length_y along
/// y: vertex to vertex within 1e-9 of the block's largest extent, and face to
/// face.
///
/// @throws std::domain_error  a side has no faces; a vertex of either side has
///                            no partner on the other (the message gives its
///                            place); or the vertices match, but the partners
///                            of a face's vertices form no face
void require_matching_sides(const BlockMesh& mesh);

/// Moves the vertices of the right and back sides to the places of their
/// partners shifted by one period, so that require_matching_sides accepts the
/// mesh. It is meant for meshes that are written with few digits, or that have
/// graded curves of gmsh, which gmsh integrates to about 1e-8.
///
/// @throws std::domain_error  as require_matching_sides, but for vertices that
///                            differ by more than 1e-6 of the block's largest
///                            extent
void align_sides(BlockMesh& mesh);

} // namespace asperity::meshes
