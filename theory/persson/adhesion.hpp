#pragma once

// Sec. 9: adhesion between rough surfaces at no external pressure, as one
// effective binding energy; its two branches and the flip between them.

#include "theory/persson/height_spectrum.hpp"

#include <numbers>
#include <span>
#include <vector>

namespace asperity::theory {

/// The two faces and how they hold.
struct AdhesivePair {
  double contact_modulus = 0.0;  ///< E* [Pa] > 0
  double work_of_adhesion = 0.0; ///< Dgamma of flat faces [J/m^2] > 0
  double gamma = 0.0;            ///< of (10) [1], above 0 and at most 1

  /// c [1] > 0 of the stress at which a contact seen at q is torn off,
  ///     sigma_a^2 = c E* gamma_eff(q) q.
  /// Not in the paper. With 2/pi the flip of the figure of Sec. 9 comes out
  /// near where it is drawn, at some half of the contact.
  /// @see  B. N. J. Persson, Eur. Phys. J. E 8, 385 (2002)
  double detachment_factor = 2.0 / std::numbers::pi;
};

/// One state of the contact, and what it looks like up to each q.
struct AdhesiveState {
  bool exists = false; ///< false: the surfaces part, and all below is 0
  bool converged =
      false; ///< the fixed point is found (and not by our giving up)
  int n_iterations = 0;
  double effective_work = 0.0;         ///< gamma_eff(1) [J/m^2]
  double area_fraction = 0.0;          ///< A(zeta_1)/A_0 [1]
  std::vector<double> wavevectors;     ///< q_L to q_1 [rad/m]
  std::vector<double> effective_works; ///< gamma_eff(q) [J/m^2]
  std::vector<double> area_fractions;  ///< P(q) [1]
};

/// How much larger the true area of a rough face in contact is than its
/// projection, for a Gaussian surface of mean square slope xi^2:
///
///     a = <sqrt(1 + |grad h|^2)> = 1 + (sqrt(pi)/2) xi e^{1/xi^2} erfc(1/xi).
///
/// @param mean_square_slope  xi^2 [1] >= 0
/// @return                   a [1] >= 1, rounding
double true_area_factor(double mean_square_slope);

/// Rough contact held by adhesion alone. The stress diffuses as in (1) in
/// tau = G(q), and is absorbed at -sigma_a(q); P(q) is what is left of it, and
///
///     A*(q) = A_0 P(q) a(xi^2(q)),
///     gamma_eff(q) = [Dgamma A*(q_1) - A_0 E* (pi/2) int_q^{q_1} q^2 W C dq]
///                    /A*(q),
///
/// W by (10) of P. Partial contact is the fixed point of P -> gamma_eff ->
/// sigma_a -> P, complete contact is P = 1; the one with the larger
/// gamma_eff(1) is the state. Surfaces scale: C -> ratio^2 C.
///
/// @par Accuracy  second order in the steps, which are even in sqrt(ln(q/q_L))
///      up to the spectrum's first kink and in ln q from there: gamma_eff(1) to
///      some 20 Dgamma/n^2. Complete contact is free of it.
class RoughAdhesion {
public:
  /// @param spectrum  a formula (shells have no q(tau) to speak of)
  /// @param pair      of the two faces
  /// @param n_steps   between q_L and q_1, 10 to 100000
  /// @throws std::domain_error  an argument outside its range or not finite
  RoughAdhesion(const HeightSpectrum& spectrum, const AdhesivePair& pair,
                int n_steps);

  /// P = 1. gamma_eff(1) may be negative; the state is then no state at rest.
  /// @param height_ratio  h_rms over that of the spectrum [1] > 0
  AdhesiveState complete_contact(double height_ratio) const;

  /// The fixed point, by damped iteration from gamma_eff(q) = Dgamma; `exists`
  /// is false where that runs into the parted surfaces.
  AdhesiveState partial_contact(double height_ratio) const;

  /// Of the two the one with the larger gamma_eff(1), or the parted surfaces
  /// (exists = false) if that is not positive.
  AdhesiveState equilibrium(double height_ratio) const;

  /// The height ratio at which the branches have one gamma_eff(1), where the
  /// state flips; by bisection between two ratios.
  /// @throws std::domain_error  the same branch wins at both
  double flip(double from_height_ratio, double to_height_ratio) const;

private:
  struct Node { // at the end of a step
    double wavevector;
    double moment;      // M(q) [1]
    double energy_step; // int q^2 C dq over the step before [m]
  };

  void add_node(const HeightSpectrum& spectrum, double wavevector);
  AdhesiveState state_of(std::vector<double> area_fractions,
                         double height_ratio) const;
  std::vector<double> area_fractions(std::span<const double> works,
                                     double height_ratio) const;

  AdhesivePair pair_;
  std::vector<Node> nodes_;
};

/// JKR's pull-off force of a ball on the rough face, (3 pi/2) R gamma_eff [N].
/// @param sphere_radius   R [m] > 0
/// @param effective_work  gamma_eff(1) [J/m^2]; 0 force if it is not positive
double rough_pull_off_force(double sphere_radius, double effective_work);

} // namespace asperity::theory
