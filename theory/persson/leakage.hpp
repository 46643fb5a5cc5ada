#pragma once

// Sec. 8: the first rough estimate of a seal's leak, one pore at the
// magnification where the open area percolates.

#include "theory/persson/magnification.hpp"

namespace asperity::theory {

/// The area fraction at which the open area first percolates, taken as one
/// minus the threshold of site percolation on the square lattice,
/// 1 - 0.59274605. The paper leaves it open. Other models of a surface in the
/// plane: 1/2 for a symmetric random field, about 0.42 in simulated contacts.
/// @see  J. L. Jacobsen, J. Phys. A 48, 454003 (2015), the threshold;
///       D. Stauffer, A. Aharony, Introduction to Percolation Theory (1994)
inline constexpr double square_lattice_critical_area = 1.0 - 0.59274605;

/// What is sealed in.
struct Fluid {
  double density = 0.0;   ///< rho [kg/m^3] >= 0
  double viscosity = 0.0; ///< eta [Pa s] > 0
};

/// The critical pore, as wide as long: its size cancels from the leak.
struct Leak {
  bool percolates = false;    ///< false: too much contact, nothing else is set
  double magnification = 0.0; ///< zeta*, A(zeta*)/A_0 = critical area [1]
  double pore_size = 0.0;     ///< 2 pi/(zeta* q_ref) [m], width and length
  double pore_gap = 0.0;      ///< u_1(zeta*) [m]
  double mass_flow = 0.0;     ///< rho u_1^3 Dp/(12 eta) [kg/s]
};

/// @param contact        a seal under its pressure
/// @param fluid          incompressible
/// @param pressure_drop  Dp across the seal [Pa] >= 0
/// @param critical_area  A(zeta*)/A_0 [1], above 0 and below 1
/// @throws std::domain_error  an argument outside its range or not finite
/// @par Accuracy  that of u_1, threefold. A spectrum of shells has the step of
///      (25) over the shell at which the critical area is passed. Model: the
///      whole drop over one square pore; an order of magnitude.
Leak leakage(const MagnifiedContact& contact, const Fluid& fluid,
             double pressure_drop,
             double critical_area = square_lattice_critical_area);

} // namespace asperity::theory
