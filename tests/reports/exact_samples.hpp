#pragma once

// Results of one method on exact shapes, and their errors.

#include "reports/analysis/exact.hpp"

#include <vector>

namespace asperity::reports {

inline constexpr double contact_modulus = 2e9; // Pa

/// A sphere of radius 10 mm on a square of side 1 mm.
inline cases::Case sphere_case() {
  cases::Case sphere;
  sphere.surface.kind = mechanics::SurfaceKind::sphere;
  sphere.surface.length = 1e-3;
  sphere.surface.radius = 10e-3;
  return sphere;
}

inline results::Result
result_of(const std::vector<results::CurvePoint>& points) {
  results::Result result;
  result.contact_modulus = contact_modulus;
  result.methods = {{"halfspace", "halfspace", "", {{points, {}, 0.0}}}};
  return result;
}

inline MethodSummary summary_of(const results::Result& result,
                                const cases::Case& contact_case) {
  MethodSummary summary;
  add_exact_quantities(result, contact_case, result.methods.front(), summary);
  return summary;
}

} // namespace asperity::reports
