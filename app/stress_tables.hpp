#pragma once

// The stress below the face of a case's blocks, as tables of its result: the
// strongest point under each kept pressure map, and a section through one.

#include "cases/case.hpp"
#include "contact/stress_inside.hpp"
#include "results/result_writer.hpp"

#include <span>

namespace asperity::app {

/// A row a map: its load, the strongest von Mises stress, the largest shear
/// stress at that point, and where it lies.
results::Table stress_table(const std::string& method,
                            const contact::ElasticBlock& block,
                            std::span<const results::Fields> maps, int threads);

/// The von Mises stress of one map in the plane of x and depth through `peak`,
/// its strongest point: rows of depth, x fastest, from the face to four times
/// the point's depth, or half as deep again as the block's layers, and once and
/// a half that to either side (or the whole side); x from the point.
results::Table stress_section(const std::string& method,
                              const contact::ElasticBlock& block,
                              const results::Fields& map,
                              const contact::StressPeak& peak, int threads);

/// Records both for every method of the result that kept maps, if the case
/// asks for it ([report] stress_inside): "stress-inside-<method>" of
/// realisation 0, and "stress-section-<method>" of the heaviest load. The
/// block is the method's as a continuum: half-space or slab, E* and nu of the
/// case (atoms: the half-space).
void record_stress_inside(const cases::Case& rough_case,
                          std::span<const cases::MethodSpec> methods,
                          const cases::Scales& scales, int threads,
                          results::ResultWriter& writer);

} // namespace asperity::app
