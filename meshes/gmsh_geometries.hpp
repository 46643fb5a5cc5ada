#pragma once

// Private to gmsh_block.cpp: the geometries, inside in_gmsh, in units in which
// the block is about one long (gmsh's tolerances are absolute).

#include "meshes/gmsh_block.hpp"

namespace asperity::meshes {

/// Meshes the block as the current model of gmsh, with one physical volume a
/// group of cells; its vertices lie on the planes to rounding.
void make_hexahedra(const GmshBlock& block);
void make_tetrahedra(const GmshBlock& block);

/// The groups' names, in order.
std::vector<std::string> group_names_of(const GmshBlock& block);

/// 0, the interfaces, the depth.
std::vector<double> depths_of(const GmshBlock& block);

/// Where the size of cells has grown linearly from the contact face to depth z.
double size_at_depth(const GmshBlock& block, double z);

} // namespace asperity::meshes
