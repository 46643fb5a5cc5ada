#include "contact/solver.hpp"

#include "contact/projected_state.hpp"

#include <algorithm>
#include <utility>

namespace asperity::contact {
namespace {

/// The residual must halve within so many iterations, or the plain method
/// takes over. Only plates with a free back thinner than length/20, whose
/// compliance falls like q^-4, have been seen to need more than 60.
constexpr int patience = 150;

/// Says when an error has stopped falling.
class StallWatch {
public:
  bool is_stalled(double error, int iteration) {
    if (error <= 0.5 * best_ || iteration == 0) {
      best_ = error;
      since_ = iteration;
    }
    return iteration - since_ > patience;
  }

private:
  double best_ = 0.0;
  int since_ = 0;
};

/// The search directions of preconditioned conjugate gradients.
class Directions {
public:
  explicit Directions(std::size_t nodes)
      : preconditioned_(nodes),
        previous_residual_(nodes),
        direction_(nodes),
        compliance_direction_(nodes),
        uniform_(nodes) {}

  /// One iteration. False if there is no way down from here.
  bool step(ProjectedState& state) {
    state.elasticity.pressure_estimate(
        state.residual, state.problem.local_compliance, preconditioned_);
    state.mask(preconditioned_);
    if (state.target.kind == LoadTarget::Kind::mean_gap)
      correct_load(state);
    const double slope = conjugate(state);
    if (!(slope > 0.0))
      return false;

    state.elasticity.displacement(direction_, compliance_direction_);
    state.transforms += 2;
    const double curvature =
        state.dot(direction_, compliance_direction_) +
        state.problem.local_compliance * state.dot(direction_, direction_);
    if (!(curvature > 0.0))
      return false;

    previous_residual_ = state.residual;
    state.advance(slope / curvature, direction_, compliance_direction_);
    return true;
  }

private:
  /// Under gap control the load itself is unknown, and near full contact a
  /// uniform pressure costs next to nothing. There the mean of z is replaced
  /// by the exact minimum along it, <1, r> / <1, (C + c) 1> over the free
  /// nodes. With few of them free it only costs a transform.
  void correct_load(ProjectedState& state) {
    for (std::size_t i = 0; i < uniform_.size(); ++i)
      uniform_[i] = state.is_free[i] ? 1.0 : 0.0;
    const double n_free = state.dot(uniform_, uniform_);
    if (n_free < 0.5 * static_cast<double>(uniform_.size()))
      return;
    state.elasticity.displacement(uniform_, compliance_direction_);
    ++state.transforms;
    const double softness = state.dot(uniform_, compliance_direction_) +
                            state.problem.local_compliance * n_free;
    // In full contact against a hard wall there is no curvature at all.
    if (softness <= 1e-9 * n_free * state.elasticity.short_wave_compliance())
      return;
    const double shift = state.dot(uniform_, state.residual) / softness -
                         state.dot(uniform_, preconditioned_) / n_free;
    for (std::size_t i = 0; i < uniform_.size(); ++i)
      preconditioned_[i] += shift * uniform_[i];
  }

  /// direction = z + beta direction, Polak-Ribiere with beta >= 0; returns
  /// the slope r . direction.
  double conjugate(const ProjectedState& state) {
    const double now = state.dot(state.residual, preconditioned_);
    const double change = now - state.dot(previous_residual_, preconditioned_);
    const double beta = before_ > 0.0 ? std::max(0.0, change / before_) : 0.0;
    before_ = now;
    for (std::size_t i = 0; i < direction_.size(); ++i) {
      direction_[i] =
          state.is_free[i] ? preconditioned_[i] + beta * direction_[i] : 0.0;
      if (state.pressure[i] == 0.0 && direction_[i] > 0.0)
        direction_[i] = 0.0;
    }
    const double slope = state.dot(state.residual, direction_);
    if (slope > 0.0)
      return slope;
    direction_ = preconditioned_; // not downhill: start afresh
    return now;
  }

  std::vector<double> preconditioned_;
  std::vector<double> previous_residual_;
  std::vector<double> direction_;
  std::vector<double> compliance_direction_;
  std::vector<double> uniform_;
  double before_ = 0.0;
};

ContactSolution hand_over(ProjectedState&& state) {
  ContactProblem rest = state.problem;
  const int done = state.iterations;
  const int transforms = state.transforms;
  rest.max_iterations = std::max(1, rest.max_iterations - done);
  ContactSolution answer =
      polonsky_keer(state.elasticity, rest, state.target, state.pressure);
  answer.iterations += done;
  answer.transforms += transforms;
  answer.note = "stalled after " + std::to_string(done) +
                " iterations; finished by the plain method" +
                (answer.note.empty() ? "" : ": " + answer.note);
  return answer;
}

} // namespace

ContactSolution solve_contact(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const LoadTarget& target,
                              std::span<const double> initial_pressure) {
  ProjectedState state(elasticity, problem, target, initial_pressure);
  Directions directions(state.pressure.size());
  StallWatch watch;
  for (;; ++state.iterations) {
    state.update_residual();
    if (state.is_at_end())
      return std::move(state).solution();
    if (watch.is_stalled(state.gap_error, state.iterations) ||
        !directions.step(state))
      return hand_over(std::move(state));
  }
}

} // namespace asperity::contact
