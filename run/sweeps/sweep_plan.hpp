#pragma once

// Predicts what the points of a sweep need before they run.

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

  /// Returns how many points run beside each other: as many as there are
  /// threads, and as fit into the memory. At least one.
  int beside() const;
};

/// Makes the plans of all points.
///
/// @param options  those of the sweep; the folder is not used
/// @throws input::InputError  as make_plan(); or a point that does not fit into
///                            the available memory, which is named
SweepPlan make_sweep_plan(const cases::CaseSweep& sweep,
                          const RunOptions& options);

/// Formats the points with their steps and predicted memory.
std::string sweep_plan_text(const SweepPlan& plan,
                            const cases::CaseSweep& sweep);

} // namespace asperity::run
