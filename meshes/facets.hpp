#pragma once

// The facets of a mesh's cells, and which of them are its boundary.

#include "meshes/block_mesh.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity::meshes {

/// A side of a cell: a quadrilateral or, with the last vertex 0, a triangle.
struct Facet {
  std::array<unsigned int, 4> vertices{}; ///< in the order of BoundaryFace
  std::size_t cell = 0;
};

/// 3 for a tetrahedron's, 4 for a hexahedron's.
std::size_t vertices_a_facet(CellShape shape);

/// 4 for a tetrahedron, 8 for a hexahedron.
std::size_t vertices_a_cell(CellShape shape);

/// The same for every order of the same vertices.
std::array<unsigned int, 4> facet_key(CellShape shape,
                                      std::array<unsigned int, 4> vertices);

/// The facets that belong to one cell only, in the order of their cells.
///
/// @param mesh  its cells must name vertices there are; faces are not read
/// @throws std::domain_error  a facet belongs to three cells or more: named
std::vector<Facet> boundary_facets(const BlockMesh& mesh);

/// The mean of a cell's vertices [m].
Place centre_of_cell(const BlockMesh& mesh, std::size_t cell);

/// The mean of a facet's vertices [m].
Place centre_of_facet(const BlockMesh& mesh,
                      const std::array<unsigned int, 4>& vertices);

/// "(1e-07, 2e-07, 0) m", for messages.
std::string place_text(const Place& place);

} // namespace asperity::meshes
