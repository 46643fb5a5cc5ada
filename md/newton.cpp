#include "md/newton.hpp"

#include "base/maximum.hpp"
#include "base/require.hpp"
#include "md/vector_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

/// As in relaxation.cpp: a slope uphill of this share is still taken, and
/// energies this near are one.
constexpr double overshoot = 0.9;
constexpr double energy_rounding = 1e-10;

constexpr double first_softness = 0.5;  ///< share the first step allows
constexpr double least_softness = 0.05; ///< below it none is allowed
constexpr double most_softness = 64.0;  ///< no interface of atoms gets there
constexpr double softening = 1.2;       ///< of the share after a good step
constexpr double stiffening = 0.6;      ///< and after a bad one
constexpr int most_products = 80;       ///< in one step
constexpr int shortenings = 2;          ///< of one step before H is stiffened
constexpr int last_shortenings = 20;    ///< where it cannot be

class Newton {
public:
  Newton(CurvedSystem& system, std::vector<double>& state,
         const RelaxationSettings& settings)
      : system_(system),
        settings_(settings),
        state_(state),
        forces_(state.size()),
        trial_(state.size()),
        trial_forces_(state.size()),
        step_(state.size()),
        rest_(state.size()),
        scaled_(state.size()),
        direction_(state.size()),
        product_(state.size()) {
    evaluation_ = evaluate(state_, forces_);
  }

  Relaxation report() const {
    Relaxation report = counted_;
    report.energy = evaluation_.energy;
    report.residual = residual_of(evaluation_, forces_);
    report.largest_residual =
        largest_magnitude(forces_) / evaluation_.contact_force;
    return report;
  }

  /// One step down. False if there is none.
  bool step() {
    system_.linearise(state_);
    ++counted_.linearisations;
    for (;;) {
      system_.limit_softness(softness_);
      if (solve() && search()) {
        softness_ =
            std::clamp(softening * softness_, least_softness, most_softness);
        return true;
      }
      if (softness_ == 0.0 || is_used_up())
        return false;
      softness_ = softness_ > least_softness ? stiffening * softness_ : 0.0;
    }
  }

  bool is_used_up() const {
    return counted_.evaluations >= settings_.max_evaluations;
  }

private:
  Evaluation evaluate(const std::vector<double>& state,
                      std::vector<double>& forces) {
    ++counted_.evaluations;
    return system_.energy_and_forces(state, forces);
  }

  /// The share of the forces that a step may leave: a tenth far away, less
  /// near the balance, never far below what is asked.
  double share_left() const {
    const double residual = residual_of(evaluation_, forces_);
    return std::max(std::min(0.1, std::sqrt(residual)),
                    0.3 * settings_.tolerance / residual);
  }

  /// step_ = (K + H)^-1 forces_ by conjugate gradients. False where they meet
  /// negative curvature.
  bool solve() {
    const double asked = share_left();
    std::ranges::fill(step_, 0.0);
    rest_ = forces_;
    system_.precondition_curved(rest_, scaled_);
    direction_ = scaled_;
    double norm = dot(rest_, scaled_);
    const double first = norm;
    for (int i = 0; i < most_products; ++i) {
      system_.curvature_times(direction_, product_);
      ++counted_.products;
      const double curvature = dot(direction_, product_);
      if (!(curvature > 0.0))
        return false;
      const double length = norm / curvature;
      for (std::size_t k = 0; k < step_.size(); ++k) {
        step_[k] += length * direction_[k];
        rest_[k] -= length * product_[k];
      }
      system_.precondition_curved(rest_, scaled_);
      const double before = norm;
      norm = dot(rest_, scaled_);
      if (norm <= asked * asked * first)
        break;
      for (std::size_t k = 0; k < step_.size(); ++k)
        direction_[k] = scaled_[k] + norm / before * direction_[k];
    }
    return true;
  }

  /// Where energies can be told apart they decide; nearer, the slopes.
  bool is_lower(const Evaluation& after, double slope, double before) const {
    const double rounding = energy_rounding * std::abs(evaluation_.energy);
    return after.energy < evaluation_.energy - rounding ||
           (after.energy <= evaluation_.energy + rounding && slope < before);
  }

  bool search() {
    system_.shorten(step_, settings_.largest_step);
    const double before = dot(forces_, step_);
    if (!(before > 0.0) || !std::isfinite(before))
      return false;
    double length =
        std::min(1.0, settings_.largest_step / largest_magnitude(step_));
    const int tries = softness_ > 0.0 ? shortenings : last_shortenings;
    for (int i = 0; i < tries && !is_used_up(); ++i) {
      for (std::size_t k = 0; k < state_.size(); ++k)
        trial_[k] = state_[k] + length * step_[k];
      const Evaluation after = evaluate(trial_, trial_forces_);
      const double slope = dot(trial_forces_, step_);
      if (slope >= -overshoot * before && is_lower(after, slope, before)) {
        state_.swap(trial_);
        forces_.swap(trial_forces_);
        evaluation_ = after;
        return true;
      }
      // Where a straight line through both slopes is zero.
      const double zero = before / (before - slope);
      length *= zero > 0.1 ? std::min(zero, 0.7) : 0.1;
    }
    return false;
  }

  CurvedSystem& system_;
  const RelaxationSettings& settings_;
  std::vector<double>& state_;
  std::vector<double> forces_;
  std::vector<double> trial_;
  std::vector<double> trial_forces_;
  std::vector<double> step_;
  std::vector<double> rest_;      ///< of the forces, not yet held by the step
  std::vector<double> scaled_;    ///< P rest
  std::vector<double> direction_; ///< of conjugate gradients
  std::vector<double> product_;   ///< (K + H) direction
  Evaluation evaluation_;
  Relaxation counted_;
  double softness_ = first_softness;
};

/// L-BFGS from where Newton's method ended, in one account.
Relaxation taken_over(const System& system, std::vector<double>& state,
                      RelaxationSettings settings, const Watch& watch,
                      const Relaxation& so_far) {
  settings.max_evaluations -= so_far.evaluations;
  Relaxation rest = relax(system, state, settings, watch);
  rest.evaluations += so_far.evaluations;
  rest.linearisations = so_far.linearisations;
  rest.products = so_far.products;
  return rest;
}

} // namespace

Relaxation relax_by_newton(CurvedSystem& system, std::vector<double>& state,
                           const RelaxationSettings& settings,
                           const Watch& watch) {
  require_positive("tolerance", settings.tolerance, "1");
  require_positive("largest_step", settings.largest_step, "m");
  if (state.size() != system.size())
    refuse_argument("state.size()", static_cast<double>(state.size()),
                    "the system's own");

  Newton newton(system, state, settings);
  for (;;) {
    Relaxation now = newton.report();
    now.converged = now.residual <= settings.tolerance;
    if (now.converged)
      return now;
    if (!std::isfinite(now.energy))
      now.note = "the energy is not finite at the start";
    else if (newton.is_used_up())
      now.note = fmt::format("no balance after {} evaluations: residual "
                             "{:.2g}, {:.2g} asked",
                             now.evaluations, now.residual, settings.tolerance);
    else if (watch && !watch({now.evaluations, now.energy, now.residual}))
      now.note = "stopped from outside";
    else if (!newton.step() && !newton.is_used_up())
      return taken_over(system, state, settings, watch, newton.report());
    if (!now.note.empty())
      return now;
  }
}

} // namespace asperity::md
