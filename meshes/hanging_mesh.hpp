#pragma once

// Cubes that double in size away from the contact face, joined by hanging
// nodes: the cheapest structured way to a deep block under a fine face.

#include "base/grid.hpp"
#include "meshes/block_mesh.hpp"

namespace asperity::meshes {

/// A coarse mesh of equal boxes, nearly cubes, and the depths above which to
/// cut it. With h the edge of the face's cells, in units of which all follows,
/// level l = 0..n-1 has cells of edge 2^l and reaches down to
///
///     d_l = smallest multiple of 2^(l+1) with d_l - d_(l-1) >= m 2^l,   (M.6)
///
/// d_(-1) = 0: at least m cells a level through its thickness, at most one
/// more (for m = 4 only the third level has five). Below d_(n-1) are the
/// coarse cells of edge 2^n. There are as many levels as leave the coarse
/// cells m deep and two a side; none, when the block is that shallow.
///
/// Every box has the same shape: cell edges along z are those along x times
/// depth / (n_z H), H the mean coarse edge and n_z = round(depth / H), so that
/// the face's cells are cubes to 1 / (2 m).
///
/// @param face  a point a cell of the contact face after cutting; both
///              counts even, best a power of two times a small number
/// @param depth of the block                                     [m]  > 0
/// @param cells_a_level  m                                       [1]  1..64
/// @return      the coarse mesh with refine_below = d_(n-1), ..., d_0 [m]; its
///              vertices and cells are those of layered_mesh
/// @throws std::domain_error  an argument is outside its range, or a count of
///                            the face is odd
/// @par Accuracy
///              What doubling the cells costs falls quickly with m: the finite
///              elements' tests hold it against the uniform mesh.
BlockMesh hanging_mesh(const Grid& face, double depth, int cells_a_level);

} // namespace asperity::meshes
