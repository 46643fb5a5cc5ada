#include "md/dynamics/dynamics.hpp"

#include "base/physical_constants.hpp"
#include "base/require.hpp"
#include "md/dynamics/thermal_noise.hpp"

#include <cmath>
#include <utility>

namespace asperity::md {
namespace {

void require(const DynamicsSettings& settings) {
  require_positive("time_step", settings.time_step, "s");
  require_not_negative("damping", settings.damping, "1/s");
  require_not_negative("temperature", settings.temperature, "K");
}

void require_size(const char* name, std::size_t size, std::size_t expected) {
  if (size != expected)
    refuse_argument(name, static_cast<double>(size),
                    "the number of the system's unknowns");
}

} // namespace

Dynamics::Dynamics(const InertialSystem& system,
                   const DynamicsSettings& settings, Motion motion)
    : system_(system),
      settings_(settings),
      motion_(std::move(motion)),
      forces_(system.size()) {
  require(settings);
  if (motion_.velocities.empty())
    motion_.velocities.assign(system.size(), 0.0);
  require_size("size of the state", motion_.state.size(), system.size());
  require_size("size of the velocities", motion_.velocities.size(),
               system.size());
  evaluation_ = system_.energy_and_forces(motion_.state, forces_);
}

void Dynamics::kick() {
  const std::span<const double> masses = system_.masses();
  for (std::size_t i = 0; i < forces_.size(); ++i)
    motion_.velocities[i] += 0.5 * settings_.time_step * forces_[i] / masses[i];
}

void Dynamics::drift() {
  for (std::size_t i = 0; i < forces_.size(); ++i)
    motion_.state[i] += 0.5 * settings_.time_step * motion_.velocities[i];
}

void Dynamics::exchange_heat() {
  const double kept = std::exp(-settings_.damping * settings_.time_step);
  for (double& velocity : motion_.velocities)
    velocity *= kept;
  if (settings_.temperature == 0.0)
    return;

  const std::span<const double> masses = system_.masses();
  const double spread = (1.0 - kept * kept) * boltzmann *
                        settings_.temperature; // m <v^2> of the random impulses
  noise_.resize(forces_.size());
  draw_normal(settings_.seed, motion_.step, settings_.threads, noise_);
  for (std::size_t i = 0; i < noise_.size(); ++i)
    noise_[i] *= std::sqrt(spread / masses[i]);
  system_.hold(noise_);
  for (std::size_t i = 0; i < noise_.size(); ++i)
    motion_.velocities[i] += noise_[i];
}

void Dynamics::step() {
  kick();
  drift();
  if (settings_.damping > 0.0)
    exchange_heat();
  drift();
  evaluation_ = system_.energy_and_forces(motion_.state, forces_);
  kick();
  ++motion_.step;
}

double Dynamics::kinetic_energy() const {
  const std::span<const double> masses = system_.masses();
  double energy = 0.0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    energy += 0.5 * masses[i] * motion_.velocities[i] * motion_.velocities[i];
  return energy;
}

std::vector<double> thermal_velocities(const InertialSystem& system,
                                       const DynamicsSettings& settings) {
  require(settings);
  const std::span<const double> masses = system.masses();
  std::vector<double> velocities(system.size());
  draw_normal(settings.seed, -1, settings.threads, velocities);
  for (std::size_t i = 0; i < velocities.size(); ++i)
    velocities[i] *= std::sqrt(boltzmann * settings.temperature / masses[i]);
  system.hold(velocities);
  return velocities;
}

} // namespace asperity::md
