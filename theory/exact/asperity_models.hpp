#pragma once

// The two classical asperity models, for contrast with Persson's theory:
// Greenwood and Williamson's, and Bush, Gibson and Thomas' in full.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// What a Gaussian surface's summits are like, by the moments of its profile.
/// @see  P. R. Nayak, J. Lubr. Technol. 93, 398 (1971);
///       J. I. McCool, Wear 107, 37 (1986)
struct SummitStatistics {
  double nayak = 0.0;            ///< alpha = m_0 m_4/m_2^2 [1] > 3/2
  double density = 0.0;          ///< m_4/(6 sqrt3 pi m_2) [1/m^2]
  double radius = 0.0;           ///< (3/8) sqrt(pi/m_4) [m]
  double mean_height = 0.0;      ///< 4 sqrt(m_0/(pi alpha)) above the mean [m]
  double height_deviation = 0.0; ///< sqrt(m_0 (1 - 0.8968/alpha)) [m]
};

/// @param moments  m_0, m_2, m_4 of a profile, all > 0 and alpha > 3/2, which
///                 every isotropic surface of more than one wavelength has
/// @throws std::domain_error  a moment or alpha is outside its range
SummitStatistics summit_statistics(const ProfileMoments& moments);

/// A point of an asperity model's curves.
struct AsperityLoad {
  double nominal_pressure = 0.0; ///< p [Pa]
  double area_fraction = 0.0;    ///< A/A_0 [1]
};

/// Greenwood and Williamson's model with McCool's parameters: summits of one
/// radius R, heights normal about z_s with the deviation s; d = u - z_s,
///
///     p     = (4/3) E* eta sqrt(R) int_d^inf (z - d)^{3/2} phi(z) dz,
///     A/A_0 = pi eta R int_d^inf (z - d) phi(z) dz.
///
/// Far out p ~ d^{-5/2} e^{-d^2/2 s^2}, the paper's a = 5/2.
///
/// @param moments          as in summit_statistics()
/// @param contact_modulus  E* [Pa] > 0
/// @param mean_gap         u, between the mean planes [m], any
/// @throws std::domain_error  an argument outside its range or not finite
/// @par Accuracy  1e-12 relative. Model: summits do not feel each other.
/// @see  J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295, 300 (1966)
AsperityLoad greenwood_williamson(const ProfileMoments& moments,
                                  double contact_modulus, double mean_gap);

/// Bush, Gibson and Thomas in full: elliptic_contact() over all summits, with
/// mean curvature t, half difference rho of the principal curvatures and
/// height z. The summits' density, from <z t> = m_2, <t^2> = 2 m_4/3 and
/// <rho^2> = 2 m_4/3,
///
///     n = (t^2 - rho^2)/(2 pi m_2) N(t) (3 rho/m_4) e^{-3 rho^2/2 m_4} N(z|t),
///
/// 0 < rho < t, and p = int n F, A = int n pi a b over z > u.
///
/// Far out p ~ u^{-1} e^{-u^2/2 m_0}, the paper's a = 1, as
/// bush_gibson_thomas_asymptote().
///
/// Arguments, refusals and model as greenwood_williamson().
/// @par Accuracy  1e-9 relative up to u = 10 sqrt(m_0), 1e-6 at 36 sqrt(m_0)
/// @see  A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35, 87 (1975)
AsperityLoad bush_gibson_thomas(const ProfileMoments& moments,
                                double contact_modulus, double mean_gap);

/// Its limit for large separations,
///     A/A_0 = erfc(u/sqrt(2 m_0))/4,   p = E* sqrt(m_2/pi) A/A_0.
AsperityLoad bush_gibson_thomas_asymptote(const ProfileMoments& moments,
                                          double contact_modulus,
                                          double mean_gap);

} // namespace asperity::theory
