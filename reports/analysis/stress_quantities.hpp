#pragma once

// Computes named quantities of the subsurface stress from the tables of a
// result.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Return the names of a method's table of stress maxima and of its section.
std::string stress_table_name(const std::string& method);
std::string stress_section_name(const std::string& method);
std::string stress_sections_name(const std::string& method);

/// Location and value of the largest von Mises stress under a Hertz contact.
struct HertzStrength {
  double von_mises = not_a_number; ///< in units of p_0 [1]
  double depth = not_a_number;     ///< in units of a [1]
};

/// Finds the maximum on the axis, where it lies for metals and most other
/// materials (nu above about 0.08): 0.620 p_0 at 0.481 a for nu = 0.3.
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 4.2
HertzStrength hertz_strength(double poisson_ratio);

/// Adds, for a sphere, von_mises_error and von_mises_depth_error, the largest
/// relative errors over the saved maps. Nothing is added if the result has no
/// such table.
void add_stress_quantities(const results::Result& result,
                           const cases::Case& contact_case,
                           const results::MethodRecord& method,
                           MethodSummary& summary);

} // namespace asperity::reports
