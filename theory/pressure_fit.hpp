#pragma once

// Sec. 5: the contact area of a simulation out of its pressure histogram, by
// the form of (1) with a variance that fits.

#include <span>

namespace asperity::theory {

/// One bin of a histogram of the contact pressure over the nominal area.
struct PressureBin {
  double contact_pressure = 0.0; ///< sigma, the bin's middle [Pa] > 0
  double density = 0.0; ///< share of the nominal area per pressure [1/Pa]
};

/// What the fit finds.
struct PressureFit {
  bool converged = false;     ///< false: the best variance is at its bounds
  double variance = 0.0;      ///< G~ of (20) [Pa^2]; the paper's r is G~/G
  double area_fraction = 0.0; ///< (21), erf(p/(2 sqrt(G~))) [1]
};

/// The least squares of (20), P(sigma) of (1) with G~ in the place of G, over
/// the bins, all of one weight.
///
/// @param bins              at least one
/// @param nominal_pressure  p [Pa] > 0
/// @return                  G~ within 1e-8 to 1e8 times p^2
/// @throws std::domain_error  no bins, or an argument outside its range
/// @par Accuracy  1e-7 of G~, the minimum of a square. Near contact pressure 0
///      an atomic force law spoils the histogram; leave such bins out.
PressureFit fit_pressure_distribution(std::span<const PressureBin> bins,
                                      double nominal_pressure);

} // namespace asperity::theory
