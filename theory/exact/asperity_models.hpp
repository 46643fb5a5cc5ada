#pragma once

// Two classical asperity models, for comparison with Persson's theory: those of
// Greenwood and Williamson and of Bush, Gibson and Thomas, the latter in full.

#include "theory/persson/height_spectrum.hpp"

namespace asperity::theory {

/// Statistics of the summits of a Gaussian surface, from the moments of its
/// profile.
/// @see  P. R. Nayak, J. Lubr. Technol. 93, 398 (1971);
///       J. I. McCool, Wear 107, 37 (1986)
struct SummitStatistics {
  double nayak = 0.0;            ///< alpha = m_0 m_4/m_2^2 [1] > 3/2
  double density = 0.0;          ///< m_4/(6 sqrt3 pi m_2) [1/m^2]
  double radius = 0.0;           ///< (3/8) sqrt(pi/m_4) [m]
  double mean_height = 0.0;      ///< 4 sqrt(m_0/(pi alpha)) above the mean [m]
  double height_deviation = 0.0; ///< sqrt(m_0 (1 - 0.8968/alpha)) [m]
};

/// Computes the summit statistics.
/// @param moments  m_0, m_2, m_4 of a profile, all > 0, with alpha > 3/2, which
///                 holds for every isotropic surface of more than one
///                 wavelength
/// @throws std::domain_error  a moment or alpha is outside its range
SummitStatistics summit_statistics(const ProfileMoments& moments);

/// A point on the curves of an asperity model.
struct AsperityLoad {
  double nominal_pressure = 0.0; ///< p [Pa]
  double area_fraction = 0.0;    ///< A/A_0 [1]
};

/// Greenwood and Williamson's model with McCool's parameters: summits of equal
/// radius R, with heights normally distributed about z_s with the standard
/// deviation s; with d = u - z_s,
///
///     p     = (4/3) E* eta sqrt(R) int_d^inf (z - d)^{3/2} phi(z) dz,
///     A/A_0 = pi eta R int_d^inf (z - d) phi(z) dz.
///
/// For large separations p ~ d^{-5/2} e^{-d^2/2 s^2}, which is a = 5/2 in the
/// notation of Yang and Persson (2008).
///
/// @param moments          as in summit_statistics()
/// @param contact_modulus  E* [Pa] > 0
/// @param mean_gap         u, between the mean planes [m], any finite value
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  1e-12 relative. Model: summits do not interact elastically.
/// @see  J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295, 300 (1966)
AsperityLoad greenwood_williamson(const ProfileMoments& moments,
                                  double contact_modulus, double mean_gap);

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
/// The arguments, errors and model assumptions are those of
/// greenwood_williamson().
/// @par Accuracy  1e-9 relative up to u = 10 sqrt(m_0), 1e-6 at 36 sqrt(m_0)
/// @see  A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35, 87 (1975)
AsperityLoad bush_gibson_thomas(const ProfileMoments& moments,
                                double contact_modulus, double mean_gap);

} // namespace asperity::theory
