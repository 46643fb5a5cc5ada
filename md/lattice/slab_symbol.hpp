#pragma once

// One lateral wavevector of a slab of crystal: the stiffness of its lower face
// once everything above is eliminated. Owns the composition of slabs.

#include "md/interface/symmetric_block.hpp"
#include "md/lattice/crystal.hpp"

#include <array>

namespace asperity::md {

/// (block + diag(added_x, added_x, added_z))^-1 of a positive definite block.
SymmetricBlock inverse(const SymmetricBlock& block, double added_lateral = 0.0,
                       double added_normal = 0.0);

/// Layers of one crystal, periodic in x and y, as seen by the wave
/// exp(i (theta_x j_x + theta_y j_y)) over the lattice sites (j_x, j_y). With
/// u_x, u_y multiplied by -i and F_x, F_y as well, the stiffness K of a face is
/// real:
///
///     (-i F_x, -i F_y, F_z) = K (-i u_x, -i u_y, u_z)
class SlabSymbol {
public:
  /// @throws std::domain_error  as cell_stiffness
  explicit SlabSymbol(const Crystal& crystal);

  /// K(theta) of the lowest layer of atoms under `cells` layers of cells whose
  /// top is clamped, forces an atom over displacement [N/m].
  ///
  /// One layer of cells is a slab; two slabs are one, their common face
  /// eliminated; powers of two make up any number. A slab is kept as the
  /// coupling B of its faces and the force F on its lower face when both move
  /// alike, so that nothing cancels where waves are long (F ~ theta^2 there).
  ///
  /// @param angle_x  theta_x = q_x a [rad], any
  /// @param cells    >= 1; as many as you like make the half-space
  /// @throws std::domain_error  cells < 1
  /// @par Accuracy   1e-14 of the largest entry, also at |theta| = 2 pi / 1000
  SymmetricBlock clamped(double angle_x, double angle_y, int cells) const;

  /// Contact modulus 2 / (|q| C_zz) that the wave meets [Pa], C = (a^2 K)^-1.
  double contact_modulus(double angle_x, double angle_y, int cells) const;

private:
  /// Sum over the corner pairs of a cell that are `offset` sites apart.
  struct Offset {
    int x = 0;
    int y = 0;
    std::array<double, 9> moving_alike{}; ///< both faces, on the lower one
    std::array<double, 9> across{};       ///< upper face, on the lower one
  };

  double spacing_ = 0.0;
  std::array<Offset, 9> offsets_{};
};

} // namespace asperity::md
