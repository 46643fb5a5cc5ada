#pragma once

// The time integrator: velocity Verlet combined with a Langevin thermostat by
// operator splitting. It defines the state of a run and one time step.

#include "md/dynamics/inertial_system.hpp"

#include <cstdint>
#include <vector>

namespace asperity::md {

struct DynamicsSettings {
  double time_step = 0.0;   ///< h [s] > 0
  double damping = 0.0;     ///< relaxation rate gamma of momenta [1/s] >= 0
  double temperature = 0.0; ///< T [K] >= 0
  std::uint64_t seed = 0;   ///< of the random forces
  int threads = 1;
};

/// State of a run between two time steps.
struct Motion {
  std::int64_t step = 0;
  std::vector<double> state;      ///< of the system [m]
  std::vector<double> velocities; ///< [m/s]
};

/// Integrates one step by the BAOAB scheme of B. Leimkuhler and C. Matthews,
/// Appl. Math. Res. Express 2013, 34. With normal random numbers xi from
/// draw_normal() and c = exp(-gamma h),
///
///     B  v += F h / 2 m        A  x += v h / 2
///     O  v = c v + sqrt((1 - c^2) k_B T / m) xi
///     A  x += v h / 2          B  v += F h / 2 m
///
/// With gamma = 0 the scheme is velocity Verlet; with T = 0 it is damped
/// motion. In a harmonic system of angular frequency w, the variance of the
/// positions is exactly canonical; that of the velocities is (1 - w^2 h^2 / 4)
/// times the canonical one.
class Dynamics {
public:
  /// @param motion  initial state; empty velocities mean a start from rest
  /// @throws std::domain_error  a setting is outside its range, or a size is
  ///                            wrong
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

/// Returns random velocities of temperature T that satisfy the constraints of
/// the system. They use step number -1 of the random stream.
std::vector<double> thermal_velocities(const InertialSystem& system,
                                       const DynamicsSettings& settings);

} // namespace asperity::md
