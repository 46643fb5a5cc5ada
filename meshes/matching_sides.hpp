#pragma once

// Whether a block can be periodic: opposite sides are one another, moved.

#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Accepts a mesh whose faces right are its faces left moved by length_x along
/// x, and back those of front moved by length_y along y: vertex to vertex to
/// 1e-9 of the block's largest extent, and face to face.
///
/// @throws std::domain_error  a side has no faces; a vertex of either side has
///                            no partner on the other (its place is named); the
///                            vertices match, but a face's partners are no face
void require_matching_sides(const BlockMesh& mesh);

/// Moves the vertices of right and back onto their partners' places, a period
/// on, so that require_matching_sides accepts them: for meshes of few digits,
/// or of gmsh's graded curves (which it integrates to about 1e-8).
///
/// @throws std::domain_error  as require_matching_sides, but for vertices more
///                            than 1e-6 of the block's largest extent apart
void align_sides(BlockMesh& mesh);

} // namespace asperity::meshes
