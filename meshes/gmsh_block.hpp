#pragma once

// Blocks meshed by gmsh from a few numbers: what they are, how fine and where.

#include "cases/types/block_spec.hpp"
#include "meshes/block_mesh.hpp"

#include <vector>

namespace asperity::meshes {

/// A box 0..length_x, 0..length_y, 0..depth, its contact face at z = 0, and
/// what is in it. Sizes are edges of cells: the largest at the contact face,
/// and what they grow to with the distance.
struct GmshBlock {
  cases::MeshGeometry geometry = cases::MeshGeometry::block; ///< but not file
  cases::MeshCells cells = cases::MeshCells::hexahedra;
  double length_x = 0.0;        ///< [m] > 0
  double length_y = 0.0;        ///< [m] > 0
  double depth = 0.0;           ///< [m] > 0
  double size_at_contact = 0.0; ///< [m] > 0, at most a quarter of each extent
  double size_far = 0.0;        ///< [m] >= size_at_contact
  bool is_periodic = true;      ///< opposite sides of tetrahedra match too

  /// indentation: cells are of size_at_contact in the half ball of this radius
  /// about the middle of the contact face [m], 1..0.8 times the smallest of
  /// depth, length_x / 2 and length_y / 2.
  double fine_radius = 0.0;
  /// layered: depths of the flat interfaces [m], rising, inside the block.
  std::vector<double> interfaces;
  /// inclusion: a ball under the middle of the contact face, wholly inside.
  double inclusion_radius = 0.0; ///< [m]
  double inclusion_depth = 0.0;  ///< of its centre [m]
};

/// The mesh. Groups of cells: "block", or "layer 1", "layer 2"... from the
/// contact face down, or "block" and "inclusion".
///
/// Hexahedra are transfinite blocks. block and layered are columns of equal
/// width, their layers growing by (M.5) from the contact face to the far one.
/// indentation has a cube of equal cells under the contact, around which five
/// blocks fan out to the sides and the bottom: cells are size_far long there
/// along the fan, and across it as many as in the cube. inclusion has a cube
/// in the ball, six blocks between them and six from the ball to a cubic box
/// around it, which columns and layers surround.
///
/// Tetrahedra are gmsh's own (Delaunay), their size growing linearly with the
/// depth (block, layered, inclusion) or with the distance from the fine half
/// ball (indentation); near an inclusion they are at most a third of its
/// radius.
///
/// Every plane (sides, contact face, interfaces) is met to the bit. The same
/// numbers give the same mesh, bit for bit. Safe to call from many threads,
/// which then wait for one another.
///
/// @throws std::domain_error  an argument is outside its range; gmsh gives up
///                            (in its words); the mesh it made is not sound
/// @par Accuracy
///            The ball is a polyhedron with its vertices on the sphere: second
///            order in the size of the cells.
BlockMesh gmsh_block(const GmshBlock& block);

} // namespace asperity::meshes
