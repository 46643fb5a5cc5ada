#pragma once

// Runs instances in child processes, so that one that crashes or does not
// terminate does not affect the others. It owns the processes and the time
// limit.

#include "suite/robustness/instance.hpp"
#include "suite/robustness/instance_report.hpp"

#include <functional>

namespace asperity::robustness {

/// The number of processes, and the time limit of an instance.
struct PoolSettings {
  int processes = 0; ///< 0: one per core of the machine
  /// CPU time > 0; the limit of the wall time is ten times as large
  double instance_seconds = 60.0;
  /// Asked several times per second; true ends all processes. Null: never.
  bool (*is_interrupted)() = nullptr;
};

/// The function that a child runs on an instance: run_instance(), except in
/// tests.
using RunOne = std::function<InstanceReport(const Instance&)>;

/// Takes an instance that has ended, and its report.
using TakeReport = std::function<void(const Instance&, const InstanceReport&)>;

/// Runs every instance once, in forked processes that draw and run one instance
/// after another, and passes each report to `take` in this process as it
/// arrives. A process that dies or exceeds the time limit is reported for the
/// instance it was running, and another process continues. The assignment of
/// instances to processes affects nothing in the reports but the run time. The
/// calling process must have a single thread. After an interrupt, the instances
/// that have not ended are not reported.
/// @throws std::system_error  no process could be started
/// @throws std::domain_error   instance_seconds is not positive
void run_instances(InstanceSequence& instances, const PoolSettings& settings,
                   const TakeReport& take, const RunOne& run_one);

} // namespace asperity::robustness
