#pragma once

// The distribution of the local separation u_1(zeta), (27) and (28): a density
// over u > 0 and the contact's weight at u = 0.

#include "theory/persson/magnification.hpp"

namespace asperity::theory {

/// The part of the nominal area on which the surfaces part at less than u, and
/// its density:
///
///     Psi(u) = A(zeta(u))/A_0,  u = u_1(zeta(u)),   P_u = dPsi/du   (27)
///
/// with a delta function of weight A(zeta_1)/A_0 at u = 0. In (28) zeta =
/// e^{-mu} turns the sign round; zeta = e^{mu} is meant, and the integrals
/// over mu = ln zeta are those of opening_rates(). Narrower than the
/// distribution (26) of u(x) itself, of which u_1 is already a mean.
///
/// The moments: int P_u du = 1 with the delta, int u P_u du = u(zeta_0), the
/// mean gap. The tail falls as 1/(u^2 ln^2 u), so there is no variance.
///
/// @par Accuracy  1e-9 relative up to some 5 h_rms: zeta(u) is a root, and near
/// zeta_0 the
///      digits of q - q_L are lost. Model: as MagnifiedContact.
class GapDistribution {
public:
  /// @throws std::domain_error  a spectrum of shells, of which u_1 has jumps;
  ///         take steps of MagnifiedContact::opening_gap() instead
  explicit GapDistribution(MagnifiedContact contact);

  const MagnifiedContact& contact() const { return contact_; }

  /// A(zeta_1)/A_0, the weight at u = 0 [1].
  double contact_weight() const;

  /// zeta(u): where u_1 is u [m] > 0.
  /// @throws std::domain_error  the gap is not positive and finite
  double magnification(double gap) const;

  /// Psi(u) [1], at least contact_weight(), 1 for u -> inf. u [m] > 0
  double cumulative(double gap) const;

  /// P_u without its delta function [1/m]. u [m] > 0
  double density(double gap) const;

private:
  MagnifiedContact contact_;
};

} // namespace asperity::theory
