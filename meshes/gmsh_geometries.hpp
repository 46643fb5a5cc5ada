#pragma once

// The geometries, private to gmsh_block.cpp. Functions are called inside
// in_gmsh, in units in which the largest extent of the block is one, because
// gmsh's tolerances are absolute.

#include "meshes/gmsh_block.hpp"

namespace asperity::meshes {

/// Meshes the block as the current model of gmsh, with one physical volume per
/// group of cells. Vertices lie on the planes up to roundoff.
void make_hexahedra(const GmshBlock& block);
void make_tetrahedra(const GmshBlock& block);

/// The names of the groups, in order.
std::vector<std::string> group_names_of(const GmshBlock& block);

/// Depths of the planes: 0, the interfaces, the depth of the block.
std::vector<double> depths_of(const GmshBlock& block);

/// The cell size at depth z, which grows linearly from the contact surface to
/// the far boundary.
double size_at_depth(const GmshBlock& block, double z);

} // namespace asperity::meshes
