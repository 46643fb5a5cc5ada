#pragma once

// What to know of a mesh before the solve: how many cells, how large, how good.

#include "meshes/block_mesh.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity::meshes {

/// Lengths of cell edges [m].
struct EdgeRange {
  double smallest = 0.0;
  double largest = 0.0;
};

/// After the cuts of refine_below.
struct MeshQuality {
  CellShape shape = CellShape::hexahedron;
  std::size_t n_cells = 0;
  std::size_t n_vertices = 0;      ///< hanging ones too
  std::size_t n_contact_faces = 0; ///< of the group contact
  EdgeRange edges;                 ///< of all cells
  EdgeRange contact_edges;         ///< of the contact faces
  double smallest_shape = 0.0;     ///< cell_shape of the worst cell
  double mean_shape = 0.0;         ///< mean of cell_shape over the cells
  std::size_t worst_cell = 0;      ///< its number, after the cuts
  Place worst_place{};             ///< mean of its vertices [m]
  std::vector<std::string> group_names;
  std::vector<std::size_t> cells_a_group;
};

/// How near a cell is to a cube or to a regular tetrahedron: 1 for those, 0
/// for a flat cell, negative for an inverted one. With e_i the edges that meet
/// at a corner, V the volume and l_i the six edges' lengths,
///
///     hexahedron:  min over the corners of det(e_1, e_2, e_3)
///                  / (|e_1| |e_2| |e_3|), the scaled Jacobian          (M.3)
///     tetrahedron: sign(V) 12 (3 |V|)^(2/3) / (l_1^2 + ... + l_6^2),
///                  the mean ratio                                      (M.4)
///
/// A box of any proportions has scaled Jacobian 1: it sees skew, not stretch.
/// @see  P. M. Knupp, Finite Elem. Anal. Des. 39, 217 (2003), for both.
double cell_shape(const BlockMesh& mesh, std::size_t cell);

/// @throws std::domain_error  the mesh has no cells
MeshQuality mesh_quality(const BlockMesh& mesh);

/// Three lines for people, without a line break at the end.
std::string quality_text(const MeshQuality& quality);

} // namespace asperity::meshes
