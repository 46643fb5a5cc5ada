#pragma once

// The stress below the face of a case's blocks, as tables of its result: the
// strongest point under each kept pressure map, and which has a section.

#include "app/run/method_job.hpp"
#include "cases/types/case.hpp"
#include "contact/operators/stress_inside.hpp"
#include "results/result_writer.hpp"

#include <span>

namespace asperity::app {

/// A row a map: its load, the strongest von Mises stress, the largest shear
/// stress at that point, and where it lies.
results::Table stress_table(const std::string& method,
                            const contact::ElasticBlock& block,
                            std::span<const results::Fields> maps, int threads);

/// The same of a whole block's own stress, from the rows of its curve, with
/// what its pressure gives beside it.
/// @param of_pressure  stress_table of these maps
/// @param rows         of the maps' curve; each map has one
results::Table own_stress_table(const results::Table& of_pressure,
                                std::span<const results::Fields> maps,
                                std::span<const results::CurvePoint> rows);

/// Records both for every method of the result that kept maps, if the case
/// asks for it ([report] stress_inside): "stress-inside-<method>" of
/// realisation 0, and "stress-section-<method>" of the heaviest load. The
/// block is the method's as a continuum: half-space or slab, E* and nu of the
/// case (atoms: the half-space). A whole block has its own strongest points in
/// its rows, and its own section in the file since its step was solved. What
/// cannot be computed is tallied and ends nothing.
void record_stress_inside(const cases::Case& rough_case,
                          std::span<const cases::MethodSpec> methods,
                          const cases::Scales& scales, int threads,
                          results::ResultWriter& writer, Tally& tally);

} // namespace asperity::app
