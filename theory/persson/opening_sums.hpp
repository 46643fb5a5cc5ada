#pragma once

// Computes the derivatives of the mean separation due to the unresolved
// roughness with respect to the resolved roughness: the sums in Eq. (25) of
// Yang and Persson (2008) and its derivative. Equation numbers in this file are
// those of that paper.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// u(M_z, p) is Eq. (14) for the unresolved roughness, with wavevectors above
/// q, where q is a function of M_z + m^2 and M_z is the moment M of the
/// resolved roughness:
///
///     u = 2 int_0^{m_1} J(x) dm/q(M_z + m^2),   x = p/(E* sqrt(pi) m).
///
/// Its derivatives do not contain C(q), not even as a divisor, because
/// dq/dM = 1/(q^3 C):
///
///     -du/dM_z = J(x_1)/(q_1 m_1) + int J(x) dq/(q^2 m)
///
/// with every term positive; the integral extends over the unresolved
/// roughness.
struct OpeningSums {
  double mean_gap = 0.0;      ///< u [m]
  double slope = 0.0;         ///< D = -du/dln p [m]
  double slope_rate = 0.0;    ///< dD/dln p [m]
  double closing = 0.0;       ///< beta = -du/dM_z at fixed p [m] >= 0
  double closing_rate = 0.0;  ///< dbeta/dln p [m]
  double closing_shift = 0.0; ///< dbeta/dM_z [m]
};

/// Computes u and its derivatives.
/// @param hidden          the spectrum above q, given by a formula
/// @param pressure_ratio  p/E* [1] > 0, not checked
/// @param gamma           gamma of Eq. (10) [1]
/// @par Accuracy  about 1e-13 relative, as for the nodes
OpeningSums opening_sums(const HeightSpectrum& hidden, double pressure_ratio,
                         double gamma);

} // namespace asperity::theory
