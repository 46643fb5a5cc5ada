#pragma once

// The solution of a load step by molecular dynamics: damped motion until
// equilibrium, or a time average at finite temperature. It defines the stopping
// criteria, the averages and the checkpoints.

#include "md/dynamics/dynamics.hpp"
#include "md/minimise/relaxation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::md {

struct DynamicsRun {
  DynamicsSettings dynamics;
  double duration = 0.0;  ///< [s], at least one time step
  double tolerance = 0.0; ///< as RelaxationSettings; at T = 0 the run ends when
                          ///< it is reached
  std::filesystem::path checkpoint; ///< empty: no checkpoints
  int checkpoint_interval = 1000;   ///< steps, >= 1
  std::string label; ///< everything else that defines the run; a checkpoint
                     ///< with another label is not used
};

/// Averages over samples from the second half of a run at T > 0.
struct TimeAverage {
  int samples = 0;                   ///< 0 for a run at T = 0
  std::vector<double> state;         ///< mean positions [m]
  std::vector<double> normal_forces; ///< mean, of the lowest layer [N]
  double interface_energy = 0.0;     ///< mean [J]
  double force_spread = 0.0;  ///< temporal standard deviation of the mean
                              ///< normal force per atom [N]
  double height_spread = 0.0; ///< same, of the mean height of the layer [m]
};

struct DynamicsOutcome {
  Relaxation relaxation; ///< evaluations counts steps; at T > 0, converged
                         ///< means that the whole duration was simulated
  TimeAverage average;
};

/// Integrates the motion of `state` from rest (at T > 0 with random velocities
/// of that temperature) and overwrites `state` with the last state. If there is
/// a checkpoint of the same system, load, settings and label, the run resumes
/// from it, whatever its initial state was. An interrupted and resumed run is
/// bitwise identical to an uninterrupted one. A completed run removes its
/// checkpoint; a run that `watch` stops writes a checkpoint at that step.
/// @throws std::domain_error  as Dynamics; or T = 0 without damping; or a
///                            duration shorter than one time step
DynamicsOutcome run_dynamics(const InertialSystem& system, const Load& load,
                             std::vector<double>& state, const DynamicsRun& run,
                             const Watch& watch = {});

} // namespace asperity::md
