#pragma once

// This file compares numerical solutions with exact contact solutions for the
// shapes that have one: the sphere (Hertz), the 1-D wave (Westergaard) and the
// 2-D wave (its two limits and, between them, the table of the theory module).

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// The exact solution at one nominal pressure; NaN where none is known.
struct ExactPoint {
  double mean_gap = not_a_number;       ///< [m]
  double area_fraction = not_a_number;  ///< [1]
  double contact_radius = not_a_number; ///< sphere [m]
  double approach = not_a_number;       ///< sphere, isolated [m]
};

/// @param surface_top  highest point above the mean plane [m]: the mean gap of
///     the sphere at first contact
ExactPoint exact_point(const cases::SurfaceSpec& surface,
                       double contact_modulus, double nominal_pressure,
                       double surface_top);

/// Returns the difference [m] between the approach of an isolated contact and
/// that of a periodic square array of contacts whose uniform displacement is
/// removed; see the lattice constant in the theory module.
/// @param load    force F per cell [N]
/// @param length  side of the cell [m]
double periodic_approach(double load, double length, double contact_modulus);

/// Adds area_error and, for waves, mean_gap_error in units of the amplitude;
/// for the sphere, the relative errors contact_radius_error and approach_error.
/// Each is the largest error over the converged loading rows; areas are
/// corrected areas.
void add_exact_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          MethodSummary& summary);

} // namespace asperity::reports
