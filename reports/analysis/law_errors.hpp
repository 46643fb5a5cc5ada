#pragma once

// How well a theory describes area, energy and separation that a method
// computed on the same surfaces.

#include "input/types/case.hpp"
#include "reports/numbers/estimate.hpp"
#include "results/types/result.hpp"

#include <map>
#include <string>

namespace asperity::reports {

/// Adds law_area_error, law_energy_error and law_gap_error of a theory: root
/// mean square over the loads of the deviation from the first other method of
/// the result, with the mean over the realisations at each load. Area
/// (corrected) and energy are relative, at 1 % <= A/A_0 <= 99 %; the separation
/// is in units of h_rms, at 0 < u <= 2 h_rms. Loads that a realisation lacks
/// are left out, and at least 3 are required. Nothing is added if there is no
/// other method.
void add_law_errors(const results::Result& result,
                    const cases::Case& contact_case,
                    const results::MethodRecord& theory,
                    std::map<std::string, Estimate>& quantities);

} // namespace asperity::reports
