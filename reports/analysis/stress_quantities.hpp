#pragma once

// The stress below the face that a result's tables hold, as numbers with
// names.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// The name of a method's table of strongest points, and of its section.
std::string stress_table_name(const std::string& method);
std::string stress_section_name(const std::string& method);

/// Where the von Mises stress under a Hertz contact is largest.
struct HertzStrength {
  double von_mises = not_a_number; ///< over p_0 [1]
  double depth = not_a_number;     ///< over a [1]
};

/// Found on the axis, where it lies for metals and most else (nu above 0.08 or
/// so): 0.620 p_0 at 0.481 a for nu = 0.3.
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 4.2
HertzStrength hertz_strength(double poisson_ratio);

/// For a sphere: von_mises_error and von_mises_depth_error, the largest
/// relative ones over the maps kept; nothing where the result has no such
/// table.
void add_stress_quantities(const results::Result& result,
                           const cases::Case& exact_case,
                           const results::MethodRecord& method,
                           MethodSummary& summary);

} // namespace asperity::reports
