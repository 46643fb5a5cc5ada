#pragma once

// One layer of cells as a coupling of the two layers of atoms that bound it:
// forces by rows of a grid, and the same for one wave. Owns the stencil.

#include "md/lattice/crystal.hpp"

#include <array>
#include <cstddef>

namespace asperity::md {

/// Three planes x, y, z of one layer of atoms on an n_x by n_y grid, x fastest,
/// one behind the other: displacements [m] or forces [N].
template <class Number>
struct AtomPlane {
  Number* values = nullptr; ///< 3 n_x n_y of them
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

/// Force on one layer of atoms from the displacements of one layer (the same
/// or its neighbour): f_i(r) = -sum_offset T_ij(offset) u_j(r + offset) over
/// the nine lateral offsets.
///
/// Mirror planes of the crystal make T_ij even or odd in either direction: odd
/// in x where exactly one of i, j is x, and so for y. Two numbers a direction
/// say it all.
class LayerCoupling {
public:
  /// Adds T_ij(dx, dy) for all i, j from the corner pairs of the cell whose
  /// first lies in face `to` and whose second in face `from` (0 lower, 1
  /// upper).
  void add(const CellStiffness& cell, int to, int from, double factor);

  /// Adds to row iy of the three planes of `forces` what `displacements` does.
  void add_forces(const AtomPlane<const double>& displacements, int iy,
                  const AtomPlane<double>& forces) const;

  /// The 3 x 3 stiffness of the wave exp(i (theta_x j_x + theta_y j_y)), real
  /// because x and y are taken times -i: (-i F_x, -i F_y, F_z) against
  /// (-i u_x, -i u_y, u_z), forces an atom [N/m], the sign of a stiffness;
  /// row major.
  std::array<double, 9> symbol(double angle_x, double angle_y) const;

private:
  /// [i][j][|dy|][|dx|]; an odd direction takes the sign of its offset.
  using Entry = std::array<std::array<double, 2>, 2>;
  std::array<std::array<Entry, 3>, 3> entries_{};
};

/// All couplings of one layer of cells.
struct SlabCouplings {
  LayerCoupling within_lower; ///< on the lower face from itself
  LayerCoupling within_upper; ///< on the upper face from itself
  LayerCoupling inside;       ///< both: a layer of atoms between two of cells
  LayerCoupling to_lower;     ///< on the lower face from the upper
  LayerCoupling to_upper;     ///< on the upper face from the lower
};

/// @param factor  all forces times this
/// @throws std::domain_error  the cell has no mirror planes across x and y
SlabCouplings slab_couplings(const CellStiffness& cell, double factor);

} // namespace asperity::md
