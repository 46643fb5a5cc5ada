#pragma once

// The quadrature rules in m = sqrt(int q^3 C dq), for a formula and for shells.
// The theory only uses their nodes.

#include "theory/persson/height_spectrum.hpp"

#include <span>
#include <vector>

namespace asperity::theory {

/// All results of one pass over a spectrum.
struct SpectrumIntegrals {
  double height = 0.0;              ///< int q C dq [m^2]
  double full_contact = 0.0;        ///< int q^2 C dq [m]
  double slope = 0.0;               ///< int q^3 C dq = M(q_1) [1]
  double curvature = 0.0;           ///< int q^5 C dq [1/m^2]
  std::vector<RoughnessNode> nodes; ///< descending in root_moment
};

/// Composite Gauss rule in t = sqrt(q - q_L), in which m is smooth at q_L, on
/// panels that end at every break, halve t towards q_L and limit the growth of
/// m to a factor of four.
/// @param formula  already checked: breaks ascend and C has roughness from
///                 breaks[0] on
SpectrumIntegrals integrate_formula(const SpectrumFormula& formula);

/// Gauss nodes on octaves of m, with weights that are exact for polynomials
/// times the step function 2/q(m): the step function enters through its
/// Legendre moments, with each step integrated in closed form.
/// @param shells  already checked, ascending in wavevector
SpectrumIntegrals integrate_shells(std::span<const SpectrumShell> shells);

} // namespace asperity::theory
