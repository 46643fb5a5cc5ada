#include "contact/solvers/active_set.hpp"

#include "base/maximum.hpp"
#include "base/ranks/node_sums.hpp"
#include "contact/solvers/active_system.hpp"
#include "contact/solvers/contact_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
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
  std::vector<double> wave(elasticity.n_nodes());
  std::vector<double> answer(wave.size());
  const auto width = static_cast<std::size_t>(grid.points_x);
  for (std::size_t i = 0; i < wave.size(); ++i) {
    const int iy = static_cast<int>(i / width);
    wave[i] = std::cos(2.0 * std::numbers::pi *
                       (along_x ? static_cast<double>(i % width) / grid.points_x
                                : static_cast<double>(iy) / grid.points_y));
  }
  elasticity.displacement(wave, answer);
  return largest_size(answer, elasticity.workers());
}

class ActiveSet {
public:
  explicit ActiveSet(ContactState& state)
      : state_(state),
        weights_(state.elasticity.nodal_weights()),
        system_(state.elasticity, state.problem.local_compliance,
                state.by_pressure()),
        is_free_(state.freedom),
        residual_(state.pressure.size()),
        balanced_(state.pressure.size()),
        raw_gap_(state.pressure.size()) {}

  /// Makes one iteration. Returns an empty string, or why the iteration failed.
  std::string step() {
    free_.clear();
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i])
        free_.push_back(i);
    find_residual(state_.pressure, state_.raw_gap);
    std::string reason = system_.solve(
        free_, residual_, 0.1 * state_.problem.gap_tolerance, balanced_);
    if (!reason.empty())
      return reason;
    for (std::size_t i = 0; i < balanced_.size(); ++i)
      balanced_[i] += state_.pressure[i];
    state_.elasticity.displacement(balanced_, raw_gap_);
    ++state_.transforms;
    for (std::size_t i = 0; i < raw_gap_.size(); ++i)
      raw_gap_[i] -= state_.problem.heights[i];
    find_residual(balanced_, raw_gap_);
    if (!std::isfinite(largest_magnitude(residual_)))
      return "the equilibrium gap is not finite";
    exchange();
    for (double& pressure : balanced_)
      pressure = std::max(0.0, pressure);
    state_.set_pressure(balanced_);
    return {};
  }

  int transforms() const { return system_.transforms(); }

private:
  /// Finds gap + c p of all nodes. Under a prescribed load its mean over the
  /// active nodes is set to 0.
  void find_residual(std::span<const double> pressure,
                     std::span<const double> raw_gap) {
    for (std::size_t i = 0; i < residual_.size(); ++i)
      residual_[i] = raw_gap[i] +
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

  ContactState& state_;
  std::span<const double> weights_;
  ActiveSystem system_;
  std::vector<std::uint8_t> is_free_;
  std::vector<std::size_t> free_;
  std::vector<double> residual_;   ///< gap + c p [m]
  std::vector<double> balanced_;   ///< p with no residual on active nodes [Pa]
  std::vector<double> raw_gap_;    ///< C p - h of these
  std::vector<std::size_t> wrong_; ///< nodes in tension, or overlapping
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
  int tries_left_ = 0;
};

double gap_rounding(const ContactState& state, double long_wave) {
  const Workers workers = state.elasticity.workers();
  return rounding_of_a_field *
         (largest_size(state.problem.heights, workers) +
          std::abs(state.rigid_distance) +
          largest_size(state.pressure, workers) *
              (long_wave + state.problem.local_compliance));
}

} // namespace

ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const mechanics::LoadTarget& target,
                           std::span<const double> initial_pressure) {
  ContactState state(elasticity, problem, target,
                     {initial_pressure.begin(), initial_pressure.end()});
  const double long_wave = long_wave_compliance(elasticity);
  ++state.transforms;
  state.problem.max_iterations =
      std::min(problem.max_iterations, most_iterations);
  std::optional<ActiveSet> nodes;
  std::string reason;
  for (;; ++state.iterations) {
    state.update_residual();
    const double rounding = gap_rounding(state, long_wave);
    if (std::isfinite(rounding))
      state.problem.gap_tolerance = std::max(problem.gap_tolerance, rounding);
    if (state.is_at_end())
      break;
    if (!nodes)
      nodes.emplace(state);
    reason = nodes->step();
    if (!reason.empty())
      break;
  }
  if (nodes)
    state.transforms += nodes->transforms();
  ContactSolution answer = std::move(state).solution();
  if (answer.converged && answer.gap_error > problem.gap_tolerance)
    answer.note = "converged to the roundoff of the gap";
  if (!reason.empty())
    answer.note += ": " + reason;
  return answer;
}

} // namespace asperity::contact
