#include "md/relaxation.hpp"

#include "base/maximum.hpp"
#include "base/require.hpp"
#include "md/curvature_memory.hpp"
#include "md/vector_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::md {
namespace {

/// A step is taken when the slope behind it, uphill, is at most this share of
/// the slope before it: far from an exact search, which costs evaluations.
constexpr double overshoot = 0.9;

/// Energies nearer than this, relative, are one: sums over all atoms.
constexpr double energy_rounding = 1e-10;

constexpr int shortenings = 20; ///< of one step before the memory is dropped

class Descent {
public:
  Descent(const System& system, std::vector<double>& state,
          const RelaxationSettings& settings)
      : system_(system),
        settings_(settings),
        state_(state),
        forces_(state.size()),
        trial_(state.size()),
        trial_forces_(state.size()),
        direction_(state.size()),
        memory_(state.size(), settings.memory) {
    evaluation_ = evaluate(state_, forces_);
  }

  Relaxation report() const {
    Relaxation report;
    report.evaluations = evaluations_;
    report.energy = evaluation_.energy;
    report.residual = residual_of(evaluation_, forces_);
    report.largest_residual =
        largest_magnitude(forces_) / evaluation_.contact_force;
    return report;
  }

  /// One step down. False if there is none.
  bool step() {
    if (downhill() && search())
      return true;
    if (memory_.size() == 0 || evaluations_ >= settings_.max_evaluations)
      return false;
    memory_.clear(); // what it taught no longer holds here
    return downhill() && search();
  }

private:
  Evaluation evaluate(const std::vector<double>& state,
                      std::vector<double>& forces) {
    ++evaluations_;
    return system_.energy_and_forces(state, forces);
  }

  /// direction = H forces; slope_ is the energy's fall along it.
  bool downhill() {
    memory_.remaining(forces_, trial_);
    system_.precondition(trial_, settings_.contact_stiffness, direction_);
    memory_.complete(direction_);
    slope_ = dot(forces_, direction_);
    return slope_ > 0.0 && std::isfinite(slope_);
  }

  /// Where energies can be told apart they decide; nearer, the slopes.
  bool is_lower(const Evaluation& after, double slope) const {
    const double rounding = energy_rounding * std::abs(evaluation_.energy);
    return after.energy < evaluation_.energy - rounding ||
           (after.energy <= evaluation_.energy + rounding && slope < slope_);
  }

  bool search() {
    double length =
        std::min(1.0, settings_.largest_step / largest_magnitude(direction_));
    for (int i = 0; i < shortenings; ++i) {
      for (std::size_t k = 0; k < state_.size(); ++k)
        trial_[k] = state_[k] + length * direction_[k];
      const Evaluation after = evaluate(trial_, trial_forces_);
      const double slope = dot(trial_forces_, direction_);
      if (slope >= -overshoot * slope_ && is_lower(after, slope)) {
        memory_.learn(direction_, length, forces_, trial_forces_);
        state_.swap(trial_);
        forces_.swap(trial_forces_);
        evaluation_ = after;
        return true;
      }
      // Where a straight line through both slopes is zero.
      const double zero = slope_ / (slope_ - slope);
      length *= zero > 0.1 ? std::min(zero, 0.7) : 0.1;
      if (evaluations_ >= settings_.max_evaluations)
        return false;
    }
    return false;
  }

  const System& system_;
  const RelaxationSettings& settings_;
  std::vector<double>& state_;
  std::vector<double> forces_;
  std::vector<double> trial_;
  std::vector<double> trial_forces_;
  std::vector<double> direction_;
  CurvatureMemory memory_;
  Evaluation evaluation_;
  double slope_ = 0.0;
  int evaluations_ = 0;
};

} // namespace

double residual_of(const Evaluation& evaluation,
                   std::span<const double> forces) {
  if (!(evaluation.contact_force > 0.0))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(dot(forces, forces) / static_cast<double>(forces.size())) /
         evaluation.contact_force;
}

Relaxation relax(const System& system, std::vector<double>& state,
                 const RelaxationSettings& settings, const Watch& watch) {
  require_positive("tolerance", settings.tolerance, "1");
  require_positive("largest_step", settings.largest_step, "m");
  require_positive("contact_stiffness", settings.contact_stiffness, "N/m");
  if (state.size() != system.size())
    refuse_argument("state.size()", static_cast<double>(state.size()),
                    "the system's own");

  Descent descent(system, state, settings);
  for (;;) {
    Relaxation now = descent.report();
    now.converged = now.residual <= settings.tolerance;
    if (now.converged)
      return now;
    if (!std::isfinite(now.energy))
      now.note = "the energy is not finite at the start";
    else if (now.evaluations >= settings.max_evaluations)
      now.note = fmt::format("no balance after {} evaluations: residual "
                             "{:.2g}, {:.2g} asked",
                             now.evaluations, now.residual, settings.tolerance);
    else if (watch && !watch({now.evaluations, now.energy, now.residual}))
      now.note = "stopped from outside";
    else if (!descent.step() &&
             descent.report().evaluations < settings.max_evaluations)
      now.note = fmt::format("no way down at residual {:.2g}, {:.2g} asked",
                             now.residual, settings.tolerance);
    if (!now.note.empty())
      return now;
  }
}

} // namespace asperity::md
