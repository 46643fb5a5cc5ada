#pragma once

// A meshed block as plain data: what every mesh of this room is made as and
// what the finite elements read. Nothing of gmsh or deal.II shows here.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity::meshes {

using Place = std::array<double, 3>;

enum class CellShape { hexahedron, tetrahedron };

/// What a face of the block's boundary is for.
enum class FaceGroup {
  contact, ///< z = 0, outer normal -z
  fixed,   ///< what holds the block: the plane of largest z
  left,    ///< x = 0
  right,   ///< x = length_x
  front,   ///< y = 0
  back,    ///< y = length_y
  sides,   ///< of a block that is no box
};

struct BoundaryFace {
  /// Vertices; hexahedra's in the order (0,0), (1,0), (0,1), (1,1) of the
  /// face's own two directions; a tetrahedron's has three, the fourth is 0.
  std::array<unsigned int, 4> vertices{};
  FaceGroup group = FaceGroup::sides;
};

/// Cells between the contact face z = 0 and the top, z into the block. The
/// makers of this room leave no vertex without a cell and no place with two
/// vertices; mesh_quality.hpp checks a mesh from elsewhere.
struct BlockMesh {
  CellShape shape = CellShape::hexahedron;
  std::vector<Place> vertices; ///< [m]
  /// Vertices of each cell: a hexahedron's with x fastest, then y, then z of
  /// its own right-handed directions (deal.II's order); a tetrahedron's four,
  /// the Jacobian of (v1 - v0, v2 - v0, v3 - v0) positive.
  std::vector<std::array<unsigned int, 8>> cells;
  std::vector<int> cell_group; ///< index into group_names, one a cell
  std::vector<std::string> group_names = {"block"}; ///< of volumes
  std::vector<BoundaryFace> faces; ///< every face of the boundary, once

  /// Hanging nodes: for each depth [m] in turn, the largest first, every cell
  /// whose centre lies above it (z less than the depth) is cut into eight at
  /// the means of its vertices. Hexahedra only.
  std::vector<double> refine_below = {};

  double length_x = 0.0; ///< [m] of the box, or of the contact face's bounds
  double length_y = 0.0; ///< [m]
  double depth = 0.0;    ///< [m]
};

} // namespace asperity::meshes
