#pragma once

// The stiffness of the lower face of a crystal slab for one lateral wavevector,
// after elimination of all layers above it. Thick slabs are composed from thin
// ones by doubling.

#include "md/interface/symmetric_block.hpp"
#include "md/lattice/crystal.hpp"

#include <array>

namespace asperity::md {

/// Returns (block + diag(added_x, added_x, added_z))^-1 for a positive definite
/// block, with added_x = added_lateral and added_z = added_normal.
SymmetricBlock inverse(const SymmetricBlock& block, double added_lateral = 0.0,
                       double added_normal = 0.0);

/// Layers of one crystal, periodic in x and y, for the mode
/// exp(i (theta_x j_x + theta_y j_y)) on the lattice sites (j_x, j_y). If u_x,
/// u_y, F_x and F_y are multiplied by -i, the stiffness K of a face is real:
///
///     (-i F_x, -i F_y, F_z) = K (-i u_x, -i u_y, u_z)
class SlabSymbol {
public:
  /// @throws std::domain_error  as cell_stiffness
  explicit SlabSymbol(const Crystal& crystal);

  /// Returns K(theta) of the lowest layer of atoms below `cells` layers of
  /// cells whose far boundary is clamped: force per atom divided by
  /// displacement [N/m].
  ///
  /// One layer of cells is a slab. Two slabs are combined into one by
  /// elimination of their common face, and powers of two are combined to any
  /// number of layers. A slab is represented by the coupling B of its faces and
  /// the force F on its lower face when both faces move alike. This avoids
  /// cancellation at long wavelengths, where F ~ theta^2.
  ///
  /// @param angle_x  theta_x = q_x a [rad], any value
  /// @param cells    number of layers, >= 1; a large number yields the
  ///                 half-space
  /// @throws std::domain_error  cells < 1
  /// @par Accuracy   1e-14 of the largest entry, also at |theta| = 2 pi / 1000
  SymmetricBlock clamped(double angle_x, double angle_y, int cells) const;

  /// Returns the effective contact modulus 2 / (|q| C_zz) at this wavevector
  /// [Pa], where C = (a^2 K)^-1.
  double contact_modulus(double angle_x, double angle_y, int cells) const;

private:
  /// Forces on the lower face, summed over the pairs of corners of a cell that
  /// are `offset` sites apart.
  struct Offset {
    int x = 0;
    int y = 0;
    std::array<double, 9> moving_alike{}; ///< lower face, both faces moving
    std::array<double, 9> across{};       ///< lower face, upper face moving
  };

  double spacing_ = 0.0;
  std::array<Offset, 9> offsets_{};
};

} // namespace asperity::md
