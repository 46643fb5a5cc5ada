#pragma once

// Describes the contact as a function of magnification, Sec. 8 of Yang and
// Persson (2008): the separation of the surfaces inside the apparent contact
// area, and where contact is lost with increasing magnification. Equation
// numbers in this file are those of that paper.

#include "theory/persson/persson.hpp"

#include <optional>

namespace asperity::theory {

/// A contact under one pressure p, at magnifications zeta = q/q_ref.
///
/// At zeta the roughness up to q is resolved, with M_z = M(q), and the rest is
/// unresolved. The apparent contact area carries p(zeta) = p A_0/A(zeta), and
/// there Eqs. (1)-(19) apply again to the unresolved roughness. q_ref is chosen
/// by the caller: A(1) is A_0 only if q_ref <= q_L. For the molecular-dynamics
/// surface of the paper, q_ref is the roll-off wavevector, so that A = A_0 at
/// zeta_0 = q_L/q_ref and not at 1.
///
/// Every member takes zeta > 0 and throws std::domain_error otherwise. Below
/// zeta_0 all results are those at zeta_0; above zeta_1 no roughness is
/// unresolved.
///
/// @par Accuracy  about 1e-13 relative. Model: Eq. (23) replaces the
///            distribution of pressure in the apparent contact area by its
///            mean, so A(q) is not equal to A(zeta) times the area fraction of
///            the unresolved roughness (the difference is up to 13 %).
class MagnifiedContact {
public:
  /// @param contact               surface, E* and gamma
  /// @param nominal_pressure      p [Pa] > 0
  /// @param reference_wavevector  q_ref = q/zeta [rad/m] > 0
  /// @throws std::domain_error    an argument is outside its range or not
  ///                              finite
  MagnifiedContact(PerssonContact contact, double nominal_pressure,
                   double reference_wavevector);

  const PerssonContact& contact() const { return contact_; }

  double nominal_pressure() const { return nominal_pressure_; }

  double lowest_magnification() const;  ///< zeta_0 = q_L/q_ref
  double highest_magnification() const; ///< zeta_1 = q_1/q_ref

  /// h_rms of the unresolved roughness, h_rms^2 = 2 pi int_q^{q_1} q' C dq',
  /// from the line before Eq. (23) [m].
  double rms_height(double magnification) const;

  /// A(zeta)/A_0 = erf(p/(E* sqrt(pi M_z))), Eq. (4) with Eq. (2) up to q [1].
  double area_fraction(double magnification) const;

  /// p(zeta) = p A_0/A(zeta), the mean pressure in the apparent contact area
  /// [Pa].
  double apparent_pressure(double magnification) const;

  /// The magnification at which Eq. (4) has a given value, from the inverse
  /// error function and a root of M_z; empty if the area never is so small.
  /// @param area_fraction  A(zeta)/A_0 [1], 0 < A/A_0 < 1
  std::optional<double> magnification_of_area(double area_fraction) const;

  /// u(zeta) [m], Eq. (23) with the outer w(q) read as w(q, zeta) of Eq. (24),
  /// without which it would not be Eq. (14) of the unresolved roughness:
  ///
  ///     u = 2 int_0^{m_1} J(p(zeta)/(E* sqrt(pi) m)) dm/q(M_z + m^2).
  double mean_gap(double magnification) const;

  /// Eq. (23) as printed: the outer w(q) = (pi M(q))^{-1/2} starts at q_L. It
  /// is smaller than mean_gap() except at zeta_0, where they agree [m].
  double mean_gap_as_printed(double magnification) const;

  /// u_1(zeta) [m], Eq. (25): the mean separation where contact is lost as the
  /// magnification passes zeta. With D = -du/dln p, beta = -du/dM_z
  /// and x_0 = p/(E* sqrt(pi M_z)),
  ///
  ///     u_1 = u + D + pi M_z^{3/2} A beta e^{x_0^2} E*/p.
  ///
  /// It is infinite where e^{x_0^2} overflows, near zeta_0, and 0 for
  /// magnifications >= zeta_1.
  /// @throws std::domain_error  also for a spectrum of shells, because A is
  ///                            discontinuous
  double opening_gap(double magnification) const;

  /// The finite difference of which Eq. (25) is the limit, also valid for
  /// shells: the volume that opens between two magnifications divided by the
  /// area in which contact is lost,
  ///
  ///     [u(a) A(a) - u(b) A(b)]/[A(a) - A(b)]   [m].
  ///
  /// @throws std::domain_error  no contact is lost between them
  double opening_gap(double from_magnification, double to_magnification) const;

  /// The density of Eq. (27) at u = u_1(zeta), P_u = (dA/dM_z)/(du_1/dM_z)
  /// [1/m], for a spectrum of any smoothness, because C(q) cancels.
  /// @throws std::domain_error  also for a spectrum of shells
  double gap_density(double magnification) const;

private:
  struct View;
  View view(double magnification) const;
  double wavevector(double magnification) const;
  double pressure_ratio() const;
  std::optional<HeightSpectrum> hidden(double magnification) const;
  double visible_moment(double magnification) const; // M_z

  PerssonContact contact_;
  double nominal_pressure_;
  double reference_wavevector_;
};

} // namespace asperity::theory
