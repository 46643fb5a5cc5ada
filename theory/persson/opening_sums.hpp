#pragma once

// How the separation of what is hidden below a magnification answers when a
// little more roughness is seen: the sums behind (25) and its derivative.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// u(M_z, p) is (14) of the roughness hidden below q, in which q is a function
/// of M_z + m^2 and M_z is the moment M of what is seen:
///
///     u = 2 int_0^{m_1} J(x) dm/q(M_z + m^2),   x = p/(E* sqrt(pi) m).
///
/// Its derivatives need neither C(q) nor a division by it, because
/// dq/dM = 1/(q^3 C):
///
///     -du/dM_z = J(x_1)/(q_1 m_1) + int J(x) dq/(q^2 m)
///
/// with every term positive; the integral runs over what is hidden.
struct OpeningSums {
  double mean_gap = 0.0;      ///< u [m]
  double slope = 0.0;         ///< D = -du/dln p [m]
  double slope_rate = 0.0;    ///< dD/dln p [m]
  double closing = 0.0;       ///< beta = -du/dM_z at fixed p [m] >= 0
  double closing_rate = 0.0;  ///< dbeta/dln p [m]
  double closing_shift = 0.0; ///< dbeta/dM_z [m]
};

/// @param hidden          the spectrum above q, a formula
/// @param pressure_ratio  p/E* [1] > 0, not checked
/// @param gamma           of (10) [1]
/// @par Accuracy  some 1e-13 relative, as the nodes
OpeningSums opening_sums(const HeightSpectrum& hidden, double pressure_ratio,
                         double gamma);

} // namespace asperity::theory
