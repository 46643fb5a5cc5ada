#pragma once

// The distribution of the local separation u_1(zeta), Eqs. (27) and (28) of
// Yang and Persson (2008): a density over u > 0 and the weight of the contact
// area at u = 0. Equation numbers in this file are those of that paper.

#include "theory/persson/magnification.hpp"

namespace asperity::theory {

/// Fraction of the nominal area in which the local separation u_1 is less than
/// u, and its density:
///
///     Psi(u) = A(zeta(u))/A_0,  u = u_1(zeta(u)),   P_u = dPsi/du   (27)
///
/// with a delta function of weight A(zeta_1)/A_0 at u = 0. Eq. (28) has
/// zeta = e^{-mu}, whose sign must be reversed to zeta = e^{mu}. This
/// distribution is narrower than that of u(x) itself, Eq. (26), because u_1 is
/// a mean of u(x).
///
/// The moments are int P_u du = 1 including the delta function, and
/// int u P_u du = u(zeta_0), the mean gap. The tail falls as 1/(u^2 ln^2 u), so
/// the variance does not exist.
///
/// @par Accuracy  1e-9 relative up to about 5 h_rms: zeta(u) is a root, and
///            near zeta_0 the digits of q - q_L are lost. Model: as
///            MagnifiedContact.
class GapDistribution {
public:
  /// @throws std::domain_error  the spectrum consists of shells, for which u_1
  ///                            is discontinuous; use steps of
  ///                            MagnifiedContact::opening_gap() instead
  explicit GapDistribution(MagnifiedContact contact);

  const MagnifiedContact& contact() const { return contact_; }

  /// Weight at u = 0, A(zeta_1)/A_0 [1].
  double contact_weight() const;

  /// The magnification zeta(u) at which u_1 = u. u [m] > 0
  /// @throws std::domain_error  the gap is not positive and finite
  double magnification(double gap) const;

  /// Cumulative distribution Psi(u) [1], at least contact_weight(), 1 for
  /// u -> inf. u [m] > 0
  double cumulative(double gap) const;

  /// Density P_u without its delta function [1/m]. u [m] > 0
  double density(double gap) const;

private:
  MagnifiedContact contact_;
};

} // namespace asperity::theory
