#include "contact/active_set.hpp"

#include "contact/active_system.hpp"
#include "contact/problem_start.hpp"
#include "contact/projected_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace asperity::contact {
namespace {

/// Transforms and sums lose some ten eps of a field; the rest is a margin.
constexpr double rounding_of_a_field =
    64.0 * std::numeric_limits<double>::epsilon();

/// Shortest part of a Newton step that is tried with cutting.
constexpr double shortest_part = 1.0 / 64.0;

double largest(std::span<const double> field) {
  double most = 0.0;
  for (const double value : field)
    most = std::max(most, std::abs(value));
  return most;
}

/// C [m/Pa] of the longest wave along the longer side.
double long_wave_compliance(SurfaceOperator& elasticity) {
  const Grid& grid = elasticity.grid();
  const bool along_x = grid.length_x >= grid.length_y;
  std::vector<double> wave(grid.size());
  std::vector<double> answer(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      wave[grid.index(ix, iy)] =
          std::cos(2.0 * std::numbers::pi *
                   (along_x ? static_cast<double>(ix) / grid.points_x
                            : static_cast<double>(iy) / grid.points_y));
  elasticity.displacement(wave, answer);
  return largest(answer);
}

class ActiveSet {
public:
  explicit ActiveSet(ProjectedState& state)
      : state_(state),
        weights_(state.elasticity.nodal_weights()),
        system_(state.elasticity, state.problem.local_compliance,
                state.target.kind == LoadTarget::Kind::nominal_pressure),
        direction_(state.pressure.size()),
        change_(state.pressure.size()),
        compliance_change_(state.pressure.size()) {}

  /// One iteration. Empty, or the reason why there is none.
  std::string step() {
    choose_free_nodes();
    for (;;) {
      std::string reason = find_direction();
      if (!reason.empty())
        return reason;
      const double whole = feasible_part();
      if (whole >= 1.0 || !cut_step_falls(whole)) {
        if (whole == 0.0 && bar_entries())
          continue;
        take_part(std::min(1.0, whole));
      }
      apply_change();
      return {};
    }
  }

  int transforms() const { return system_.transforms(); }

private:
  double weight(std::size_t node) const {
    return weights_.empty() ? 1.0 : weights_[node];
  }

  void choose_free_nodes() {
    free_.clear();
    for (std::size_t i = 0; i < state_.pressure.size(); ++i)
      if (state_.is_free[i])
        free_.push_back(i);
  }

  /// The step to the minimum on the free nodes, or why there is none.
  std::string find_direction() {
    std::string reason = system_.solve(
        free_, state_.residual, 0.1 * state_.problem.gap_tolerance, direction_);
    // At the minimum <d, (C + c) d> = -<r, d>: E falls by half of it.
    fall_ = -0.5 * state_.dot(state_.residual, direction_);
    return reason;
  }

  /// How much of the step leaves all pressures >= 0.
  double feasible_part() const {
    double part = std::numeric_limits<double>::infinity();
    for (const std::size_t node : free_)
      if (direction_[node] < 0.0)
        part = std::min(part, state_.pressure[node] / -direction_[node]);
    return part;
  }

  /// Sets the change to a part of the step with pressures below 0 cut, the
  /// largest half of it that lowers E by no less than `whole` of it does.
  bool cut_step_falls(double whole) {
    const double least = (2.0 - whole) * whole * fall_;
    std::vector<double> pressure(state_.pressure.size());
    for (double part = 1.0; part >= std::max(whole, shortest_part);
         part *= 0.5) {
      for (std::size_t i = 0; i < pressure.size(); ++i)
        pressure[i] = std::max(0.0, state_.pressure[i] + part * direction_[i]);
      scale_to_target(state_.target, weights_, pressure);
      for (std::size_t i = 0; i < pressure.size(); ++i)
        change_[i] = pressure[i] - state_.pressure[i];
      const double fall = -energy_change();
      if (fall > 0.0 && fall >= least)
        return true;
    }
    return false;
  }

  /// E of the change, from residual and compliance at the present pressure.
  double energy_change() {
    state_.elasticity.displacement(change_, compliance_change_);
    ++state_.transforms;
    const double c = state_.problem.local_compliance;
    double sum = 0.0;
    for (std::size_t i = 0; i < change_.size(); ++i)
      sum +=
          weight(i) * change_[i] *
          (state_.residual[i] + 0.5 * (compliance_change_[i] + c * change_[i]));
    return sum;
  }

  /// Takes nodes that would enter with p < 0 from the free ones.
  bool bar_entries() {
    return std::erase_if(free_, [&](std::size_t node) {
             return state_.pressure[node] == 0.0 && direction_[node] < 0.0;
           }) > 0;
  }

  void take_part(double part) {
    for (std::size_t i = 0; i < change_.size(); ++i)
      change_[i] = part * direction_[i];
    if (part < 1.0) // the node that stops it leaves, whatever the rounding
      for (const std::size_t node : free_)
        if (direction_[node] < 0.0 &&
            state_.pressure[node] / -direction_[node] <= part)
          change_[node] = -state_.pressure[node];
  }

  void apply_change() {
    std::vector<double>& pressure = state_.pressure;
    for (std::size_t i = 0; i < pressure.size(); ++i)
      pressure[i] = std::max(0.0, pressure[i] + change_[i]);
    scale_to_target(state_.target, weights_, pressure);
    state_.elasticity.displacement(pressure, state_.displacement);
    ++state_.transforms;
  }

  ProjectedState& state_;
  std::span<const double> weights_;
  ActiveSystem system_;
  std::vector<std::size_t> free_;
  std::vector<double> direction_;
  std::vector<double> change_;
  std::vector<double> compliance_change_;
  double fall_ = 0.0; ///< of E over the whole step
};

double gap_rounding(const ProjectedState& state, double long_wave) {
  return rounding_of_a_field *
         (largest(state.problem.heights) + std::abs(state.rigid_distance) +
          largest(state.pressure) *
              (long_wave + state.problem.local_compliance));
}

} // namespace

ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const LoadTarget& target,
                           std::span<const double> initial_pressure) {
  ProjectedState state(elasticity, problem, target, initial_pressure);
  const double long_wave = long_wave_compliance(elasticity);
  ++state.transforms;
  ActiveSet nodes(state);
  std::string reason;
  for (;; ++state.iterations) {
    state.update_residual();
    state.problem.gap_tolerance =
        std::max(problem.gap_tolerance, gap_rounding(state, long_wave));
    if (state.is_at_end())
      break;
    reason = nodes.step();
    if (!reason.empty())
      break;
  }
  state.transforms += nodes.transforms();
  ContactSolution answer = std::move(state).solution();
  if (answer.converged && answer.gap_error > problem.gap_tolerance)
    answer.note = "to the rounding of a gap";
  if (!reason.empty())
    answer.note += ": " + reason;
  return answer;
}

} // namespace asperity::contact
