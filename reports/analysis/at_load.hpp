#pragma once

// Evaluates quantities of a curve at a single load, as [expect] and
// reference.csv request them: "area_fraction@p=0.0129 E*".

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns the names at a load that a case's expectations and references
/// request, without repetition.
std::vector<std::string>
names_at_load(std::span<const cases::Expectation> expectations,
              std::span<const cases::ReferenceValue> references);

/// Adds each of `names` that applies to this kind of method: the mean over the
/// realisations of CurveFunction at that pressure. The estimate has no value,
/// but a reason, if the load lies outside the curve or the curve has no such
/// column.
/// @param reference  the theory relative to which an excess is computed; null:
///     no excess is added
void add_quantities_at_load(const results::Result& result,
                            const cases::Case& contact_case,
                            const results::MethodRecord& method,
                            const results::MethodRecord* reference,
                            std::span<const std::string> names,
                            MethodSummary& summary);

} // namespace asperity::reports
