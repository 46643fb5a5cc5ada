#pragma once

// Blocks meshed by gmsh from a few parameters: the geometry, the cell sizes and
// where they apply.

#include "base/grid.hpp"
#include "mechanics/material.hpp"
#include "mechanics/mesh_spec.hpp"
#include "mechanics/quantity.hpp"
#include "meshes/block_mesh.hpp"

#include <vector>

namespace asperity::meshes {

/// A box 0..length_x, 0..length_y, 0..depth with its contact surface at z = 0,
/// and its contents. Sizes are edge lengths of cells: the largest at the
/// contact surface, and the one to which cells grow with the distance from it.
struct GmshBlock {
  mechanics::MeshGeometry geometry =
      mechanics::MeshGeometry::block; ///< any value
                                      ///< except file
  double length_x = 0.0;              ///< [m] > 0
  double length_y = 0.0;              ///< [m] > 0
  double depth = 0.0;                 ///< [m] > 0
  double size_at_contact = 0.0; ///< [m] > 0, at most a quarter of each extent
  double size_far = 0.0;        ///< [m] >= size_at_contact

  /// indentation: cells have size_at_contact in the cube of this half width
  /// around the centre of the contact surface [m]. It must lie between
  /// size_at_contact and 0.8 times the smallest of depth, length_x / 2 and
  /// length_y / 2.
  double fine_radius = 0.0;
  /// layered: depths of the flat interfaces [m], increasing, inside the block.
  std::vector<double> interfaces;
  /// inclusion: a ball below the centre of the contact surface, entirely inside
  /// the block.
  double inclusion_radius = 0.0; ///< [m]
  double inclusion_depth = 0.0;  ///< of its centre [m]
};

/// Depths of the interfaces between the layers of a material [m].
std::vector<double>
interfaces_of(const std::vector<mechanics::MaterialLayer>& layers,
              const mechanics::Scales& scales);

/// Returns the parameters of the block of a case.
/// @param depth  of the block [m]
/// @param grid   of the surface
GmshBlock gmsh_parameters(const mechanics::MeshSpec& spec,
                          const mechanics::MaterialSpec& material, double depth,
                          const Grid& grid, const mechanics::Scales& scales);

/// @throws std::domain_error  a parameter is outside its range
void require_gmsh_block(const GmshBlock& block);

/// Number of nodes of the mesh of a block for elements of this degree [1].
/// Needs no gmsh and no mesh.
/// @param block  that require_gmsh_block() permits
double gmsh_nodes(const GmshBlock& block, int degree);

/// Generates the mesh. The groups of cells are "block"; or "layer 1", "layer
/// 2", ... from the contact surface inwards; or "block" and "inclusion".
///
/// Hexahedra form transfinite blocks. The geometries block and layered have
/// columns of equal width, with layers growing by (M.5) from the contact
/// surface to the far boundary. The geometry indentation has a cube of equal
/// cells below the contact, from which five blocks fan out to the sides and the
/// bottom: at the outer end of the fan cells have length size_far along the
/// fan, and their number across it is that of the cube. The geometry inclusion
/// has a cube inside the ball, six blocks between the two, and six blocks
/// between the ball and a cubic box around it, which is surrounded by columns
/// and layers.
///
/// Vertices lie exactly on every plane (sides, contact surface, interfaces).
/// Equal parameters give bitwise equal meshes. The function is thread-safe;
/// concurrent calls are executed one after the other.
///
/// @throws std::domain_error  an argument is outside its range, gmsh fails
///                            (with its own message), or a cell is inverted or
///                            flat
/// @par Accuracy
///            The ball is a polyhedron with its vertices on the sphere, which
///            is second order in the size of the cells.
BlockMesh gmsh_block(const GmshBlock& block);

} // namespace asperity::meshes
