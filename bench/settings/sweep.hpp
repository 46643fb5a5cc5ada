#pragma once

// Which settings of which methods a benchmark runs. Owns the table of axes;
// every method whose vocabulary has an axis's key joins by itself.

#include "cases/types/case.hpp"

#include <string>
#include <vector>

#include "bench/analysis/bench.hpp"

namespace asperity::app {

/// The settings, coarse ones first within a series, in the order in which they
/// are worth running: truth, points, then the other axes. Points carry what
/// they are, not yet what they cost.
struct Sweep {
  std::vector<std::string> common; ///< overrides of every run
  std::vector<reports::BenchPoint> points;
  std::vector<reports::BenchSeries> series;
  std::size_t truth = no_truth; ///< of `series`
  std::vector<std::string> remarks;

  static constexpr std::size_t no_truth = static_cast<std::size_t>(-1);
};

struct SweepOptions {
  std::vector<std::string> methods; ///< names or kinds; empty: all
  bool is_quick = false;            ///< points alone
  int realizations = 1;
};

/// One key is varied at a time, around the case's own settings: points a side
/// N/4, N/2, N, or in place of the coarse ones the fewest that carry the
/// roughness, and 2 N for the truth,
/// which is the half-space (or the slab that the case's block is) with a hard
/// wall. The other keys are varied at N/2 where N is 256 or more. A variant,
/// "fem.hard", varies points and the keys it sets itself.
Sweep sweep_of(const cases::Case& contact_case, const SweepOptions& options);

/// The fewest points a side, 2^a 3^b 5^c and even, whose grid carries all of
/// the roughness that the case asks for; at least 16.
int least_carrying_points(const cases::SurfaceSpec& surface);

/// Overrides that hold for every run of a benchmark: realisations, and lengths
/// that the case gives in node spacings written in metres.
std::vector<std::string> common_overrides(const cases::Case& contact_case,
                                          int realizations);

/// The elastic half-space or slab with a hard wall that the case's block is,
/// as overrides of a method "halfspace"; empty if the case has it already.
std::vector<std::string> truth_overrides(const cases::Case& contact_case);

} // namespace asperity::app
