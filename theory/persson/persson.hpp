#pragma once

// Persson's contact theory for one surface and one modulus: pressure, area,
// energy and separation, Eqs. (1)-(19) of Yang and Persson (2008), with
// integrals over the smooth variable m. Equation numbers in this file are those
// of that paper.

#include "theory/persson/gap_kernel.hpp"
#include "theory/persson/height_spectrum.hpp"
#include "theory/persson/loss_law.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <memory>
#include <optional>
#include <span>

namespace asperity::theory {

class GapSums;

/// The constant eps of the low-pressure limit,
///
///     ln eps = -gamma_Euler/2 + K (1 - gamma)/gamma                  (16)
///
/// with K = cubic_energy_constant(). The value 4.047 in the paper is eps(0.42).
///
/// @param gamma  0 < gamma <= 1 [1]
/// @return       eps [1], with an error of a few ulp times K/gamma; infinite
///               for gamma < 1.7e-3
/// @throws std::domain_error  gamma is outside its range
double persson_epsilon(double gamma);

/// Frictionless contact without adhesion of an elastic half-space and a rigid,
/// randomly rough, nominally flat surface.
///
/// Symbols: m and w(q) as in RoughnessNode, x = w p/E* = p/(E* sqrt(pi) m),
/// J(x) as in gap_kernel(). Every pressure is nominal, load over A_0.
///
/// @par Accuracy
///   Each integral has a relative error of about 1e-14 for shells and for
///   spectra that are smooth between their breaks. Model: gamma is the fitted
///   parameter of Sec. 3 of the paper; the error of the theory in partial
///   contact is measured by comparison and not stated here.
/// @see C. Yang, B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214 (2008)
class PerssonContact {
public:
  /// @param spectrum         of the surface (for two rough bodies, of the sum)
  /// @param contact_modulus  E* [Pa] > 0
  /// @param gamma            gamma of Eq. (10) [1], 0 < gamma <= 1
  /// @throws std::domain_error  an argument is outside its range or not finite
  PerssonContact(HeightSpectrum spectrum, double contact_modulus, double gamma);

  /// The same surface and modulus with another gamma; shares all prepared data.
  PerssonContact with_gamma(double gamma) const;

  /// The same surface and modulus with another law than Eq. (10): area, energy,
  /// separation and the low-pressure limit then follow from it. The parts by
  /// gamma and the theories of magnification and adhesion remain those of Eq.
  /// (10).
  PerssonContact with_law(LossLaw law) const;

  const HeightSpectrum& spectrum() const { return spectrum_; }

  double contact_modulus() const { return contact_modulus_; }

  double gamma() const { return gamma_; }

  /// G of the whole spectrum in full contact, Eq. (2) [Pa^2].
  double stress_variance() const;

  /// G at a load [Pa^2], by Eq. (10) that of full contact.
  double stress_variance(double nominal_pressure) const;

  /// P(sigma) of Eq. (1) at the full magnification [1/Pa].
  double pressure_density(double contact_pressure,
                          double nominal_pressure) const;

  /// A/A_0 of Eq. (4) [1].
  double area_fraction(double nominal_pressure) const;

  /// Moments of Eq. (1), see pressure_moments().
  PressureMoments pressure_moments(double nominal_pressure) const;

  /// Elastic energy per nominal area,
  ///
  ///     U_el/A_0 = E* (pi/2) int q^2 W C dq = E* pi int m W dm/q    (9)
  ///     W = P [gamma + (1 - gamma) P^2],  P = erf x            (10), (11)
  ///
  /// @param nominal_pressure  p [Pa] >= 0
  /// @return                  [J/m^2]; equals int_u^inf p du' for each gamma,
  ///                          Eq. (6)
  double elastic_energy(double nominal_pressure) const;

  /// The elastic energy at gamma = 1 and at gamma = 0 [J/m^2].
  GammaParts elastic_energy_parts(double nominal_pressure) const;

  /// Eq. (9) with W = 1: E* (pi/2) int q^2 C dq [J/m^2].
  double full_contact_energy() const;

  /// Separation of the mean planes of the surfaces,
  ///
  ///     u(p) = 2 int_0^{m_1} J(x) dm/q(m)                           (14)
  ///
  /// @param nominal_pressure  p [Pa] > 0
  /// @return                  u [m] >= 0, underflowing to 0 in full contact
  /// @throws std::domain_error  the pressure is not positive and finite
  double mean_gap(double nominal_pressure) const;

  /// u(p) at gamma = 1 and at gamma = 0 [m]: u is linear in gamma, so a
  /// least-squares fit of gamma has a closed form.
  GammaParts mean_gap_parts(double nominal_pressure) const;

  /// D = -du/dln p = 2 int [gamma + 3 (1 - gamma) erf^2 x] e^{-x^2} dm/q [m],
  /// the derivative of Eq. (14), for p > 0.
  double mean_gap_slope(double nominal_pressure) const;

  /// Contact stiffness -dp/du = p/D [Pa/m] > 0, infinite where D underflows,
  /// for p > 0.
  double contact_stiffness(double nominal_pressure) const;

  /// p(u), the inverse of Eq. (14).
  /// @param mean_gap  u [m] > 0
  /// @return          p [Pa]; the relative error of u(p) is about 1e-14
  /// @throws std::domain_error  the gap is not positive and finite
  double nominal_pressure(double mean_gap) const;

  /// u_0 = sqrt(pi) gamma int q^2 C w dq = 2 gamma int dm/q, Eq. (18) [m]: the
  /// decay length in p ~ e^{-u/u_0}. u_0/h_rms is not the parameter gamma.
  double gap_decay_length() const;

  /// beta in p = beta E* e^{-u/u_0}, Eq. (19) [1].
  double pressure_prefactor() const;

  /// p = beta E* e^{-u/u_0}, Eq. (17) [Pa], the limit of Eq. (14) at small
  /// pressure.
  /// @param mean_gap  u [m] >= 0
  double asymptotic_pressure(double mean_gap) const;

private:
  double pressure_ratio(double nominal_pressure) const;
  double log_prefactor() const;

  HeightSpectrum spectrum_;
  double contact_modulus_;
  double gamma_;
  std::optional<LossLaw> law_; ///< none: Eq. (10)
  std::shared_ptr<const GapSums> sums_;
};

} // namespace asperity::theory
