#pragma once

// The crystal of the block: a simple cubic lattice whose energy is a sum over
// unit cells. All elastic operators of this module are assembled from the
// stiffness matrix of one cell.

#include "mechanics/md_settings.hpp"

#include <array>
#include <cstddef>

namespace asperity::md {

/// A simple cubic crystal.
///
/// - isotropic: the edges and face diagonals are springs of stiffness k = mu a,
/// and each cell has the energy (1/2) kappa (div u)^2 a^3 with
/// kappa = lambda - mu. The crystal is isotropic in the long-wave limit.
///
/// - born: the edges have the normal stiffness E a and the tangential stiffness
/// G a, where G = E / (2 (1 + nu)). Hence C_11 = E, C_44 = G, C_12 = 0. The
/// energy is not invariant under rotation.
///
/// - central: as isotropic, but without the dilatation energy, so nu must be
/// 1/4.
struct Crystal {
  mechanics::AtomLattice lattice = mechanics::AtomLattice::isotropic;
  double spacing = 0.0;        ///< a [m] > 0
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1 < nu < 0.5
};

/// Second derivatives of the energy of one cell [N/m]: a symmetric 24 x 24
/// matrix in row-major order. Corner c = 0..7 lies at a (c & 1, (c >> 1) & 1,
/// c >> 2) and has the unknowns 3 c + axis. Each bond is shared equally by the
/// cells around it (an edge by four, a face diagonal by two), so bonds in a
/// free surface count half.
using CellStiffness = std::array<double, std::size_t{24} * 24>;

/// @throws std::domain_error  a modulus, the spacing or Poisson's ratio is
///                            outside its range, or the lattice is central and
///                            nu is not 1/4
CellStiffness cell_stiffness(const Crystal& crystal);

} // namespace asperity::md
