#pragma once

// The one factor that brings the theory's whole curve A(p) to a method's, as in
// Fig. 16 of Yang and Persson (2008), and how it depends on the loads taken.

#include "reports/analysis/comparison.hpp"
#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Halves by number of loads, in ascending order; of an odd number the middle
/// one is in both.
enum class LoadRange { all, lower_half, upper_half };

struct AreaScale {
  FittedValue factor;                  ///< [1]
  double pressure_low = not_a_number;  ///< of the loads taken [Pa]
  double pressure_high = not_a_number; ///< [Pa]
  int rows = 0;
};

/// Least squares of A = factor A_theory over the rows where both areas are
/// known and above 0, each row with equal weight: the heavier loads, where
/// A is larger, count for more. At least 3 rows.
/// @param rows  in ascending pressure, as deviations() returns them
AreaScale fit_area_scale(std::span<const Deviation> rows, LoadRange range);

/// "area_scale", "area_scale_lower_half", "area_scale_corrected_upper_half".
std::string area_scale_name(bool is_corrected, LoadRange range);

/// Adds the six of them: counted and corrected area, over all loads of the
/// curve that the theory also has and over either half of those. Each remark
/// states the loads.
void add_area_scales(const results::MethodRecord& method,
                     const results::MethodRecord& reference,
                     double contact_modulus, MethodSummary& summary);

} // namespace asperity::reports
