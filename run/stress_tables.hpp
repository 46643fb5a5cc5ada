#pragma once

// Tables of the subsurface stress in the blocks of a case: the strongest point
// under each saved pressure map, and the section for the highest load.

#include "contact/operators/stress_inside.hpp"
#include "input/types/case.hpp"
#include "run/method_job.hpp"
#include "run/methods/stress_section.hpp"

#include <span>

namespace asperity::run {

/// Returns a table with one row per map: load, largest von Mises stress,
/// largest shear stress at that point, and the position of the point.
results::Table stress_table(const std::string& method,
                            const methods::StressUnderMaps& stress,
                            std::span<const results::Fields> maps);

/// Returns the same table for the finite-element stress of a full block, taken
/// from the rows of its curve, together with the values that follow from its
/// pressure.
///
/// @param of_pressure  stress_table() of these maps
/// @param rows         rows of the curve of the maps; each map has one
results::Table own_stress_table(const results::Table& of_pressure,
                                std::span<const results::Fields> maps,
                                std::span<const results::CurvePoint> rows);

/// Records both tables for every method with saved fields if the case requests
/// it ([report] stress_inside): "stress-inside-<method>" of realisation 0, and
/// "stress-section-<method>" of the highest load, as well as
/// "stress-sections-<method>" of several loads. The block is the continuum
/// model of the method: a half-space or slab with E* and nu of the case (atoms:
/// the half-space). A full block stores its own strongest points in its rows,
/// and its own section was written to the file when its step was solved. What
/// cannot be computed is recorded in the tally and does not end the run.
///
/// @param run     on rank 0
/// @param scales  of the surface of the case
void record_stress_inside(const RunContext& run,
                          std::span<const cases::MethodSpec> methods,
                          const mechanics::Scales& scales);

} // namespace asperity::run
