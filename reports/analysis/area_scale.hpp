#pragma once

// Fits the single factor that scales the theory's entire curve A(p) to that of
// a method, as in Fig. 16 of Yang and Persson (2008), and shows how the factor
// depends on the range of loads.

#include "reports/analysis/comparison.hpp"
#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// The halves are counted by number of loads, in ascending order. If the number
/// is odd, the middle load belongs to both halves.
enum class LoadRange { all, lower_half, upper_half };

struct AreaScale {
  FittedValue factor;                  ///< [1]
  double pressure_low = not_a_number;  ///< lowest load used [Pa]
  double pressure_high = not_a_number; ///< highest load used [Pa]
  int rows = 0;
};

/// Fits A = factor A_theory by least squares over the rows in which both areas
/// are known and positive. All rows have equal weight, so that the heavier
/// loads, where A is larger, count for more. At least 3 rows are required.
/// @param rows  in ascending pressure, as deviations() returns them
AreaScale fit_area_scale(std::span<const Deviation> rows, LoadRange range);

/// Returns "area_scale", "area_scale_lower_half",
/// "area_scale_corrected_upper_half" and so on.
std::string area_scale_name(bool is_corrected, LoadRange range);

/// Adds the six factors: for the counted and for the corrected area, over all
/// loads that the curve and the theory share and over either half of these
/// loads. Each remark states the loads.
void add_area_scales(const results::MethodRecord& method,
                     const results::MethodRecord& reference,
                     double contact_modulus, MethodSummary& summary);

} // namespace asperity::reports
