#pragma once

// Compares numerical solutions with exact contact solutions for the shapes that
// have one: the sphere (Hertz), punches, the cone, the 1-D wave (Westergaard)
// and the 2-D wave (its two limits and, between them, the table of the theory
// module).

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::theory {
struct HertzContact;
} // namespace asperity::theory

namespace asperity::reports {

/// The exact solution at one nominal pressure; NaN where none is known.
struct ExactPoint {
  double mean_gap = not_a_number;       ///< [m]
  double area_fraction = not_a_number;  ///< [1]
  double contact_radius = not_a_number; ///< of an indenter [m]
  double approach = not_a_number;       ///< of the isolated contact [m]
  /// Sphere, flat punch or cone with free boundaries, per nominal area [J/m^2].
  double elastic_energy = not_a_number;
};

/// A sphere, punch or cone is one contact, or, with periodic boundaries, that
/// of a square array: the sphere as in square_array_contact() of the theory
/// module, up to a contact radius of 0.3 periods, the others to (a/L)^3. Waves
/// have no solution with free boundaries.
/// @param surface_top  highest point above the mean plane [m]: the mean gap of
///     the sphere at first contact
/// @param is_free      the surface is pressed once, on an infinite half-space
ExactPoint exact_point(const mechanics::SurfaceSpec& surface,
                       double contact_modulus, double nominal_pressure,
                       double surface_top, bool is_free);

/// The nominal pressure from which the surface around the end of a punch
/// touches, at the corners of the map [Pa]; infinite for other shapes. The
/// solution for a flat end alone is not exact from there on, and exact_point()
/// has no numbers.
double touching_pressure(const mechanics::SurfaceSpec& surface,
                         double contact_modulus, bool is_free);

/// The Hertzian contact of a sphere, alone or in a square array.
/// @param load  force F on the sphere [N]
theory::HertzContact sphere_contact(const mechanics::SurfaceSpec& sphere,
                                    double contact_modulus, double load,
                                    bool is_free);

/// Returns what the sum of the approach of an isolated contact and the mean gap
/// of an indenter exceeds the height of its top by [m]. With free
/// boundaries it is the mean displacement of the surface, over the nodes of the
/// map. Of a periodic square array of contacts, whose mean displacement is
/// removed, it is the difference between the approach of an isolated contact
/// and that of the array; see the lattice constants in the theory module.
/// @param load  force F on each contact [N]
double approach_excess(const mechanics::SurfaceSpec& surface,
                       double contact_modulus, double load, bool is_free);

/// Returns the largest error over loads with an exact solution as an estimate.
/// @param missing  why there is none, if `largest` is NaN
Estimate largest_estimate(double largest, const char* missing);

/// Adds area_error and, for waves, mean_gap_error in units of the amplitude;
/// for an indenter, the relative errors contact_radius_error and
/// approach_error. Each is the largest error over the converged loading rows;
/// areas are corrected areas. On a block with free sides only the area and the
/// radius of a sphere or punch are compared.
void add_exact_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          MethodSummary& summary);

/// The rows of a path that have converged.
std::vector<results::CurvePoint> converged_rows(const results::Curve& curve);

/// The largest tension of the converged rows of a path [Pa] >= 0, with that
/// before a jump.
double largest_tension(std::span<const results::CurvePoint> rows);

/// Why faces may hold more than the largest tension of these rows; "" if they
/// show none, or its maximum was passed.
std::string why_more_may_hold(std::span<const results::CurvePoint> rows);

/// Adds, for a method with adhesion, pull_off_pressure, dissipated_energy, for
/// a one-dimensional wave adhesive_wave_error, for a sphere with Dugdale's law
/// adhesive_sphere_error, and of the first state in contact without load in
/// which U is a minimum, on approach and on retraction, unloaded_area_*,
/// unloaded_gap_* [h_rms] and effective_work_*, -U over the work of adhesion.
/// All are of converged rows.
void add_adhesion_quantities(const results::Result& result,
                             const cases::Case& contact_case,
                             const results::MethodRecord& method,
                             MethodSummary& summary);

/// Adds, if the method has found them, normal_stiffness_error and
/// tangential_stiffness_error for a sphere and an upright punch on a clamped
/// periodic block, after the correction for the strain of the block and the
/// other contacts (theory/exact/contact_stiffness.hpp), and moment_error for a
/// tilted punch whose whole end is in contact. Each is the largest relative
/// error over the converged loading rows.
void add_stiffness_quantities(const results::Result& result,
                              const cases::Case& contact_case,
                              const results::MethodRecord& method,
                              MethodSummary& summary);

} // namespace asperity::reports
