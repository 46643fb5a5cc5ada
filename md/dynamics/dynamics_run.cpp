#include "md/dynamics/dynamics_run.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/require.hpp"
#include "md/dynamics/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace asperity::md {
namespace {

constexpr std::int64_t sampling_interval = 10; // steps
constexpr std::int64_t watch_interval = 10;

void add(std::span<double> sums, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    sums[i] += values[i];
}

/// Accumulates samples in one flat vector, in the form stored in checkpoints.
class Samples {
public:
  explicit Samples(const System& system)
      : system_(system),
        n_(system.layer().size()),
        sums_(n_scalars + n_ + system.size()) {}

  std::vector<double>& sums() { return sums_; }

  void take(std::span<const double> state) {
    std::vector<double> x(n_);
    std::vector<double> y(n_);
    std::vector<double> z(n_);
    const LayerView atoms = layer_of(system_, state);
    const double energy =
        system_.interface().energy_and_forces(atoms, {x, y, z});
    const double force = mean(z);
    const double height = mean(atoms.z);
    add(sums_,
        std::array{1.0, energy, force, force * force, height, height * height});
    add(std::span(sums_).subspan(n_scalars, n_), z);
    add(std::span(sums_).subspan(n_scalars + n_), state);
  }

  TimeAverage average() const {
    TimeAverage average;
    const double n_samples = sums_[0];
    average.samples = static_cast<int>(n_samples);
    if (average.samples == 0)
      return average;
    average.interface_energy = sums_[1] / n_samples;
    average.force_spread = spread(sums_[2], sums_[3], n_samples);
    average.height_spread = spread(sums_[4], sums_[5], n_samples);
    const auto begin = sums_.begin() + n_scalars;
    const auto states = begin + static_cast<std::ptrdiff_t>(n_);
    average.normal_forces.assign(begin, states);
    average.state.assign(states, sums_.end());
    for (double& force : average.normal_forces)
      force /= n_samples;
    for (double& value : average.state)
      value /= n_samples;
    return average;
  }

private:
  static constexpr std::ptrdiff_t n_scalars = 6;

  static double spread(double sum, double squares, double n) {
    return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
  }

  const System& system_;
  std::size_t n_;
  std::vector<double> sums_;
};

std::string fingerprint_of(const InertialSystem& system, const Load& load,
                           const DynamicsRun& run) {
  const DynamicsSettings& settings = run.dynamics;
  const std::array numbers = {load.amount,      settings.time_step,
                              settings.damping, settings.temperature,
                              run.duration,     run.tolerance};
  return fingerprint(fmt::format("{} {} {}", run.label, settings.seed,
                                 static_cast<int>(load.kind)),
                     {numbers, system.masses()});
}

std::int64_t steps_of(const DynamicsRun& run) {
  require_positive("time_step", run.dynamics.time_step, "s");
  require_between("duration", run.duration, run.dynamics.time_step, 1.0, "s");
  require_positive("checkpoint_interval", run.checkpoint_interval, "1");
  if (run.dynamics.temperature == 0.0)
    require_positive("damping", run.dynamics.damping, "1/s");
  return std::llround(run.duration / run.dynamics.time_step);
}

/// Controls one run from its start or checkpoint to its end.
class Run {
public:
  Run(const InertialSystem& system, const Load& load,
      const std::vector<double>& state, const DynamicsRun& settings)
      : system_(system),
        settings_(settings),
        n_steps_(steps_of(settings)),
        fingerprint_(fingerprint_of(system, load, settings)),
        samples_(system),
        dynamics_(system, settings.dynamics, beginning(state)) {}

  DynamicsOutcome finish(std::vector<double>& state, const Watch& watch) {
    DynamicsOutcome outcome;
    Relaxation& result = outcome.relaxation;
    for (;;) {
      report(result);
      if (has_ended(result))
        break;
      const std::int64_t step = dynamics_.motion().step;
      if (step % watch_interval == 0 && watch &&
          !watch({result.evaluations, result.energy, result.residual})) {
        result.note = "stopped";
        save();
        break;
      }
      if (step > 0 && step % settings_.checkpoint_interval == 0)
        save();
      dynamics_.step();
      sample();
    }
    state = dynamics_.motion().state;
    outcome.average = samples_.average();
    if (result.note != "stopped" && !settings_.checkpoint.empty())
      std::filesystem::remove(settings_.checkpoint);
    return outcome;
  }

private:
  bool is_hot() const { return settings_.dynamics.temperature > 0.0; }

  Motion beginning(const std::vector<double>& state) {
    if (!settings_.checkpoint.empty()) {
      std::optional<Checkpoint> found =
          read_checkpoint(settings_.checkpoint, fingerprint_, system_.size(),
                          samples_.sums().size());
      if (found) {
        samples_.sums() = std::move(found->sums);
        return std::move(found->motion);
      }
    }
    if (is_hot())
      return {0, state, thermal_velocities(system_, settings_.dynamics)};
    return {0, state, {}};
  }

  void sample() {
    const std::int64_t step = dynamics_.motion().step;
    if (is_hot() && 2 * step > n_steps_ &&
        (step % sampling_interval == 0 || step == n_steps_))
      samples_.take(dynamics_.motion().state);
  }

  void save() {
    if (!settings_.checkpoint.empty())
      write_checkpoint(settings_.checkpoint, fingerprint_,
                       {dynamics_.motion(), samples_.sums()});
  }

  void report(Relaxation& result) const {
    const Evaluation& evaluation = dynamics_.evaluation();
    result.evaluations = static_cast<int>(dynamics_.motion().step) + 1;
    result.energy = evaluation.energy;
    result.residual = residual_of(evaluation, dynamics_.forces());
  }

  bool has_ended(Relaxation& result) const {
    if (!std::isfinite(result.energy)) {
      result.note = "the energy is not finite: time_step is too large";
      return true;
    }
    const bool is_over = dynamics_.motion().step >= n_steps_;
    if (is_hot()) {
      result.converged = is_over;
      return is_over;
    }
    result.converged = result.residual <= settings_.tolerance;
    if (is_over && !result.converged)
      result.note = "not in equilibrium after `duration`";
    return is_over || result.converged;
  }

  const InertialSystem& system_;
  const DynamicsRun& settings_;
  std::int64_t n_steps_;
  std::string fingerprint_;
  Samples samples_;
  Dynamics dynamics_;
};

} // namespace

DynamicsOutcome run_dynamics(const InertialSystem& system, const Load& load,
                             std::vector<double>& state, const DynamicsRun& run,
                             const Watch& watch) {
  DynamicsOutcome outcome = Run(system, load, state, run).finish(state, watch);
  std::vector<double> forces(system.size());
  const Evaluation evaluation = system.energy_and_forces(state, forces);
  outcome.relaxation.largest_residual =
      largest_magnitude(forces) / evaluation.contact_force;
  return outcome;
}

} // namespace asperity::md
