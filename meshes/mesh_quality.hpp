#pragma once

// Summary of a mesh before the solve: the number, size and quality of its
// cells.

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

/// Quality of a mesh after the refinement of refine_below, which only equal
/// boxes have.
struct MeshQuality {
  CellShape shape = CellShape::hexahedron;
  std::size_t n_cells = 0;
  std::size_t n_vertices = 0;      ///< includes hanging nodes
  std::size_t n_contact_faces = 0; ///< faces of the group contact
  EdgeRange edges;                 ///< of all cells
  EdgeRange contact_edges;         ///< of the faces of the group contact
  double smallest_shape = 0.0;     ///< cell_shape of the worst cell
  double mean_shape = 0.0;         ///< mean of cell_shape over the cells
  std::size_t worst_cell = 0;      ///< its number after refinement
  Place worst_place{};             ///< mean of its vertices [m]
  std::vector<std::string> group_names;
  std::vector<std::size_t> cells_per_group;
};

/// Shape quality of a cell: 1 for a cube or a regular tetrahedron, 0 for a flat
/// cell, negative for an inverted one. With the edges e_i that meet at a
/// corner, the volume V and the lengths l_i of the six edges,
///
///     hexahedron:  min over the corners of det(e_1, e_2, e_3)
///                  / (|e_1| |e_2| |e_3|), the scaled Jacobian          (M.3)
///     tetrahedron: sign(V) 12 (3 |V|)^(2/3) / (l_1^2 + ... + l_6^2),
///                  the mean ratio                                      (M.4)
///
/// A box of any aspect ratio has scaled Jacobian 1: the measure detects
/// skewness, not stretching.
/// @see  P. M. Knupp, Finite Elem. Anal. Des. 39, 217 (2003), for both.
double cell_shape(const BlockMesh& mesh, std::size_t cell);

/// @throws std::domain_error  the mesh has no cells
MeshQuality mesh_quality(const BlockMesh& mesh);

/// A description in three lines, without a line break at the end.
std::string quality_text(const MeshQuality& quality);

} // namespace asperity::meshes
