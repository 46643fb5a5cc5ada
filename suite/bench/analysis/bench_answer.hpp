#pragma once

// Extracts from a result the quantities that a benchmark compares, and defines
// the norm of their difference.

#include "suite/bench/analysis/bench.hpp"

namespace asperity::bench {

/// The contact pressure of a sphere as a quantity: its value is the difference
/// from Hertz's solution, so that the exact value is 0.
inline constexpr const char* pressure_field = "pressure_field";

/// Returns the results of the method with this name. Every curve column
/// "area_fraction..." is an estimator, so that columns added later are included
/// automatically. A step that did not converge has NaN in all quantities.
/// @param contact_case  its expectations name the quantities at a load
/// @throws std::domain_error  the result has no such method
BenchAnswer answer_of(const results::Result& result,
                      const cases::Case& contact_case, const std::string& name);

/// Whether two answers consist of the same numbers, bit for bit.
bool have_same_bits(const BenchAnswer& one, const BenchAnswer& other);

/// Returns the scale of each entry of a quantity: h_rms for the gap, the values
/// of the reference solution for everything else.
std::vector<double> scale_of(const std::string& quantity,
                             const BenchAnswer& reference);

/// Returns the root-mean-square error over the loads; NaN if either argument
/// lacks a value or if the loads differ. An area for which the reference
/// solution has no value is compared with its corrected area.
double error_against(const BenchAnswer& reference, const BenchAnswer& answer,
                     const std::string& quantity);

/// Returns the exact solution at the loads of `answer`, for the quantities that
/// it provides at every load. The elastic energy per nominal area is the work
/// of the pressure,
///
///     U(p) = integral_0^p (u(p') - u(p)) dp'
///
/// The result is empty for shapes without an exact solution.
BenchAnswer exact_answer(const cases::Case& contact_case,
                         const BenchAnswer& answer);

/// Returns "Westergaard", "Hertz", ...; empty for shapes without an exact
/// solution.
std::string exact_words(const cases::Case& contact_case);

} // namespace asperity::bench
