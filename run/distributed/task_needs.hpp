#pragma once

// Predicts what one task needs that computes a part of a run.

#include "run/distributed/part_record.hpp"

#include <vector>

namespace asperity::run {

/// Upper ends of the predictions; NaN where there is none.
struct TaskNeeds {
  double time = 0.0;   ///< [s]
  double memory = 0.0; ///< [B]
};

/// Returns the needs of the largest of the parts, without a cache, by the
/// prediction of a plan times its uncertainty.
///
/// @param records  part_records() of `named`
/// @param threads  of a task, >= 1
/// @throws input::InputError  as make_plan()
TaskNeeds task_needs(const NamedCases& named,
                     const std::vector<PartRecord>& records, int threads);

} // namespace asperity::run
