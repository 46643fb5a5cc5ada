#pragma once

// Persson's theory over a load program, as rows of the common curve.

#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"

namespace asperity::app {

MethodDescription describe(const cases::TheorySettings& settings);

/// One row a load step. Under gap control the pressure is the inverse of (14);
/// a gap <= 0 has none and is a row that did not converge.
/// @param spectrum  of the formula, or measured
std::vector<results::CurvePoint> theory_rows(
    const cases::TheorySettings& settings, const cases::LoadProgram& load,
    const theory::HeightSpectrum& spectrum, const cases::Scales& scales);

} // namespace asperity::app
