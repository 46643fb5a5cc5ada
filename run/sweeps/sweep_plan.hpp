#pragma once

// Predicts what a sweep costs, point by point, before it runs.

#include "cases/sweeps/sweep.hpp"
#include "run/plan/plan.hpp"
#include "run/plan/run_options.hpp"

#include <string>
#include <vector>

namespace asperity::run {

struct SweepPlan {
  std::vector<Plan> points;
  int threads = 1;             ///< of the whole sweep
  double available_memory = 0; ///< [B]

  /// Returns the predicted CPU time of all points [s]; NaN if one has no
  /// prediction.
  double cpu_time() const;
  /// Returns the predicted wall time of the sweep [s]: the CPU time over the
  /// threads, and at least the longest point.
  double wall_time() const;
  /// Returns how many points run beside each other: as many as there are
  /// threads, and as fit into the memory. At least one.
  int beside() const;
};

/// Makes the plans of all points.
///
/// @param options        those of the sweep; the folder is not used
/// @param largest_probe  see MachineRates
/// @throws input::InputError  as make_plan(); or a point that does not fit into
///                            the available memory, which is named
SweepPlan make_sweep_plan(const cases::CaseSweep& sweep,
                          const RunOptions& options, int largest_probe);

/// Formats the points with their predicted time and memory, and the total.
std::string sweep_plan_text(const SweepPlan& plan,
                            const cases::CaseSweep& sweep);

} // namespace asperity::run
