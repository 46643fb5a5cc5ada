#pragma once

// Derives from the runs of a benchmark how their time depends on the number of
// threads or ranks: strong scaling, where all runs compute the same, and weak
// scaling, where the work grows with the workers.

#include "bench/analysis/bench.hpp"

namespace asperity::bench {

/// One run of a scaling series against its first run, which has the fewest
/// workers.
struct ScalingRow {
  std::size_t point = 0; ///< index into Bench::points
  int workers = 1;       ///< threads or ranks
  /// First wall time over this one, times the ratio of the nodes.
  double speed_up = not_a_number;
  /// speed_up over the ratio of the workers; 1 is ideal.
  double efficiency = not_a_number;
  /// CPU time per node over that of the first run: what the workers cost.
  double cpu_ratio = not_a_number;
  /// Strong scaling: whether the numbers are those of the first run, bit for
  /// bit.
  bool has_same_bits = true;
};

/// Returns one row per run that has a result; none if the first run has none.
std::vector<ScalingRow> scaling_rows(const Bench& bench,
                                     const ScalingSeries& series);

} // namespace asperity::bench
