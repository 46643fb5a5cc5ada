#pragma once

// The adhesion between rough surfaces at zero external pressure, Sec. 9 of Yang
// and Persson (2008): the effective interfacial energy, its two branches and
// the transition between them. Equation numbers in this file are those of that
// paper.

#include "theory/persson/height_spectrum.hpp"

#include <numbers>
#include <span>
#include <vector>

namespace asperity::theory {

/// Elastic and adhesive properties of the two surfaces.
struct AdhesivePair {
  double contact_modulus = 0.0;  ///< E* [Pa] > 0
  double work_of_adhesion = 0.0; ///< Dgamma, flat surfaces [J/m^2] > 0
  double gamma = 0.0;            ///< gamma of Eq. (10) [1], 0 < gamma <= 1

  /// Factor c [1] > 0 in the stress at which a contact at the wavevector q
  /// detaches,
  ///     sigma_a^2 = c E* gamma_eff(q) q.
  /// It is not given in the paper. With c = 2/pi the transition between the
  /// branches occurs near its position in the figure of Sec. 9, at an area
  /// fraction of about one half.
  /// @see  B. N. J. Persson, Eur. Phys. J. E 8, 385 (2002)
  double detachment_factor = 2.0 / std::numbers::pi;
};

/// One state of the contact, with its dependence on the magnification.
struct AdhesiveState {
  bool exists = false;    ///< false: no contact, and all values below are 0
  bool converged = false; ///< false: the iteration limit was reached
  int n_iterations = 0;
  double effective_work = 0.0;         ///< gamma_eff(1) [J/m^2]
  double area_fraction = 0.0;          ///< A(zeta_1)/A_0 [1]
  std::vector<double> wavevectors;     ///< q_L to q_1 [rad/m]
  std::vector<double> effective_works; ///< gamma_eff(q) [J/m^2]
  std::vector<double> area_fractions;  ///< P(q) [1]
};

/// Ratio of the true area of a rough surface in contact to its projected area,
/// for a Gaussian surface of mean square slope xi^2:
///
///     a = <sqrt(1 + |grad h|^2)> = 1 + (sqrt(pi)/2) xi e^{1/xi^2} erfc(1/xi).
///
/// @param mean_square_slope  xi^2 [1] >= 0
/// @return                   a [1] >= 1, to roundoff
double true_area_factor(double mean_square_slope);

/// Rough contact held together by adhesion alone. The stress diffuses as in
/// Eq. (1) in tau = G(q), and is absorbed at -sigma_a(q); P(q) is the remaining
/// fraction, and
///
///     A*(q) = A_0 P(q) a(xi^2(q)),
///     gamma_eff(q) = [Dgamma A*(q_1) - A_0 E* (pi/2) int_q^{q_1} q^2 W C dq]
///                    /A*(q),
///
/// with W(P) from Eq. (10). Partial contact is the fixed point of
/// P -> gamma_eff -> sigma_a -> P, complete contact is P = 1; the equilibrium
/// state is the one with the larger gamma_eff(1). The height of the surface is
/// scaled by C -> ratio^2 C.
///
/// @par Accuracy  second order in the steps, which are uniform in
///            sqrt(ln(q/q_L)) up to the first kink of the spectrum and in ln q
///            beyond it: the error of gamma_eff(1) is about 20 Dgamma/n^2.
///            Complete contact does not have this error.
class RoughAdhesion {
public:
  /// @param spectrum  given by a formula (q(tau) is not defined for shells)
  /// @param pair      properties of the two surfaces
  /// @param n_steps   number of steps between q_L and q_1, 10 to 100000
  /// @throws std::domain_error  an argument is outside its range or not finite
  RoughAdhesion(const HeightSpectrum& spectrum, const AdhesivePair& pair,
                int n_steps);

  /// Complete contact, P = 1. gamma_eff(1) may be negative; the state is then
  /// not an equilibrium.
  /// @param height_ratio  h_rms divided by that of the spectrum [1] > 0
  AdhesiveState complete_contact(double height_ratio) const;

  /// Partial contact, the fixed point, by damped iteration from
  /// gamma_eff(q) = Dgamma; `exists` is false if the iteration leads to the
  /// loss of contact.
  AdhesiveState partial_contact(double height_ratio) const;

  /// The state with the larger gamma_eff(1), or no contact (exists = false) if
  /// that value is not positive.
  AdhesiveState equilibrium(double height_ratio) const;

  /// The height ratio at which the two branches have the same gamma_eff(1) and
  /// the equilibrium state changes; found by bisection between two ratios.
  /// @throws std::domain_error  the same branch has the larger gamma_eff(1) at
  ///                            both ratios
  double flip(double from_height_ratio, double to_height_ratio) const;

private:
  struct Node { // end of a step
    double wavevector;
    double moment;      // M(q) [1]
    double energy_step; // int q^2 C dq over the preceding step [m]
  };

  void add_node(const HeightSpectrum& spectrum, double wavevector);
  AdhesiveState state_of(std::vector<double> area_fractions,
                         double height_ratio) const;
  std::vector<double> area_fractions(std::span<const double> works,
                                     double height_ratio) const;

  AdhesivePair pair_;
  std::vector<Node> nodes_;
};

/// JKR pull-off force of a ball on the rough surface, (3 pi/2) R gamma_eff [N].
/// @param sphere_radius   R [m] > 0
/// @param effective_work  gamma_eff(1) [J/m^2]; the force is 0 if it is not
///                        positive
double rough_pull_off_force(double sphere_radius, double effective_work);

} // namespace asperity::theory
