#pragma once

// Persson's theory of one surface under one modulus: pressure, area, energy
// and separation, (1)-(19) of Yang and Persson, in the form smooth in m.

#include "theory/persson/gap_kernel.hpp"
#include "theory/persson/height_spectrum.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <memory>
#include <span>

namespace asperity::theory {

class GapSums;

/// eps of the low-pressure limit,
///
///     ln eps = -gamma_Euler/2 + K (1 - gamma)/gamma                  (16)
///
/// with K = cubic_energy_constant(). The paper's 4.047 is eps(0.42).
///
/// @param gamma  0 < gamma <= 1 [1]
/// @return       eps [1], a few ulp times K/gamma; infinite below gamma
/// = 1.7e-3
/// @throws std::domain_error  gamma outside its range
double persson_epsilon(double gamma);

/// Frictionless contact without adhesion of an elastic half-space and a rigid,
/// randomly rough, nominally flat surface.
///
/// Symbols: m and w(q) as in RoughnessNode, x = w p/E* = p/(E* sqrt(pi) m),
/// J(x) as in gap_kernel(). Every pressure is nominal, load over A_0.
///
/// @par Accuracy
///   Each integral to some 1e-14 relative for spectra that are smooth between
///   their breaks, and for shells. Model: the reader of the paper's Sec. 3
///   knows gamma as the one fitted parameter; what the theory misses in
///   partial contact is measured by comparison and not claimed here.
/// @see C. Yang, B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214 (2008)
class PerssonContact {
public:
  /// @param spectrum         of the surface (for two rough bodies, of the sum)
  /// @param contact_modulus  E* [Pa] > 0
  /// @param gamma            of (10) [1] 0 < gamma <= 1
  /// @throws std::domain_error  an argument outside its range or not finite
  PerssonContact(HeightSpectrum spectrum, double contact_modulus, double gamma);

  /// The same surface and modulus with another gamma; shares all set-up.
  PerssonContact with_gamma(double gamma) const;

  const HeightSpectrum& spectrum() const { return spectrum_; }

  double contact_modulus() const { return contact_modulus_; }

  double gamma() const { return gamma_; }

  /// G of the whole spectrum, (2) [Pa^2].
  double stress_variance() const;

  /// P(sigma) of (1) at the full magnification [1/Pa].
  double pressure_density(double contact_pressure,
                          double nominal_pressure) const;

  /// A/A_0 of (4) [1].
  double area_fraction(double nominal_pressure) const;

  /// Moments of (1); see pressure_moments().
  PressureMoments pressure_moments(double nominal_pressure) const;

  /// Elastic energy per nominal area,
  ///
  ///     U_el/A_0 = E* (pi/2) int q^2 W C dq = E* pi int m W dm/q    (9)
  ///     W = P [gamma + (1 - gamma) P^2],  P = erf x            (10), (11)
  ///
  /// @param nominal_pressure  p [Pa] >= 0
  /// @return                  [J/m^2]; int_u^inf p du' for each gamma, (6)
  double elastic_energy(double nominal_pressure) const;

  /// (9) with W = 1: E* (pi/2) int q^2 C dq [J/m^2].
  double full_contact_energy() const;

  /// Mean separation of the surfaces' mean planes,
  ///
  ///     u(p) = 2 int_0^{m_1} J(x) dm/q(m)                           (14)
  ///
  /// @param nominal_pressure  p [Pa] > 0
  /// @return                  u [m] >= 0, underflowing to 0 in full contact
  /// @throws std::domain_error  the pressure is not positive and finite
  double mean_gap(double nominal_pressure) const;

  /// u(p) at gamma = 1 and at gamma = 0 [m]: u is linear in gamma, so a least
  /// squares fit of gamma is closed form.
  GammaParts mean_gap_parts(double nominal_pressure) const;

  /// D = -du/dln p = 2 int [gamma + 3 (1 - gamma) erf^2 x] e^{-x^2} dm/q [m],
  /// the derivative of (14), p > 0.
  double mean_gap_slope(double nominal_pressure) const;

  /// -dp/du = p/D [Pa/m] > 0, infinite once D has underflowed. p > 0.
  double contact_stiffness(double nominal_pressure) const;

  /// p(u), the inverse of (14).
  /// @param mean_gap  u [m] > 0
  /// @return          p [Pa]; the relative error of u(p) is some 1e-14
  /// @throws std::domain_error  the gap is not positive and finite
  double nominal_pressure(double mean_gap) const;

  /// u_0 = sqrt(pi) gamma int q^2 C w dq = 2 gamma int dm/q, (18) [m]: the
  /// slope u_0 in p ~ e^{-u/u_0}. u_0/h_rms is not the parameter gamma.
  double gap_decay_length() const;

  /// beta of p = beta E* e^{-u/u_0}, (19) [1].
  double pressure_prefactor() const;

  /// p = beta E* e^{-u/u_0}, (17) [Pa]: what (14) tends to at small pressure.
  /// @param mean_gap  u [m] >= 0
  double asymptotic_pressure(double mean_gap) const;

private:
  double pressure_ratio(double nominal_pressure) const;

  HeightSpectrum spectrum_;
  double contact_modulus_;
  double gamma_;
  std::shared_ptr<const GapSums> sums_;
};

/// One measured point of a separation curve.
struct GapPoint {
  double nominal_pressure = 0.0; ///< p [Pa] > 0
  double mean_gap = 0.0;         ///< u [m]
};

/// The gamma of (10) with which u(p), (14), lies nearest to the points in the
/// least squares of u. Closed form: u = gamma u_1(p) + (1 - gamma) u_3(p).
///
/// @param contact  surface and modulus; its own gamma does not enter
/// @param points   at least one
/// @return         gamma [1], free to leave 0..1 when the points ask for it
/// @throws std::domain_error  no points, or a pressure not positive
double fit_gamma(const PerssonContact& contact,
                 std::span<const GapPoint> points);

} // namespace asperity::theory
