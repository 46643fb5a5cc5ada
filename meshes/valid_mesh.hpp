#pragma once

// Validity check of a mesh before the solve, with messages that name the
// defect.

#include "mechanics/fem_settings.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Accepts a mesh that is valid for the finite elements. Lengths and places are
/// considered equal if they differ by at most 1e-9 of the block's largest
/// extent.
///
/// @throws std::domain_error  naming the first of these defects that is found:
///   - no cells, or inconsistent lists (a vertex or group that does not
///     exist, a coordinate that is not finite), by number;
///   - an inverted or flat cell: cell_shape below 1e-6, by number and place;
///   - a vertex without a cell; two vertices at one place (parts not joined);
///   - a face that is not a boundary facet or is listed twice; a boundary
///     facet in no group; a facet of three cells;
///   - no face of the group contact, or of the group fixed;
///   - a contact surface that is not flat at z = 0: the vertex and its offset;
///   - a vertex on the wrong side of the contact surface, z < 0;
///   - a cell that is not connected to any face of the group fixed;
///   - refinement with hanging nodes for tetrahedra;
///   - for periodic sides: the errors of require_matching_sides.
void require_valid_mesh(const BlockMesh& mesh, mechanics::BlockSides sides);

/// Accepts a mesh whose faces of the group fixed are a plane of constant z.
/// @throws std::domain_error  naming a vertex of it and its offset
void require_flat_support(const BlockMesh& mesh);

/// Refuses an inverted or flat cell as require_valid_mesh does.
/// @throws std::domain_error  naming its number and place
void require_positive_cells(const BlockMesh& mesh);

} // namespace asperity::meshes
