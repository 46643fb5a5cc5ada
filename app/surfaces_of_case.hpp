#pragma once

// The surfaces a case needs, built once: heights, statistics, spectrum, and
// what the theory is given of them. Owns the decision not to build any.

#include "cases/case.hpp"
#include "results/result.hpp"
#include "theory/height_spectrum.hpp"

#include <optional>
#include <vector>

namespace asperity::app {

/// The surface of one realisation as every method takes it.
struct SurfaceOfCase {
  results::SurfaceRecord record; ///< heights, statistics, C(q)
  cases::Scales scales;          ///< the yardsticks' values on it
};

/// True if a method of the case needs heights: all but a theory that takes
/// its spectrum from the formula.
bool needs_surfaces(const cases::Case& rough_case);

/// One a realisation; empty if none is needed.
/// @throws cases::CaseError, std::domain_error  what the surface room refuses
std::vector<SurfaceOfCase> build_surfaces(const cases::Case& rough_case);

/// The formula's spectrum for the theory, or the measured one of a surface.
theory::HeightSpectrum formula_of_case(const cases::Case& rough_case);
theory::HeightSpectrum spectrum_of(const SurfaceOfCase& surface);

/// The yardsticks of a case that builds no surface; rms height by the formula,
/// spacing 0 where the case gives no points.
cases::Scales formula_scales(const cases::Case& rough_case,
                             const theory::HeightSpectrum& spectrum);

} // namespace asperity::app
