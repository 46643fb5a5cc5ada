#pragma once

// The adhesive contact of a sphere and an elastic half-space: the theories of
// Johnson, Kendall and Roberts (JKR) and of Derjaguin, Muller and Toporov
// (DMT), and the transition between them by Maugis.

namespace asperity::theory {

/// The sphere and its adhesion. For two spheres 1/R = 1/R_1 + 1/R_2.
struct AdhesiveSphere {
  double sphere_radius = 0.0;    ///< R [m] > 0
  double contact_modulus = 0.0;  ///< E* [Pa] > 0
  double work_of_adhesion = 0.0; ///< w [J/m^2] > 0
};

/// One equilibrium state. Tensile loads are negative.
struct AdhesiveContact {
  double contact_radius = 0.0;  ///< a [m]
  double adhesive_radius = 0.0; ///< c >= a [m]: attraction in a < r < c
  double approach = 0.0;        ///< delta [m]; negative under tension
  double load = 0.0;            ///< F [N]
};

/// JKR theory, with attraction inside the contact only:
///
///     F     = 4 E* a^3/(3 R) - sqrt(8 pi w E* a^3),
///     delta = a^2/R - sqrt(2 pi w a/E*).
///
/// @param contact_radius  a [m] >= 0
/// @throws std::domain_error  an argument is outside its range or not finite,
///         as for all functions of this file
/// @par Accuracy  roundoff. Model: valid for a large Tabor parameter.
/// @see  K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. A 324, 301
///       (1971)
AdhesiveContact jkr_contact(const AdhesiveSphere& sphere,
                            double contact_radius);

/// The stable JKR contact under a load,
///     a^3 = (3 R/4 E*) [F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2)].
/// @param load  F [N] >= -(3/2) pi w R
AdhesiveContact jkr_contact_at_load(const AdhesiveSphere& sphere, double load);

/// JKR contact pressure (2 E* a/pi R) sqrt(1 - r^2/a^2) -
/// sqrt(2 E* w/(pi a))/sqrt(1 - r^2/a^2) for r < a, minus infinity at the edge,
/// 0 outside [Pa].
double jkr_pressure(const AdhesiveSphere& sphere, double contact_radius,
                    double radius);

/// JKR pull-off force under a fixed load, (3/2) pi w R [N] > 0.
double jkr_pull_off_force(const AdhesiveSphere& sphere);

/// DMT theory, Hertzian contact with attraction outside it:
///     F = 4 E* a^3/(3 R) - 2 pi w R,  delta = a^2/R.
/// The theory does not specify the range of attraction, nor therefore c; c = a
/// is returned.
/// @see  B. V. Derjaguin, V. M. Muller, Yu. P. Toporov, J. Colloid Interface
///       Sci. 53, 314 (1975), with Maugis' form of the load
AdhesiveContact dmt_contact(const AdhesiveSphere& sphere,
                            double contact_radius);

/// DMT pull-off force, 2 pi w R [N] > 0.
double dmt_pull_off_force(const AdhesiveSphere& sphere);

/// Maugis's theory: the surfaces attract each other with a constant stress
/// sigma_0 up to a gap w/sigma_0, which is reached at r = c (Dugdale model).
/// With K = 4 E*/3, A = a/(pi w R^2/K)^{1/3}, n = c/a and
///
///     lambda = 2 sigma_0 (R/(pi w K^2))^{1/3},
///     1       = (lambda A^2/2) [s + (n^2 - 2) t] +
///               (4 lambda^2 A/3) [s t - n + 1],      s = sqrt(n^2 - 1),
///     F/pi w R = A^3 - lambda A^2 [s + n^2 t],         t = arcsec n,
///     delta   = (pi^2 w^2 R/K^2)^{1/3} [A^2 - (4/3) lambda A s].
///
/// The limit lambda -> infinity is JKR, the limit lambda -> 0 is DMT.
/// @see  D. Maugis, J. Colloid Interface Sci. 150, 243 (1992)
class MaugisSphere {
public:
  /// @param adhesive_stress  sigma_0 [Pa] > 0
  MaugisSphere(const AdhesiveSphere& sphere, double adhesive_stress);

  /// lambda [1]; the Tabor parameter is 0.864 lambda for a Lennard-Jones
  /// potential.
  double transition_parameter() const { return transition_parameter_; }

  /// @param contact_radius  a [m] > 0
  /// @par Accuracy  1e-12 of pi w R and of a^2/R for a < 30 (pi w R^2/K)^{1/3}
  AdhesiveContact contact(double contact_radius) const;

  /// The stable contact under a load.
  /// @param load  F [N] >= -pull_off_force()
  AdhesiveContact contact_at_load(double load) const;

  /// Hertzian pressure minus (sigma_0/pi)
  /// arccos[(2a^2 - c^2 - r^2)/(c^2 - r^2)] for r < a, -sigma_0 for a < r < c,
  /// 0 outside [Pa].
  double pressure(const AdhesiveContact& contact, double radius) const;

  /// Pull-off force under a fixed load, the minimum of F over a, which for
  /// small lambda is at a -> 0 [N] > 0.
  /// @par Accuracy  1e-9 relative
  double pull_off_force() const;

private:
  double weakest_radius() const; // a at the minimum of F

  AdhesiveSphere sphere_;
  double adhesive_stress_;
  double radius_unit_; // (pi w R^2/K)^{1/3}
  double transition_parameter_;
};

} // namespace asperity::theory
