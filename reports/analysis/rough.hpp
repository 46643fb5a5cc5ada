#pragma once

// Computes the named quantities of a rough surface: gamma by two definitions,
// beta, kappa, and the deviation of a method from the theory of the same case.

#include "reports/analysis/summary.hpp"
#include "reports/analysis/surface_theory.hpp"

namespace asperity::reports {

/// Fills `summary.fits` and the rough quantities of `summary.quantities`.
/// @param reference  the theory to compare with, or null
void add_rough_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          const results::MethodRecord* reference,
                          SurfaceTheories& theories, MethodSummary& summary);

/// Returns the curve of a realisation. A theory that ran only once provides the
/// same curve for all realisations.
const results::Curve& curve_of(const results::MethodRecord& method,
                               std::size_t realization);

} // namespace asperity::reports
