#pragma once

// Persson's distribution of contact pressure in closed form, Eqs. (1)-(5) of
// Yang and Persson (2008), as functions of the nominal pressure and of the
// stress variance G. Equation numbers in this file are those of that paper.

namespace asperity::theory {

/// Variance parameter of the pressure distribution due to the roughness:
///
///     G = (pi/4) E*^2 int q^3 C dq = E*^2 rms_slope^2/8              (2)
///
/// @param contact_modulus  E* [Pa] > 0
/// @param rms_slope        both directions [1] > 0
/// @return                 G [Pa^2]; full contact has the variance 2 G
/// @throws std::domain_error  an argument is outside its range or not finite
double stress_variance(double contact_modulus, double rms_slope);

/// Density of the contact pressure sigma > 0, normalised to the area fraction:
///
///     P = [e^{-(sigma - p)^2/4G} - e^{-(sigma + p)^2/4G}]/(2 sqrt(pi G))  (1)
///
/// @param contact_pressure  sigma [Pa] >= 0
/// @param nominal_pressure  p [Pa] >= 0
/// @param variance          G [Pa^2] > 0
/// @return                  P [1/Pa] >= 0
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  a few ulp, also where the exponentials nearly cancel
double pressure_density(double contact_pressure, double nominal_pressure,
                        double variance);

/// Fraction of the nominal area whose contact pressure lies between two values,
///
///     int_a^b P dsigma = [Phi(b - p) - Phi(a - p) - Phi(b + p) + Phi(a + p)]/2
///
/// with Phi(x) = erf(x/(2 sqrt G)), from Eq. (1). For a = 0 and b -> infinity
/// it is the area fraction, Eq. (4).
///
/// @param low               a [Pa] >= 0
/// @param high              b [Pa] >= a
/// @param nominal_pressure  p [Pa] >= 0
/// @param variance          G [Pa^2] > 0
/// @return                  [1] 0..1
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  roundoff of four erf, 1e-16 absolute
double pressure_share(double low, double high, double nominal_pressure,
                      double variance);

/// A/A_0 = erf(p/(2 sqrt G)), Eq. (4), which is p/sqrt(pi G) at small
/// pressures, Eq. (5).
///
/// @param nominal_pressure  p [Pa] >= 0
/// @param variance          G [Pa^2] > 0
/// @return                  A/A_0 [1] 0..1
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  a few ulp (one erf). Model: exact in full contact only.
/// @see  B. N. J. Persson, J. Chem. Phys. 115, 3840 (2001)
double area_fraction(double nominal_pressure, double variance);

/// int_0^inf sigma^n P dsigma for n = 0, 1, 2, which are the area fraction, the
/// nominal pressure, and the mean square (p^2 + 2G) erf(p/2 sqrt G) +
/// 2p sqrt(G/pi) e^{-p^2/4G}.
struct PressureMoments {
  double area_fraction = 0.0;        ///< [1]
  double nominal_pressure = 0.0;     ///< [Pa]
  double mean_square_pressure = 0.0; ///< over the whole nominal area [Pa^2]
};

/// Moments of Eq. (1).
/// @param nominal_pressure  p [Pa] >= 0
/// @param variance          G [Pa^2] > 0
/// @throws std::domain_error  an argument is outside its range or not finite
PressureMoments pressure_moments(double nominal_pressure, double variance);

} // namespace asperity::theory
