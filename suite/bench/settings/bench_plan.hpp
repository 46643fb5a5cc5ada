#pragma once

// Selects the settings of the methods that a benchmark runs. It owns the table
// of axes; every method whose vocabulary contains the key of an axis is
// included automatically.

#include "input/types/case.hpp"
#include "suite/bench/analysis/bench.hpp"

#include <string>
#include <vector>

namespace asperity::bench {

/// The settings, coarse before fine within a series and in order of importance:
/// reference solution, points, then the other axes. The points describe the
/// settings and have no costs yet.
struct BenchPlan {
  std::vector<std::string> common; ///< overrides of every run
  std::vector<BenchPoint> points;
  std::vector<BenchSeries> series;
  std::size_t reference_series = no_reference; ///< index into `series`
  std::vector<std::string> remarks;

  static constexpr std::size_t no_reference = static_cast<std::size_t>(-1);
};

struct BenchPlanOptions {
  std::vector<std::string> methods; ///< names or kinds; empty: all
  bool is_quick = false;            ///< points only
  int realizations = 1;
};

/// Varies one key at a time around the case's own settings. The points per side
/// are N/4, N/2, N and, for the reference solution, 2 N; coarse values that do
/// not resolve the roughness are replaced by the smallest number that does. The
/// reference solution is the elastic half-space (or the slab that corresponds
/// to the case's block) with hard contact. The other keys are varied at N/2 if
/// N is 256 or more. A variant such as "fem.hard" varies the points and the
/// keys that it sets itself.
BenchPlan bench_plan_of(const cases::Case& contact_case,
                        const BenchPlanOptions& options);

/// Returns the smallest number of points per side, even and of the form 2^a
/// 3^b 5^c, for which transforms are fast, whose grid resolves all of the
/// roughness in the case.
int least_carrying_points(const mechanics::SurfaceSpec& surface);

/// Returns the overrides that apply to every run of a benchmark: the number of
/// realisations, and lengths that the case gives in node spacings, converted to
/// metres.
std::vector<std::string> common_overrides(const cases::Case& contact_case,
                                          int realizations);

} // namespace asperity::bench
