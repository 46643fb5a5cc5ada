#pragma once

// Persson's theory of contact with a hardness: the stress diffuses between two
// absorbing boundaries, 0 where contact is lost and the hardness where the
// surface yields.

namespace asperity::theory {

/// Shares of the nominal area.
struct PlasticShares {
  double elastic = 0.0; ///< contact pressure between 0 and the hardness [1]
  double plastic = 0.0; ///< contact pressure at the hardness [1]
};

/// The distribution P of the contact pressure sigma obeys dP/dG = d^2P/dsigma^2
/// with P = delta(sigma - p) at G = 0 and P = 0 at sigma = 0 and sigma = H:
///
///     P = (2/H) sum_n sin(s_n p) sin(s_n sigma) e^{-s_n^2 G},  s_n = n pi/H
///
/// The elastic share is int_0^H P dsigma, the plastic one what has been
/// absorbed at H, and the load is p = int_0^H sigma P dsigma + H times the
/// plastic share. For small G the same sums are evaluated by mirror images.
///
/// @param nominal_pressure  p [Pa] 0..H
/// @param variance          G of Eq. (2) of Yang and Persson (2008) [Pa^2] > 0
/// @param hardness          H [Pa] > 0; infinite: the elastic share is Eq. (4)
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  1e-14 absolute
/// @see  B. N. J. Persson, J. Chem. Phys. 115, 3840 (2001)
PlasticShares plastic_shares(double nominal_pressure, double variance,
                             double hardness);

} // namespace asperity::theory
