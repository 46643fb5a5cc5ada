#pragma once

// The block's lattice: simple cubic, its energy a sum over cells. Owns the
// springs; everything elastic in this room is made of one cell's stiffness.

#include <array>
#include <cstddef>

namespace asperity::md {

enum class Lattice {
  isotropic, ///< springs on edges and face diagonals, and cell dilatation
  born,      ///< edges with a normal and a tangential spring
  central,   ///< springs on edges and face diagonals alone: nu = 1/4
};

/// A simple cubic crystal.
///
/// isotropic: edges and face diagonals of stiffness k = mu a, and (1/2) kappa
/// (div u)^2 a^3 a cell with kappa = lambda - mu; isotropic in the long-wave
/// limit. born: edges of normal stiffness E a and tangential stiffness G a,
/// G = E / (2 (1 + nu)): C_11 = E, C_44 = G, C_12 = 0; not invariant under
/// rotation. central: isotropic without the dilatation, so nu must be 1/4.
struct Crystal {
  Lattice lattice = Lattice::isotropic;
  double spacing = 0.0;        ///< a [m] > 0
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1 < nu < 0.5
};

/// Second derivatives of one cell's energy [N/m], 24 x 24, symmetric, row
/// major. Corner c = 0..7 lies at a (c & 1, (c >> 1) & 1, c >> 2); unknown 3 c
/// + axis. Each bond belongs in equal parts to the cells around it (an edge to
/// four, a face diagonal to two), so bonds in a free face count half.
using CellStiffness = std::array<double, 24 * 24>;

/// @throws std::domain_error  a modulus, spacing or Poisson's ratio outside its
///                            range; central with nu other than 1/4
CellStiffness cell_stiffness(const Crystal& crystal);

/// E* of the crystal in the limit of long waves [Pa]: E / (1 - nu^2), for born
/// 2 sqrt(E G).
double long_wave_contact_modulus(const Crystal& crystal);

} // namespace asperity::md
