#pragma once

// Scenes in child processes, so that one that crashes or never ends takes
// nothing with it. Owns the processes and the clock.

#include <functional>
#include <span>

#include "robustness/scene.hpp"
#include "robustness/scene_report.hpp"

namespace asperity::robustness {

/// How many at a time, and how long one may take.
struct PoolSettings {
  int processes = 0;           ///< 0: as many as the machine has cores
  double scene_seconds = 60.0; ///< CPU time > 0; ten times as much waiting
};

/// What a child does with a scene; run_scene but in tests.
using RunOne = std::function<SceneReport(const Scene&)>;

/// Runs every scene once, in forked processes that take one scene after the
/// other, and gives each report to `take` in this process as it comes. A
/// process that dies or exceeds the time is reported as that of the scene it
/// was at, and another goes on. Which process runs what changes no report but
/// its seconds. To be called from a process with one thread.
/// @throws std::system_error  no process could be started
/// @throws std::domain_error   scene_seconds is not positive
void run_scenes(std::span<const Scene> scenes, const PoolSettings& settings,
                const std::function<void(const SceneReport&)>& take,
                const RunOne& run_one);

} // namespace asperity::robustness
