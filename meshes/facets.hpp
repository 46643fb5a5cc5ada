#pragma once

// The facets of the cells of a mesh, and those of them that form its boundary.

#include "meshes/block_mesh.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity::meshes {

/// A face of a cell: a quadrilateral or, with the last vertex 0, a triangle.
struct Facet {
  std::array<unsigned int, 4> vertices{}; ///< in the order of BoundaryFace
  std::size_t cell = 0;
};

/// Number of vertices of a facet: 3 for a tetrahedron, 4 for a hexahedron.
std::size_t vertices_per_facet(CellShape shape);

/// Number of vertices of a cell: 4 for a tetrahedron, 8 for a hexahedron.
std::size_t vertices_per_cell(CellShape shape);

/// A key that is equal for every order of the same vertices.
std::array<unsigned int, 4> facet_key(CellShape shape,
                                      std::array<unsigned int, 4> vertices);

/// The facets that belong to only one cell, in the order of their cells.
///
/// @param mesh  its cells must refer to existing vertices; its faces are not
///              read
/// @throws std::domain_error  a facet belongs to three or more cells; the
///                            message names it
std::vector<Facet> boundary_facets(const BlockMesh& mesh);

/// The mean of a cell's vertices [m].
Place centre_of_cell(const BlockMesh& mesh, std::size_t cell);

/// The mean of a facet's vertices [m].
Place centre_of_facet(const BlockMesh& mesh,
                      const std::array<unsigned int, 4>& vertices);

/// Whether all vertices of a facet have this coordinate, within a tolerance
/// [m].
bool lies_on_plane(const BlockMesh& mesh, const Facet& facet,
                   std::size_t direction, double coordinate,
                   double tolerance = 0.0);

/// The lateral side of the block on which all vertices of a facet lie, within a
/// tolerance [m]: left and right at x = 0 and length_x, front and back at y = 0
/// and length_y. The result is empty if the facet lies on no side.
std::optional<FaceGroup> lateral_side_of(const BlockMesh& mesh,
                                         const Facet& facet, double tolerance);

/// Area of the faces of the group contact, which must be flat [m^2].
double contact_area(const BlockMesh& mesh);

/// Formats a place for messages, such as "(1e-07, 2e-07, 0) m".
std::string place_text(const Place& place);

} // namespace asperity::meshes
