#pragma once

// Plain data of a meshed block: the output of every mesh generator in this
// module and the input of the finite-element module. This header depends on
// neither gmsh nor deal.II.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity::meshes {

using Place = std::array<double, 3>;

enum class CellShape { hexahedron, tetrahedron };

/// The role of a face on the block's boundary.
enum class FaceGroup {
  contact, ///< z = 0, outer normal -z
  /// The support of the block: the plane of largest z.
  far_boundary,
  left,  ///< x = 0
  right, ///< x = length_x
  front, ///< y = 0
  back,  ///< y = length_y
  sides, ///< lateral sides of a block that is not a box
};

struct BoundaryFace {
  /// The vertices. For hexahedra the order is (0,0), (1,0), (0,1), (1,1) in the
  /// face's own two directions; for tetrahedra there are three and the fourth
  /// is 0.
  std::array<unsigned int, 4> vertices{};
  FaceGroup group = FaceGroup::sides;
};

/// Cells between the contact surface z = 0 and the far boundary, with z
/// pointing into the block. The generators of this module leave no vertex
/// without a cell and no two vertices at one place; mesh_quality.hpp checks a
/// mesh from another source.
struct BlockMesh {
  CellShape shape = CellShape::hexahedron;
  std::vector<Place> vertices; ///< [m]
  /// Vertices of each cell: those of a hexahedron with x fastest, then y, then
  /// z of its own right-handed directions (deal.II's order); the four of a
  /// tetrahedron such that the Jacobian of (v1 - v0, v2 - v0, v3 - v0) is
  /// positive.
  std::vector<std::array<unsigned int, 8>> cells;
  std::vector<int> cell_group; ///< index into group_names, one per cell
  std::vector<std::string> group_names = {"block"}; ///< names of volume groups
  std::vector<BoundaryFace> faces; ///< every face of the boundary, once

  /// Refinement with hanging nodes: for each depth [m] in turn, starting with
  /// the largest, every cell whose centre lies above it (z less than the depth)
  /// is cut into eight at the means of its vertices. Hexahedra only.
  std::vector<double> refine_below = {};

  double length_x = 0.0; ///< of the box or of the bounding box of the contact
                         ///< surface [m]
  double length_y = 0.0; ///< [m]
  double depth = 0.0;    ///< [m]
};

} // namespace asperity::meshes
