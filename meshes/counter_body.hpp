#pragma once

// Meshes of a counter-body of finite size: a half ball, a cap of one, or an
// upright column, of hexahedra in a conforming mesh without hanging nodes.

#include "mechanics/counter_body.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

using mechanics::CounterBody;

/// Meshes the body. The faces of its end are the group contact, those of its
/// base z = -height the group far_boundary, and all others the group sides.
/// `length_x` and `length_y` of the mesh are the widths of the body, `depth`
/// its height.
///
/// A box of n x n x m cells with edges of size_at_contact lies at the centre of
/// the end, at least as wide as the fine region unless cells of this size do
/// not fit so often into 0.4 times the width of a ball, half the width of a
/// column, and half the height. Without a fine region (fine_radius of at least
/// half the radius, and never for a ball) it reaches down to the base in layers
/// that grow, and from side to side; a cylinder has a ring of cells around it.
/// With a fine region five blocks fan out from the box to the base and to the
/// sides, and have as many cells across as the box, so that the cells widen in
/// proportion.
///
/// A ball is the exact one, z = -(R - sqrt(R^2 - r^2)) at the vertices of its
/// end.
///
/// @throws std::domain_error  a number is outside of its range, or a cell is
///                            inverted or flat
BlockMesh counter_body(const CounterBody& body);

/// Number of nodes of elements of this degree in counter_body() [1]. Makes no
/// mesh.
/// @throws std::domain_error  a number is outside of its range
double counter_nodes(const CounterBody& body, int degree);

} // namespace asperity::meshes
