#include "contact/solvers/active_set.hpp"

#include "base/maximum.hpp"
#include "contact/solvers/active_system.hpp"
#include "contact/solvers/problem_start.hpp"
#include "contact/solvers/projected_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace asperity::contact {
namespace {

/// Transforms and sums lose about ten eps of a field; the rest is a safety
/// margin.
constexpr double rounding_of_a_field =
    64.0 * std::numeric_limits<double>::epsilon();

/// Number of iterations in which all wrong nodes are exchanged although their
/// number reaches no new minimum.
constexpr int tries_without_progress = 10;

/// About ten iterations have been observed; exchanging one node at a time could
/// need very many.
constexpr int most_iterations = 200;

/// C [m/Pa] of the longest wavelength along the longer side.
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
  return largest_magnitude(answer);
}

class ActiveSet {
public:
  explicit ActiveSet(ProjectedState& state)
      : state_(state),
        weights_(state.elasticity.nodal_weights()),
        system_(state.elasticity, state.problem.local_compliance,
                state.by_pressure()),
        is_free_(state.is_free),
        residual_(state.pressure.size()),
        balanced_(state.pressure.size()),
        displacement_(state.pressure.size()) {}

  /// Makes one iteration. Returns an empty string, or why the iteration failed.
  std::string step() {
    free_.clear();
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i])
        free_.push_back(i);
    find_residual(state_.pressure, state_.displacement);
    std::string reason = system_.solve(
        free_, residual_, 0.1 * state_.problem.gap_tolerance, balanced_);
    if (!reason.empty())
      return reason;
    for (std::size_t i = 0; i < balanced_.size(); ++i)
      balanced_[i] += state_.pressure[i];
    state_.elasticity.displacement(balanced_, displacement_);
    find_residual(balanced_, displacement_);
    if (!std::isfinite(largest_magnitude(residual_)))
      return "the equilibrium gap is not finite";
    exchange();
    for (std::size_t i = 0; i < balanced_.size(); ++i)
      state_.pressure[i] = std::max(0.0, balanced_[i]);
    scale_to_target(state_.target, weights_, state_.pressure);
    state_.elasticity.displacement(state_.pressure, state_.displacement);
    state_.transforms += 2;
    return {};
  }

  int transforms() const { return system_.transforms(); }

private:
  /// Finds gap + c p of all nodes. Under a prescribed load its mean over the
  /// active nodes is set to 0.
  void find_residual(std::span<const double> pressure,
                     std::span<const double> displacement) {
    for (std::size_t i = 0; i < residual_.size(); ++i)
      residual_[i] = displacement[i] - state_.problem.heights[i] +
                     state_.problem.local_compliance * pressure[i] +
                     state_.rigid_distance;
    if (!state_.by_pressure())
      return;
    double sum = 0.0;
    double total = 0.0;
    for (const std::size_t node : free_) {
      const double weight = weight_of(weights_, node);
      sum += weight * residual_[node];
      total += weight;
    }
    for (double& value : residual_)
      value -= sum / total;
  }

  /// Activates nodes that overlap and deactivates those with a tensile
  /// pressure: all of them while their number falls, otherwise the last one
  /// only.
  void exchange() {
    const double tolerance = 0.5 * state_.problem.gap_tolerance;
    const double softness = state_.elasticity.short_wave_compliance() +
                            state_.problem.local_compliance;
    wrong_.clear();
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i] ? softness * balanced_[i] < -tolerance
                      : residual_[i] < -tolerance)
        wrong_.push_back(i);
    if (wrong_.size() < fewest_) {
      fewest_ = wrong_.size();
      tries_left_ = tries_without_progress;
    } else if (tries_left_ > 0) {
      --tries_left_;
    } else if (!wrong_.empty()) {
      wrong_ = {wrong_.back()};
    }
    for (const std::size_t node : wrong_)
      is_free_[node] = is_free_[node] ? 0 : 1;
  }

  ProjectedState& state_;
  std::span<const double> weights_;
  ActiveSystem system_;
  std::vector<std::uint8_t> is_free_;
  std::vector<std::size_t> free_;
  std::vector<double> residual_; ///< gap + c p [m]
  std::vector<double> balanced_; ///< p with no residual on active nodes [Pa]
  std::vector<double> displacement_;
  std::vector<std::size_t> wrong_; ///< nodes in tension, or overlapping
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  int tries_left_ = 0;
};

double gap_rounding(const ProjectedState& state, double long_wave) {
  return rounding_of_a_field *
         (largest_magnitude(state.problem.heights) +
          std::abs(state.rigid_distance) +
          largest_magnitude(state.pressure) *
              (long_wave + state.problem.local_compliance));
}

} // namespace

ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const mechanics::LoadTarget& target,
                           std::span<const double> initial_pressure) {
  ProjectedState state(elasticity, problem, target, initial_pressure);
  const double long_wave = long_wave_compliance(elasticity);
  ++state.transforms;
  state.problem.max_iterations =
      std::min(problem.max_iterations, most_iterations);
  state.update_residual();
  ActiveSet nodes(state);
  std::string reason;
  for (;; ++state.iterations) {
    state.update_residual();
    const double rounding = gap_rounding(state, long_wave);
    if (std::isfinite(rounding))
      state.problem.gap_tolerance = std::max(problem.gap_tolerance, rounding);
    if (state.is_at_end())
      break;
    reason = nodes.step();
    if (!reason.empty())
      break;
  }
  state.transforms += nodes.transforms();
  ContactSolution answer = std::move(state).solution();
  if (answer.converged && answer.gap_error > problem.gap_tolerance)
    answer.note = "converged to the roundoff of the gap";
  if (!reason.empty())
    answer.note += ": " + reason;
  return answer;
}

} // namespace asperity::contact
