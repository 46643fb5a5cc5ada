#include "md/minimise/fire.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

// Constants of Bitzek et al. (2006), listed after their Eq. (1).
constexpr int fewest_steps_downhill = 5;
constexpr double growth = 1.1;
constexpr double shrinkage = 0.5;
constexpr double first_mixing = 0.1;
constexpr double mixing_decay = 0.99;
// The frequencies are near 1, and the integration is stable up to a step of 2.
constexpr double first_time_step = 0.1;
constexpr double largest_time_step = 1.0;

/// Computes values = keep * values + factor * other.
void mix(std::vector<double>& values, double keep,
         const std::vector<double>& other, double factor) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = keep * values[i] + factor * other[i];
}

class Fire {
public:
  Fire(const System& system, const RelaxationSettings& settings)
      : system_(system),
        settings_(settings),
        forces_(system.size()),
        pull_(system.size()),
        velocity_(system.size()),
        momentum_(system.size()) {}

  void evaluate(const std::vector<double>& state, Relaxation& result) {
    const Evaluation evaluation = system_.energy_and_forces(state, forces_);
    ++result.evaluations;
    result.energy = evaluation.energy;
    result.residual = residual_of(evaluation, forces_);
    result.largest_residual =
        largest_magnitude(forces_) / evaluation.contact_force;
  }

  /// Advances `state` by one step with the current forces.
  void step(std::vector<double>& state) {
    system_.precondition(forces_, settings_.contact_stiffness, pull_);
    const double power = dot(forces_, velocity_);
    if (power > 0.0) {
      if (++steps_downhill_ > fewest_steps_downhill) {
        time_step_ = std::min(growth * time_step_, largest_time_step);
        mixing_ *= mixing_decay;
      }
    } else if (length_ > 0.0) { // not at the first step
      mix(state, 1.0, velocity_, -0.5 * length_);
      std::ranges::fill(velocity_, 0.0);
      std::ranges::fill(momentum_, 0.0);
      steps_downhill_ = 0;
      time_step_ *= shrinkage;
      mixing_ = first_mixing;
    }

    mix(velocity_, 1.0, pull_, time_step_);
    mix(momentum_, 1.0, forces_, time_step_);
    const double speed = dot(momentum_, velocity_);
    const double strength = dot(forces_, pull_);
    if (power > 0.0 && strength > 0.0) {
      const double factor = mixing_ * std::sqrt(speed / strength);
      mix(velocity_, 1.0 - mixing_, pull_, factor);
      mix(momentum_, 1.0 - mixing_, forces_, factor);
    }
    const double fastest = largest_magnitude(velocity_);
    length_ = fastest > 0.0
                  ? std::min(time_step_, settings_.largest_step / fastest)
                  : 0.0;
    mix(state, 1.0, velocity_, length_);
  }

private:
  const System& system_;
  const RelaxationSettings& settings_;
  std::vector<double> forces_;
  std::vector<double> pull_; ///< P forces
  std::vector<double> velocity_;
  std::vector<double> momentum_; ///< P^-1 velocity
  int steps_downhill_ = 0;
  double time_step_ = first_time_step;
  double length_ = 0.0; ///< last step / velocity; 0 before the first step
  double mixing_ = first_mixing;
};

} // namespace

Relaxation relax_by_fire(const System& system, std::vector<double>& state,
                         const RelaxationSettings& settings,
                         const Watch& watch) {
  Fire fire(system, settings);
  Relaxation result;
  fire.evaluate(state, result);
  while (!(result.residual <= settings.tolerance)) {
    if (!std::isfinite(result.energy) || std::isnan(result.residual)) {
      result.note = "the energy or a force is not finite";
      return result;
    }
    if (result.evaluations >= settings.max_evaluations) {
      result.note = "max_evaluations reached";
      return result;
    }
    if (watch && !watch({result.evaluations, result.energy, result.residual})) {
      result.note = "stopped";
      return result;
    }
    fire.step(state);
    fire.evaluate(state, result);
  }
  result.converged = true;
  return result;
}

} // namespace asperity::md
