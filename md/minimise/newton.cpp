#include "md/minimise/newton.hpp"

#include "base/field_sums.hpp"
#include "md/minimise/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

constexpr double first_softness = 0.5;  ///< limit in the first step
constexpr double least_softness = 0.05; ///< 0 is used below this value
constexpr double most_softness = 64.0;  ///< never attained by an atomic
                                        ///< interface
constexpr double softening = 1.2;       ///< factor of the limit after an
                                        ///< accepted step
constexpr double stiffening = 0.6;      ///< and after a rejected one
constexpr int most_products = 80;       ///< per step
constexpr int soft_shortenings = 2;     ///< per step before H is stiffened
constexpr int last_shortenings = 20;    ///< if H cannot be stiffened further

class Newton {
public:
  Newton(CurvedSystem& system, std::vector<double>& state,
         const RelaxationSettings& settings)
      : system_(system),
        settings_(settings),
        state_(state),
        search_(system, state, settings),
        step_(state.size()),
        rest_(state.size()),
        scaled_(state.size()),
        direction_(state.size()),
        product_(state.size()) {}

  Relaxation report() const {
    Relaxation report = search_.report();
    report.linearisations = linearisations_;
    report.products = products_;
    return report;
  }

  /// Performs one step and returns whether an acceptable one was found.
  bool step() {
    system_.linearise(state_);
    ++linearisations_;
    for (;;) {
      system_.limit_negative_curvature(softness_);
      if (solve() && search()) {
        softness_ =
            std::clamp(softening * softness_, least_softness, most_softness);
        return true;
      }
      if (softness_ == 0.0 || is_budget_exhausted())
        return false;
      softness_ = softness_ > least_softness ? stiffening * softness_ : 0.0;
    }
  }

  bool is_budget_exhausted() const { return search_.is_budget_exhausted(); }

private:
  /// Returns the relative tolerance of the linear solution (the forcing term):
  /// 0.1 far from equilibrium, smaller near it, and never far below the
  /// requested tolerance.
  double share_left() const {
    const double residual = search_.residual();
    return std::max(std::min(0.1, std::sqrt(residual)),
                    0.3 * settings_.tolerance / residual);
  }

  /// Computes step_ = (K + H)^-1 forces by conjugate gradients. Returns false
  /// if negative curvature is encountered.
  bool solve() {
    const double asked = share_left();
    std::ranges::fill(step_, 0.0);
    rest_ = search_.forces();
    system_.precondition_curved(rest_, scaled_);
    direction_ = scaled_;
    double norm = dot(rest_, scaled_);
    const double first = norm;
    for (int i = 0; i < most_products; ++i) {
      system_.curvature_times(direction_, product_);
      ++products_;
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

  bool search() {
    system_.shorten(step_, settings_.largest_step);
    const int trials = softness_ > 0.0 ? soft_shortenings : last_shortenings;
    return search_.search(step_, trials) > 0.0;
  }

  CurvedSystem& system_;
  const RelaxationSettings& settings_;
  std::vector<double>& state_;
  LineSearch search_;
  std::vector<double> step_;
  std::vector<double> rest_;      ///< linear residual
  std::vector<double> scaled_;    ///< P times the linear residual
  std::vector<double> direction_; ///< search direction
  std::vector<double> product_;   ///< (K + H) direction
  int linearisations_ = 0;
  int products_ = 0;
  double softness_ = first_softness;
};

/// Continues with L-BFGS from the last Newton iterate and accumulates the
/// counts of both methods.
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
  require_minimisable(system, state, settings);

  Newton newton(system, state, settings);
  for (;;) {
    Relaxation now = newton.report();
    now.converged = now.residual <= settings.tolerance;
    if (now.converged)
      return now;
    now.note = stop_reason(now, settings, watch);
    if (now.note.empty() && !newton.step() && !newton.is_budget_exhausted())
      return taken_over(system, state, settings, watch, newton.report());
    if (!now.note.empty())
      return now;
  }
}

} // namespace asperity::md
