#pragma once

// The geometries, private to this module. Lengths are in units in which the
// largest extent of the block is one, because gmsh's tolerances are absolute.

#include "meshes/gmsh_block.hpp"
#include "meshes/transfinite_blocks.hpp"

namespace asperity::meshes {

/// The largest extent of a block [m].
double largest_extent(const GmshBlock& block);

/// The block with every length divided by `unit`.
GmshBlock in_units_of(GmshBlock block, double unit);

/// The hexahedra of the block. Vertices lie on the planes up to roundoff.
TransfiniteBlocks hexahedra_of(const GmshBlock& block);

/// The names of the groups, in order.
std::vector<std::string> group_names_of(const GmshBlock& block);

/// Depths of the planes: 0, the interfaces, the depth of the block.
std::vector<double> depths_of(const GmshBlock& block);

/// The cell size at depth z, which grows linearly from the contact surface to
/// the far boundary.
double size_at_depth(const GmshBlock& block, double z);

} // namespace asperity::meshes
