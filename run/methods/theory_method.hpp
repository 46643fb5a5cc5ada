#pragma once

// Evaluates Persson's theory over a loading path as rows of the common curve.

#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

namespace asperity::methods {

MethodDescription describe(const mechanics::TheorySettings& settings);

/// Returns one row per load step. Under gap control the pressure is the inverse
/// of Eq. (14) of Yang and Persson (2008). A gap <= 0 has no pressure, and its
/// row is marked as not converged.
///
/// @param spectrum  from the formula or measured
std::vector<results::CurvePoint>
theory_rows(const mechanics::TheorySettings& settings,
            const mechanics::LoadingPath& load,
            const theory::HeightSpectrum& spectrum,
            const mechanics::Scales& scales);

} // namespace asperity::methods
