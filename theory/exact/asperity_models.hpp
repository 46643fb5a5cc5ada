#pragma once

// The asperity model of Bush, Gibson and Thomas in full, for comparison with
// Persson's theory.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// A point on the curves of the model.
struct AsperityLoad {
  double nominal_pressure = 0.0; ///< p [Pa]
  double area_fraction = 0.0;    ///< A/A_0 [1]
};

/// The model of Bush, Gibson and Thomas in full: elliptic Hertzian contacts on
/// all summits, with mean curvature t, half difference rho of the principal
/// curvatures and height z. The density of summits, from <z t> = m_2,
/// <t^2> = 2 m_4/3 and <rho^2> = 2 m_4/3, is
///
///     n = (t^2 - rho^2)/(2 pi m_2) N(t) (3 rho/m_4) e^{-3 rho^2/2 m_4} N(z|t),
///
/// for 0 < rho < t, and p = int n F, A = int n pi a b over z > u.
///
/// For large separations A/A_0 = erfc(u/sqrt(2 m_0))/4 and
/// p = E* sqrt(m_2/pi) A/A_0 ~ u^{-1} e^{-u^2/2 m_0}, which is a = 1 in the
/// notation of Yang and Persson (2008).
///
/// @param moments          m_0, m_2, m_4 of a profile, all > 0, with
///                         m_0 m_4/m_2^2 > 3/2, which holds for every isotropic
///                         surface of more than one wavelength
/// @param contact_modulus  E* [Pa] > 0
/// @param mean_gap         u, between the mean planes [m], any finite value
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  1e-9 relative up to u = 10 sqrt(m_0), 1e-6 at 36 sqrt(m_0).
///            Model: summits do not interact elastically.
/// @see  A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35, 87 (1975)
AsperityLoad bush_gibson_thomas(const ProfileMoments& moments,
                                double contact_modulus, double mean_gap);

} // namespace asperity::theory
