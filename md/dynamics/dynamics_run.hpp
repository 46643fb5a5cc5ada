#pragma once

// A load step answered by motion in time: damped until it rests, or hot and
// averaged. Owns when to stop, what is averaged, and when it is put aside.

#include "md/dynamics/dynamics.hpp"
#include "md/minimise/relaxation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::md {

struct DynamicsRun {
  DynamicsSettings dynamics;
  double duration = 0.0;  ///< [s], of at least one time step
  double tolerance = 0.0; ///< as RelaxationSettings; at T = 0 the run ends
                          ///< when it is reached
  std::filesystem::path checkpoint; ///< empty: none is written or looked for
  int checkpoint_interval = 1000;   ///< steps, >= 1
  std::string label; ///< what else defines the run: another label, no resume
};

/// Averages over samples of the second half of a hot run.
struct TimeAverage {
  int samples = 0;                   ///< 0 for a run without temperature
  std::vector<double> state;         ///< mean positions [m]
  std::vector<double> normal_forces; ///< mean, of the lowest layer [N]
  double interface_energy = 0.0;     ///< mean [J]
  double force_spread = 0.0;  ///< standard deviation in time of the mean normal
                              ///< force an atom [N]
  double height_spread = 0.0; ///< of the layer's mean height [m]
};

struct DynamicsOutcome {
  Relaxation relaxation; ///< evaluations are steps; at T > 0 converged means
                         ///< that the whole duration was run
  TimeAverage average;
};

/// Moves `state` from rest (at T > 0 from velocities of that temperature) and
/// overwrites it with the last state. Looks first for a checkpoint of the same
/// system, load, settings and label, wherever that began, and goes on from it;
/// interrupted and taken up again is the
/// uninterrupted run, bit for bit. A run that reaches its end removes the
/// checkpoint; one that `watch` ends leaves it at that step.
/// @throws std::domain_error  as Dynamics; T = 0 without damping; a duration
///                            under one time step
DynamicsOutcome run_dynamics(const InertialSystem& system, const Load& load,
                             std::vector<double>& state, const DynamicsRun& run,
                             const Watch& watch = {});

} // namespace asperity::md
