#pragma once

// Estimates the leak rate of a seal, Sec. 8 of Yang and Persson (2008), from a
// single pore at the magnification at which the non-contact area percolates.
// Equation numbers in this file are those of that paper.

#include "theory/persson/magnification.hpp"

namespace asperity::theory {

/// The area fraction at which the non-contact area first percolates, taken as
/// one minus the threshold of site percolation on the square lattice,
/// 1 - 0.59274605. The paper does not specify it. Other models of a surface in
/// the plane give 1/2 for a symmetric random field and about 0.42 in simulated
/// contacts.
/// @see  J. L. Jacobsen, J. Phys. A 48, 454003 (2015), the threshold;
///       D. Stauffer, A. Aharony, Introduction to Percolation Theory (1994)
inline constexpr double square_lattice_critical_area = 1.0 - 0.59274605;

/// Properties of the sealed fluid.
struct Fluid {
  double density = 0.0;   ///< rho [kg/m^3] >= 0
  double viscosity = 0.0; ///< eta [Pa s] > 0
};

/// The critical pore, a square: its size cancels from the leak rate.
struct Leak {
  bool percolates = false;    ///< if false, no other member is set
  double magnification = 0.0; ///< zeta*, A(zeta*)/A_0 = critical area [1]
  double pore_size = 0.0;     ///< 2 pi/(zeta* q_ref) [m], width and length
  double pore_gap = 0.0;      ///< u_1(zeta*) [m]
  double mass_flow = 0.0;     ///< rho u_1^3 Dp/(12 eta) [kg/s]
};

/// Estimates the leak rate.
/// @param contact        the contact of the seal under its pressure
/// @param fluid          incompressible
/// @param pressure_drop  Dp across the seal [Pa] >= 0
/// @param critical_area  A(zeta*)/A_0 [1], above 0 and below 1
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  three times the relative error of u_1. With a spectrum of
///            shells, u_1 is the step of Eq. (25) over the shell at which the
///            critical area is passed. Model: the whole pressure drop acts over
///            one square pore, which gives the order of magnitude.
Leak leakage(const MagnifiedContact& contact, const Fluid& fluid,
             double pressure_drop,
             double critical_area = square_lattice_critical_area);

} // namespace asperity::theory
