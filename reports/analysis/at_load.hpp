#pragma once

// Numbers of a curve at one load, as [expect] and reference.csv ask for them:
// "area_fraction@p=0.0129 E*".

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// The names at a load that a case's expectations and its references ask for,
/// each once.
std::vector<std::string>
names_at_load(std::span<const cases::Expectation> expectations,
              std::span<const cases::ReferenceValue> references);

/// Adds each of `names` that this kind of method answers: the mean over the
/// realisations of what CurveFunction has at that pressure. Without a value,
/// and with the reason, where the load lies outside the curve or the curve has
/// no such column.
/// @param reference  the theory an excess is over, or null: no excess then
void add_quantities_at_load(const results::Result& result,
                            const cases::Case& contact_case,
                            const results::MethodRecord& method,
                            const results::MethodRecord* reference,
                            std::span<const std::string> names,
                            MethodSummary& summary);

} // namespace asperity::reports
