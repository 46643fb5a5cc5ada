#include "contact/solvers/iteration.hpp"

#include "base/ranks/node_sums.hpp"
#include "contact/solvers/active_set.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "contact/solvers/preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

// A tour: iterated() below is the loop. ContactState holds the fields p, C p -
// h and the residual r and finds the active nodes (contact_state.hpp); it
// begins with the checks of starting_pressure.hpp. Directions, here, is one
// step of preconditioned conjugate gradients. Its preconditioner
// (preconditioner.hpp) continues r across the edge of the contact by the
// extension E (boundary_extension.hpp) and applies the inverse of the operator
// (operators/surface_operator.hpp). The loops over nodes are in
// node_kernels.hpp. hand_over() passes a problem that stalls to active_set.hpp
// and polonsky_keer.hpp, which have the same state with directions in double
// precision.

namespace asperity::contact {
namespace {

/// The residual must halve within this number of iterations, otherwise the
/// active-set method takes over. Only plates thinner than length/20 with a
/// traction-free far boundary, whose compliance falls like q^-4, have been
/// observed to need more than 60.
constexpr int stagnation_iterations = 150;

/// An error this many times the smallest one diverges. It must not grow until
/// single precision overflows, at a size that depends on the units.
constexpr double divergence = 0x1p30;

/// Stagnation criterion: tells when an error has stopped falling.
class StagnationCriterion {
public:
  bool is_stalled(double error, int iteration) {
    if (error <= 0.5 * best_ || iteration == 0) {
      best_ = error;
      since_ = iteration;
    }
    return iteration - since_ > stagnation_iterations ||
           error > divergence * best_;
  }

private:
  double best_ = 0.0;
  int since_ = 0;
};

/// The search directions of preconditioned conjugate gradients.
class Directions {
public:
  explicit Directions(const ContactState& state)
      : preconditioner_(state.elasticity),
        direction_(state.pressure.size()),
        written_(state.active.size(), 0) {}

  /// Makes one iteration. Returns false if there is no descent direction.
  bool step(ContactState& state) {
    // z = E^T (C + c)^-1 E r
    precondition(state);
    if (!state.by_pressure())
      correct_load(state);
    // d = z + beta d,  slope = <r, d>
    const double slope = conjugate(state);
    if (!(slope > 0.0 && std::isfinite(slope)))
      return false;

    // C d,  curvature = <d, (C + c) d>
    state.displace(direction_);
    const double curvature = energy(state);
    if (!(curvature > 0.0 && std::isfinite(curvature)))
      return false;

    // p = max(0, p - slope / curvature d)
    state.advance(static_cast<float>(slope / curvature), direction_);
    return true;
  }

private:
  /// z = E^T (C + c)^-1 E r on the active nodes.
  void precondition(ContactState& state) {
    const double c = state.problem.local_compliance;
    const BoundaryExtension::Active active{state.freedom, state.active};
    if (state.freed != freed_at_build_) {
      preconditioner_.build(state.elasticity, c, active);
      freed_at_build_ = state.freed;
    }
    preconditioner_.apply(state.elasticity, c, active, state.residual,
                          state.work());
    ++state.transforms;
  }

  /// Under gap control the load is unknown, and near full contact a uniform
  /// pressure changes the energy very little. The mean of z is then replaced by
  /// the exact minimiser along it, <1, r> / <1, (C + c) 1> over the active
  /// nodes. If few nodes are active, this would only cost a transform and is
  /// omitted.
  void correct_load(ContactState& state) {
    const std::span<float> z = state.change();
    const std::size_t nodes = z.size();
    const double n_free = state.free_weight;
    if (n_free < 0.5 * static_cast<double>(state.workers.all_nodes(nodes)))
      return;
    std::vector<float> uniform(nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      uniform[i] = state.freedom[i] > fixed ? 1.0F : 0.0F;
    state.elasticity.displacement_change(uniform, state.compliance_direction());
    ++state.transforms;
    const double c = state.problem.local_compliance;
    const auto sum = [&](std::span<const float> field) {
      return weighted_sum(
          state.elasticity.nodal_weights(), nodes, state.workers,
          [u = uniform.data(), f = field.data()](std::size_t i) {
            return static_cast<double>(u[i]) * static_cast<double>(f[i]);
          });
    };
    const double softness = sum(state.compliance_direction()) + c * n_free;
    // In full hard contact the curvature vanishes.
    if (softness <= 1e-6 * n_free * state.elasticity.short_wave_compliance())
      return;
    const double shift = sum(state.residual) / softness - sum(z) / n_free;
    for (std::size_t i = 0; i < nodes; ++i)
      z[i] += static_cast<float>(shift) * uniform[i];
  }

  /// direction = z + beta direction, Polak-Ribiere with beta >= 0; returns the
  /// slope r . direction.
  double conjugate(ContactState& state) {
    clear_inactive(state.active, written_, std::span(direction_));
    NodeFields all = state.fields();
    all.preconditioned = state.change().data();
    all.direction = direction_.data();
    // Subtracting the mean of z over the active nodes preserves the load.
    float mean = 0.0F;
    if (state.by_pressure())
      mean = static_cast<float>(state
                                    .sum<Sum>([&](const NodeRange& range) {
                                      return sum_free(all, range);
                                    })
                                    .value /
                                state.free_weight);
    const auto [now, change] = state
                                   .sum<TwoSums>([&](const NodeRange& range) {
                                     return sum_slopes(all, range, mean);
                                   })
                                   .values;
    const float beta = before_ > 0.0
                           ? static_cast<float>(std::max(0.0, change / before_))
                           : 0.0F;
    before_ = now;
    const Sum slope = state.sum<Sum>([&](const NodeRange& range) {
      return conjugate_nodes(all, range, mean, beta);
    });
    if (slope.value > 0.0)
      return slope.value;
    for (std::size_t i = 0; i < direction_.size(); ++i) // restart
      direction_[i] = allowed(state.change()[i] - mean, state.freedom[i]);
    return now;
  }

  /// d . (C + c) d
  double energy(ContactState& state) {
    NodeFields all = state.fields();
    all.direction = direction_.data();
    all.displaced = state.compliance_direction().data();
    return state
        .sum<Sum>(
            [&](const NodeRange& range) { return sum_energy(all, range); })
        .value;
  }

  Preconditioner preconditioner_;
  double freed_at_build_ = 0.0; ///< 0: not built
  std::vector<float> direction_;
  BlockFlags written_; ///< blocks where the direction may differ from 0
  double before_ = 0.0;
};

/// Passes a problem that stalls to the active set, to the unpreconditioned
/// method, and to the active set from a uniform pressure, until one converges.
/// The active set has no third kind of node, and its system is not divided
/// among ranks: with a hardness and on ranks the second method is the only one.
ContactSolution hand_over(ContactState&& state) {
  const bool has_set =
      !state.problem.has_hardness() && state.workers.ranks() == nullptr;
  ContactProblem rest = state.problem;
  rest.max_iterations = std::max(1, rest.max_iterations - state.iterations);
  std::string note =
      "stalled after " + std::to_string(state.iterations) + " iterations; ";
  int iterations = state.iterations, transforms = state.transforms;
  const auto counted = [&](ContactSolution answer) {
    iterations += answer.iterations;
    transforms += answer.transforms;
    rest.max_iterations =
        std::max(1, state.problem.max_iterations - iterations);
    return answer;
  };
  const auto add = [&](const char* method, const std::string& own) {
    note += method;
    note += own.empty() ? "" : ": " + own;
  };
  ContactSolution answer;
  if (has_set) {
    answer = counted(active_set(state.elasticity, state.problem, state.target,
                                state.pressure));
    add("finished by the active-set method", answer.note);
  }
  if (!answer.converged) {
    const bool goes_on = has_set && std::isfinite(answer.gap_error);
    answer = counted(polonsky_keer(state.elasticity, rest, state.target,
                                   goes_on ? answer.pressure : state.pressure));
    add(has_set ? "; then by the unpreconditioned method"
                : "finished by the unpreconditioned method",
        answer.note);
  }
  if (!answer.converged && has_set) {
    ContactSolution fresh =
        counted(active_set(state.elasticity, state.problem, state.target, {}));
    add("; then by the active-set method from a uniform pressure", "");
    if (fresh.converged)
      answer = std::move(fresh);
  }
  answer.iterations = iterations;
  answer.transforms = transforms;
  answer.note = std::move(note);
  return answer;
}

} // namespace

ContactSolution iterated(ContactState&& state) {
  if (state.is_at_end()) // without memory for directions
    return std::move(state).solution();
  Directions directions(state);
  StagnationCriterion watch;
  while (!state.is_at_end()) {
    if (watch.is_stalled(state.gap_error, state.iterations) ||
        !directions.step(state))
      return hand_over(std::move(state));
    ++state.iterations;
    state.update_residual();
  }
  return std::move(state).solution();
}

} // namespace asperity::contact
