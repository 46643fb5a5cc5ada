#pragma once

// The named numbers of a rough surface: gamma twice, beta, kappa, and how far
// a method is from the theory of the same case.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Fills `summary.fits` and the rough quantities of `summary.quantities`.
/// @param reference  the theory to compare with, or null
void add_rough_quantities(const results::Result& result,
                          const cases::Case& rough_case,
                          const results::MethodRecord& method,
                          const results::MethodRecord* reference,
                          MethodSummary& summary);

/// The curve of a realisation; a theory that ran once stands for all.
const results::Curve& curve_of(const results::MethodRecord& method,
                               std::size_t realization);

} // namespace asperity::reports
