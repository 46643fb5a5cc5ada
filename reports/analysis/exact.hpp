#pragma once

// Numerical answers held against exact contact solutions, for the shapes that
// have one: sphere (Hertz), 1-D wave (Westergaard), 2-D wave (its two ends and,
// between them, theory's table).

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// The exact answer at one nominal pressure; NaN where none is known.
struct ExactPoint {
  double mean_gap = not_a_number;       ///< [m]
  double area_fraction = not_a_number;  ///< [1]
  double contact_radius = not_a_number; ///< sphere [m]
  double approach = not_a_number;       ///< sphere, isolated [m]
};

/// @param surface_top  highest point over the mean plane [m]: the sphere's
///                     mean gap at first touch
ExactPoint exact_point(const cases::SurfaceSpec& surface,
                       double contact_modulus, double nominal_pressure,
                       double surface_top);

/// What a periodic square array of contacts, its uniform displacement removed,
/// lacks of the approach of one contact alone [m]: see theory's lattice
/// constant.
/// @param load    F of one cell [N]
/// @param length  side of the cell [m]
double periodic_approach(double load, double length, double contact_modulus);

/// Adds area_error and, for waves, mean_gap_error in amplitudes; for the sphere
/// contact_radius_error and approach_error, relative. Each is the largest over
/// the converged loading rows; areas are the corrected ones.
void add_exact_quantities(const results::Result& result,
                          const cases::Case& exact_case,
                          const results::MethodRecord& method,
                          MethodSummary& summary);

} // namespace asperity::reports
