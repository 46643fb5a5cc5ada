#include "md/minimise/line_search.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

/// A step is accepted if the uphill slope at its end is at most this fraction
/// of the initial downhill slope. The search is deliberately inexact because
/// evaluations are expensive.
constexpr double overshoot = 0.9;

/// Relative difference below which two energies are considered equal, because
/// they are sums over all atoms.
constexpr double energy_rounding = 1e-10;

} // namespace

LineSearch::LineSearch(const System& system, std::vector<double>& state,
                       const RelaxationSettings& settings)
    : system_(system),
      settings_(settings),
      state_(state),
      forces_(state.size()),
      trial_(state.size()),
      trial_forces_(state.size()) {
  evaluation_ = evaluate(state_, forces_);
}

Evaluation LineSearch::evaluate(const std::vector<double>& state,
                                std::vector<double>& forces) {
  ++evaluations_;
  return system_.energy_and_forces(state, forces);
}

Relaxation LineSearch::report() const {
  Relaxation report;
  report.evaluations = evaluations_;
  report.energy = evaluation_.energy;
  report.residual = residual();
  report.largest_residual =
      largest_magnitude(forces_) / evaluation_.contact_force;
  return report;
}

/// Compares the energies, or the slopes if the energies differ only by
/// roundoff.
bool LineSearch::is_lower(const Evaluation& after, double slope_before,
                          double slope_after) const {
  const double rounding = energy_rounding * std::abs(evaluation_.energy);
  return after.energy < evaluation_.energy - rounding ||
         (after.energy <= evaluation_.energy + rounding &&
          slope_after < slope_before);
}

double LineSearch::search(const std::vector<double>& direction,
                          int most_trials) {
  const double before = dot(forces_, direction);
  if (!(before > 0.0) || !std::isfinite(before))
    return 0.0;
  double length =
      std::min(1.0, settings_.largest_step / largest_magnitude(direction));
  for (int i = 0; i < most_trials && !is_budget_exhausted(); ++i) {
    for (std::size_t k = 0; k < state_.size(); ++k)
      trial_[k] = state_[k] + length * direction[k];
    const Evaluation after = evaluate(trial_, trial_forces_);
    const double slope = dot(trial_forces_, direction);
    if (slope >= -overshoot * before && is_lower(after, before, slope)) {
      state_.swap(trial_);
      forces_.swap(trial_forces_);
      evaluation_ = after;
      return length;
    }
    // The next trial is based on the zero of the linear interpolation of both
    // slopes.
    const double zero = before / (before - slope);
    length *= zero > 0.1 ? std::min(zero, 0.7) : 0.1;
  }
  return 0.0;
}

std::string stop_reason(const Relaxation& now,
                        const RelaxationSettings& settings,
                        const Watch& watch) {
  if (!std::isfinite(now.energy))
    return "the energy is not finite at the start";
  if (now.evaluations >= settings.max_evaluations)
    return fmt::format(
        "not converged after {} evaluations: residual {}, tolerance {}",
        now.evaluations, number_text(now.residual, settings.tolerance, 2),
        number_text(settings.tolerance, now.residual, 2));
  if (watch && !watch({now.evaluations, now.energy, now.residual}))
    return "stopped by the caller";
  return "";
}

void require_minimisable(const System& system, std::span<const double> state,
                         const RelaxationSettings& settings) {
  require_positive("tolerance", settings.tolerance, "1");
  require_positive("largest_step", settings.largest_step, "m");
  if (state.size() != system.size())
    refuse_argument("state.size()", static_cast<double>(state.size()),
                    "the number of the system's unknowns");
}

} // namespace asperity::md
