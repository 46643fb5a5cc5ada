#pragma once

// Sec. 8: what a contact looks like at a magnification, how far apart the
// surfaces are inside the area that seems to touch, and where they open.

#include "theory/persson/persson.hpp"

#include <optional>

namespace asperity::theory {

/// What opens while the magnification grows, per ln zeta and nominal area.
struct OpeningRates {
  double area = 0.0;   ///< -dA/dln zeta over A_0 [1] >= 0
  double volume = 0.0; ///< -d(A u)/dln zeta over A_0 [m] >= 0
};

/// A contact under one pressure p, seen at magnifications zeta = q/q_ref.
///
/// At zeta the roughness up to q is seen, with M_z = M(q); the rest is hidden.
/// The apparent contact carries p(zeta) = p A_0/A(zeta), and there the theory
/// of (1)-(19) holds again for what is hidden. q_ref is the caller's: A(1) is
/// A_0 only if q_ref <= q_L. The paper's MD surface counts from its roll-off,
/// so that A = A_0 at zeta_0 = q_L/q_ref and not at 1.
///
/// Every member takes zeta > 0 and throws std::domain_error for another.
/// Below zeta_0 everything is as at zeta_0, above zeta_1 nothing is hidden.
///
/// @par Accuracy  some 1e-13 relative. Model: (23) replaces the distribution of
///      pressure in the apparent contact by its mean, so A(q) is not A(zeta)
///      times the hidden roughness' area fraction (off by up to 13 %).
class MagnifiedContact {
public:
  /// @param contact               surface, E* and gamma
  /// @param nominal_pressure      p [Pa] > 0
  /// @param reference_wavevector  q_ref = q/zeta [rad/m] > 0
  /// @throws std::domain_error    an argument outside its range or not finite
  MagnifiedContact(PerssonContact contact, double nominal_pressure,
                   double reference_wavevector);

  const PerssonContact& contact() const { return contact_; }

  double nominal_pressure() const { return nominal_pressure_; }

  double lowest_magnification() const;  ///< zeta_0 = q_L/q_ref
  double highest_magnification() const; ///< zeta_1 = q_1/q_ref

  /// h_rms of what is hidden, h_rms^2 = 2 pi int_q^{q_1} q' C dq', the line
  /// before (23) [m].
  double rms_height(double magnification) const;

  /// A(zeta)/A_0 = erf(p/(E* sqrt(pi M_z))), (4) with (2) up to q [1].
  double area_fraction(double magnification) const;

  /// p(zeta) = p A_0/A(zeta), the mean pressure where contact seems [Pa].
  double apparent_pressure(double magnification) const;

  /// The magnification at which (4) has a given value, by the inverse error
  /// function and a root of M_z; no value if the area is never so small.
  /// @param area_fraction  A(zeta)/A_0 [1], 0 < A/A_0 < 1
  std::optional<double> magnification_of_area(double area_fraction) const;

  /// u(zeta) [m], (23) with the outer w(q) read as w(q, zeta) of (24), without
  /// which it is not (14) of the hidden roughness:
  ///
  ///     u = 2 int_0^{m_1} J(p(zeta)/(E* sqrt(pi) m)) dm/q(M_z + m^2).
  double mean_gap(double magnification) const;

  /// (23) to the letter: the outer w(q) = (pi M(q))^{-1/2} counts from q_L. It
  /// is below mean_gap() except at zeta_0, where they agree [m].
  double mean_gap_as_printed(double magnification) const;

  /// u_1(zeta) [m], (25): the mean separation where the surfaces part company
  /// as the magnification passes zeta. With D = -du/dln p, beta = -du/dM_z
  /// (OpeningSums) and x_0 = p/(E* sqrt(pi M_z)),
  ///
  ///     u_1 = u + D + pi M_z^{3/2} A beta e^{x_0^2} E*/p.
  ///
  /// It is infinite where e^{x_0^2} overflows, near zeta_0; opening_rates() is
  /// not. 0 from zeta_1 on.
  /// @throws std::domain_error  also for a spectrum of shells: A has jumps
  double opening_gap(double magnification) const;

  /// The step (25) is the limit of, for shells too: the volume that opens
  /// between two magnifications over the area that opens,
  ///
  ///     [u(a) A(a) - u(b) A(b)]/[A(a) - A(b)]   [m].
  ///
  /// @throws std::domain_error  no area opens between them
  double opening_gap(double from_magnification, double to_magnification) const;

  /// Area and volume that open per ln zeta: u_1 is their quotient, and
  /// volume = [(u + D) dA/dM_z + A beta] q^4 C with dA/dM_z taken positive.
  /// @throws std::domain_error  also for a spectrum of shells
  OpeningRates opening_rates(double magnification) const;

  /// The density of (27) at u = u_1(zeta), P_u = (dA/dM_z)/(du_1/dM_z) [1/m],
  /// for a spectrum of any smoothness: C(q) drops out.
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
