#pragma once

// Motion in time: velocity Verlet, and Langevin's thermostat split around it.
// Owns the state of a run and what one time step does to it.

#include "md/dynamics/inertial_system.hpp"

#include <cstdint>
#include <vector>

namespace asperity::md {

struct DynamicsSettings {
  double time_step = 0.0;   ///< h [s] > 0
  double damping = 0.0;     ///< rate gamma at which momenta fade [1/s] >= 0
  double temperature = 0.0; ///< T [K] >= 0
  std::uint64_t seed = 0;   ///< of the kicks
  int threads = 1;
};

/// All that a run in time is, between two steps.
struct Motion {
  std::int64_t step = 0;
  std::vector<double> state;      ///< of the system [m]
  std::vector<double> velocities; ///< [m/s]
};

/// The step BAOAB of B. Leimkuhler and C. Matthews, Appl. Math. Res. Express
/// 2013, 34: with kicks xi of draw_normal and c = exp(-gamma h),
///
///     B  v += F h / 2 m        A  x += v h / 2
///     O  v = c v + sqrt((1 - c^2) k_B T / m) xi
///     A  x += v h / 2          B  v += F h / 2 m
///
/// With gamma = 0 it is velocity Verlet; with T = 0 damped motion. In a
/// harmonic system of frequency w the positions have the canonical spread
/// exactly, the velocities (1 - w^2 h^2 / 4) times it.
class Dynamics {
public:
  /// @param motion  where to go on from; velocities may be empty: at rest
  /// @throws std::domain_error  a setting outside its range, wrong sizes
  Dynamics(const InertialSystem& system, const DynamicsSettings& settings,
           Motion motion);

  void step();

  const Motion& motion() const { return motion_; }

  const Evaluation& evaluation() const { return evaluation_; }

  const std::vector<double>& forces() const { return forces_; } ///< [N]

  double kinetic_energy() const; ///< [J]

private:
  void kick();
  void drift();
  void exchange_heat();

  const InertialSystem& system_;
  DynamicsSettings settings_;
  Motion motion_;
  std::vector<double> forces_;
  std::vector<double> noise_;
  Evaluation evaluation_;
};

/// Velocities of temperature T, held as the system holds them: draws number
/// -1 of the seed.
std::vector<double> thermal_velocities(const InertialSystem& system,
                                       const DynamicsSettings& settings);

} // namespace asperity::md
