#pragma once

// The adhesive contact of a sphere and an elastic half-space by Maugis's
// theory, between the limits of Johnson, Kendall and Roberts (JKR) and of
// Derjaguin, Muller and Toporov (DMT).

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
/// The limit lambda -> infinity is JKR, the limit lambda -> 0 is DMT. All
/// members throw std::domain_error for an argument that is outside its range or
/// not finite.
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
