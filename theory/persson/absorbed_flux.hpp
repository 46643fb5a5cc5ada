#pragma once

// Solves diffusion with a moving absorbing boundary, which describes the stress
// distribution of Persson's theory under adhesion at zero external pressure.

#include <span>
#include <vector>

namespace asperity::theory {

/// A boundary at the distance b > 0 from the start of the diffusion, which
/// obeys dP/dtau = d^2P/dsigma^2: at tau the free distribution has the variance
/// 2 tau.
struct MovingBoundary {
  std::vector<double> time;     ///< tau_0 = 0, ascending
  std::vector<double> distance; ///< b(tau_i) > 0
  std::vector<double> rate;     ///< db/dtau at tau_i
};

/// The remaining part of a unit of diffusing quantity that starts at 0.
struct Absorption {
  std::vector<double> flux;     ///< f(tau_i), absorbed per unit of tau, >= 0
  std::vector<double> survival; ///< P(tau_i) = 1 - int_0^tau f ds, 0..1
};

/// Computes the absorbed flux from its Volterra equation of the second kind,
///
///     f(tau) = -2 Psi(tau; 0, 0) + 2 int_0^tau Psi(tau; b(s), s) f(s) ds,
///     Psi(tau; y, s) = phi [b'(tau) - (b(tau) - y)/(tau - s)]/2,
///     phi = e^{-(b(tau) - y)^2/4(tau - s)}/sqrt(4 pi (tau - s)),
///
/// For a smoothly moving boundary the kernel vanishes as sqrt(tau - s) at
/// s = tau; for a fixed one it vanishes everywhere, and
/// P = erf(b/(2 sqrt tau)).
///
/// @param wall  three arrays of one length >= 2, units of tau and b related
///              as above
/// @throws std::domain_error  lengths differ, times do not ascend from 0, or a
///         distance is not positive
/// @par Accuracy  trapezoidal rule, of order 1.5 to 2 in the step size
/// @see  A. Buonocore, A. G. Nobile, L. M. Ricciardi, Adv. Appl. Probab. 19,
///       784 (1987), for the choice of Psi
Absorption absorbed_flux(const MovingBoundary& wall);

} // namespace asperity::theory
