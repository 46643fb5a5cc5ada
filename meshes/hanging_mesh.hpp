#pragma once

// Cubes that double in size away from the contact surface, connected by hanging
// nodes: the most economical structured mesh of a deep block with a fine
// contact surface.

#include "base/grid.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// Generates equal boxes that are nearly cubes: round(depth / H) layers, at
/// least one, where H is the mean of the two spacings of `face`.
/// @param face   grid with one point per cell of the contact surface
/// @param depth  depth of the block [m] > 0
/// @throws std::domain_error  an argument is outside its range
BlockMesh equal_boxes(const Grid& face, double depth);

/// Generates a coarse mesh of equal boxes, nearly cubes, and the depths above
/// which they are refined. In units of the edge h of the cells at the contact
/// surface, level l = 0..n-1 has cells of edge 2^l and extends down to
///
///     d_l = smallest multiple of 2^(l+1) with d_l - d_(l-1) >= m 2^l,   (M.6)
///
/// where d_(-1) = 0. Each level is therefore at least m and at most m + 1 cells
/// thick (for m = 4 only the third level has five). Below d_(n-1) are the
/// coarse cells of edge 2^n. The number of levels is the largest for which at
/// least m coarse cells remain in depth and two per side; it is zero if the
/// block is too shallow.
///
/// All boxes have the same shape: cell edges along z are those along x times
/// depth / (n_z H), where H is the mean coarse edge and n_z = round(depth / H),
/// so the cells at the contact surface are cubes to within 1 / (2 m).
///
/// @param face           grid with one point per cell of the contact surface
///                       after refinement; both counts must be even and are
///                       best a power of two times a small number
/// @param depth          depth of the block [m] > 0
/// @param cells_a_level  m [1] 1..64
/// @return               the coarse mesh with refine_below = d_(n-1), ..., d_0
///                       [m]; its vertices and cells are those of layered_mesh
/// @throws std::domain_error  an argument is outside its range, or a count of
///                            `face` is odd
/// @par Accuracy
///              The error caused by doubling the cells decreases quickly with
///              m; the tests of the finite-element module compare with the
///              uniform mesh.
BlockMesh hanging_mesh(const Grid& face, double depth, int cells_a_level);

/// Number of nodes of elements of this degree in hanging_mesh(), hanging ones
/// included [1]. Makes no mesh.
/// @throws std::domain_error  as hanging_mesh()
double hanging_nodes(const Grid& face, double depth, int cells_a_level,
                     int degree);

/// The grid with one point per column of halvable_boxes().
/// @throws std::domain_error  as halvable_boxes()
Grid halvable_columns(const Grid& nodes, int degree, int halvings);

/// The coarsest boxes of a mesh whose cells are halved where the solution
/// requires it, until the nodes of the contact surface are those of the grid.
///
/// @param nodes       grid with one point per node of the contact surface
/// @param degree      of the elements, 1 or 2
/// @param halvings    how often the cells can be halved, 1..12
/// @param interfaces  depths of planes between cells [m], increasing
/// @param depth       depth of the block [m] > 0
/// @throws std::domain_error  an argument is outside its range, or the points
///                            per side are no multiple of 2^halvings * degree,
///                            at least twice
BlockMesh halvable_boxes(const Grid& nodes, int degree, int halvings,
                         const std::vector<double>& interfaces, double depth);

} // namespace asperity::meshes
