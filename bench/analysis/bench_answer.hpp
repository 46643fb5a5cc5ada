#pragma once

// From a result to the numbers a benchmark compares, and the measure of their
// distance.

#include "bench/analysis/bench.hpp"

namespace asperity::reports {

/// The answer of the one method of a result that has that name. Every curve
/// column "area_fraction..." is an estimator, so one that is added later joins
/// by itself; a step that did not converge has NaN everywhere.
/// @param contact_case  whose expectations name the quantities at a load
/// @throws std::domain_error  the result has no such method
BenchAnswer answer_of(const results::Result& result,
                      const cases::Case& contact_case,
                      const std::string& method);

/// What the entries of a quantity are measured in: h_rms for the gap, the
/// truth's own values for everything else.
std::vector<double> scale_of(const std::string& quantity,
                             const BenchAnswer& truth);

/// Root mean square over the loads; NaN if either lacks a value, or the loads
/// are not the same. Every area is held against the truth's corrected one
/// where the truth has none of its own.
double error_against(const BenchAnswer& truth, const BenchAnswer& answer,
                     const std::string& quantity);

/// The exact solution at the loads of `answer`, for those quantities that it
/// answers at every load; the elastic energy is the work of the pressure,
///
///     U(p) = integral_0^p (u(p') - u(p)) dp'
///
/// per nominal area. Empty for shapes without an exact solution.
BenchAnswer exact_answer(const cases::Case& contact_case,
                         const BenchAnswer& answer);

/// "Westergaard", "Hertz", ...; empty for shapes without an exact solution.
std::string exact_words(const cases::Case& contact_case);

} // namespace asperity::reports
