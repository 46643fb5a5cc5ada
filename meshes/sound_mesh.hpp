#pragma once

// The gate between a mesh and the solve: what is wrong with it, by name.

#include "cases/types/block_spec.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Accepts a mesh the finite elements can take; lengths are equal and places
/// the same when they differ by at most 1e-9 of the block's largest extent.
///
/// @throws std::domain_error  naming the first of these that is found:
///   - no cells, or lists that don't fit together (a vertex or group there is
///     none of, a coordinate that is not finite), by number;
///   - a cell inverted or flat: cell_shape below 1e-6, by number and place;
///   - a vertex of no cell; two vertices at one place (parts not joined);
///   - a face that is no boundary facet or is listed twice; a boundary facet
///     in no group; a facet of three cells;
///   - no face of the group contact, or of the group fixed;
///   - the contact face not flat at z = 0: the vertex and how far it is off;
///   - a vertex on the wrong side of the contact face, z < 0;
///   - a cell that hangs together with no fixed face;
///   - cuts for hanging nodes of tetrahedra;
///   - for periodic sides: those of require_matching_sides.
void require_sound(const BlockMesh& mesh, cases::BlockSides sides);

} // namespace asperity::meshes
