#pragma once

// Evaluates Persson's theory over a loading path as rows of the common curve.

#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

namespace asperity::methods {

MethodDescription describe(const mechanics::TheorySettings& settings);

/// What a theory is evaluated with.
struct TheoryInput {
  theory::HeightSpectrum spectrum; ///< from the formula or measured
  mechanics::Scales scales;
};

/// Returns the formula of the case, or what a realisation of its surface has.
TheoryInput theory_input(const cases::Case& contact_case,
                         const cases::MethodSpec& method,
                         const CaseSurfaces& surfaces, int realization);

/// Returns one row per load step. Under gap control the pressure is the inverse
/// of Eq. (14) of Yang and Persson (2008). A gap <= 0 has no pressure, and its
/// row is marked as not converged.
std::vector<results::CurvePoint>
theory_rows(const mechanics::TheorySettings& settings,
            const mechanics::LoadingPath& load, const TheoryInput& input);

} // namespace asperity::methods
