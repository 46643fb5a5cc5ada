#pragma once

// Represents one layer of cells as the coupling of its two bounding layers of
// atoms. It provides the stencil in real space, row by row of a grid, and its
// symbol for one lateral wavevector.

#include "md/lattice/crystal.hpp"

#include <array>
#include <cstddef>

namespace asperity::md {

/// Three planes x, y, z of one layer of atoms on an n_x by n_y grid, stored
/// contiguously with x fastest: displacements [m] or forces [N].
template <class Number>
struct AtomPlane {
  Number* values = nullptr; ///< 3 n_x n_y values
  int n_x = 0;
  int n_y = 0;

  std::size_t size() const {
    return static_cast<std::size_t>(n_x) * static_cast<std::size_t>(n_y);
  }

  Number* row(std::size_t axis, int iy) const {
    return values + axis * size() +
           static_cast<std::size_t>(iy) * static_cast<std::size_t>(n_x);
  }
};

/// The force on one layer of atoms due to the displacements of one layer (the
/// same or a neighbouring one):
///
///     f_i(r) = -sum_offset T_ij(offset) u_j(r + offset)
///
/// The sum is over the nine lateral offsets. The mirror planes of the crystal
/// make T_ij even or odd in each lateral direction: it is odd in x if exactly
/// one of i and j is x, and likewise for y. Two numbers per direction therefore
/// define T_ij.
class LayerCoupling {
public:
  /// Adds T_ij(dx, dy) for all i, j from the pairs of corners of the cell whose
  /// first corner lies in face `to` and whose second lies in face `from` (0
  /// lower, 1 upper).
  void add(const CellStiffness& cell, int to, int from, double factor);

  /// Adds the forces due to `displacements` to row iy of the three planes of
  /// `forces`.
  void add_forces(const AtomPlane<const double>& displacements, int iy,
                  const AtomPlane<double>& forces) const;

  /// Returns the 3 x 3 stiffness of the mode
  /// exp(i (theta_x j_x + theta_y j_y)), per atom [N/m], in row-major order and
  /// with the sign of a stiffness. It relates (-i F_x, -i F_y, F_z) to (-i u_x,
  /// -i u_y, u_z); with the factors -i the matrix is real.
  std::array<double, 9> symbol(double angle_x, double angle_y) const;

private:
  /// [i][j][|dy|][|dx|]; in an odd direction the entry is multiplied by the
  /// sign of the offset.
  using Entry = std::array<std::array<double, 2>, 2>;
  std::array<std::array<Entry, 3>, 3> entries_{};
};

/// All couplings of one layer of cells: forces on one face due to displacements
/// of a face.
struct SlabCouplings {
  LayerCoupling within_lower; ///< on the lower face, due to itself
  LayerCoupling within_upper; ///< on the upper face, due to itself
  LayerCoupling inside;       ///< sum of both, between two layers of cells
  LayerCoupling to_lower;     ///< on the lower face, due to the upper one
  LayerCoupling to_upper;     ///< on the upper face, due to the lower one
};

/// @param factor  factor by which all forces are multiplied
/// @throws std::domain_error  the cell is not mirror-symmetric in x and y
SlabCouplings slab_couplings(const CellStiffness& cell, double factor);

} // namespace asperity::md
