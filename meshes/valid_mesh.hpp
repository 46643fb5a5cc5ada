#pragma once

// Checks of a mesh from a file before the solve, with messages that name the
// defect.

#include "mechanics/mesh_spec.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Requires a mesh that is valid for the finite elements, and aligns the sides
/// of a periodic block: right faces become left faces shifted by length_x along
/// x, and back faces front faces shifted by length_y along y. Opposite vertices
/// may differ by 1e-6 of the block's largest extent, because files have few
/// digits and gmsh integrates graded curves to about 1e-8; other places are
/// considered equal within 1e-9 of it.
///
/// @throws std::domain_error  naming the first of these defects that is found:
///   - an inverted or flat cell: cell_shape below 1e-6, by number and place;
///   - two vertices at one place (parts not joined);
///   - a contact surface that is not flat at z = 0: the vertex and its offset;
///   - a vertex on the wrong side of the contact surface, z < 0;
///   - a cell that is not connected to any face of the group fixed;
///   - with periodic sides: a side without faces, a vertex of one without a
///     partner on the other, or matching vertices whose partners form no face.
void fit_sides(BlockMesh& mesh, mechanics::BlockSides sides);

/// Accepts a mesh whose faces of the group fixed are a plane of constant z.
/// @throws std::domain_error  naming a vertex of it and its offset
void require_flat_support(const BlockMesh& mesh);

/// Refuses an inverted or flat cell.
/// @throws std::domain_error  naming its number and place
void require_positive_cells(const BlockMesh& mesh);

} // namespace asperity::meshes
