#include "fem/newton/spring_newton.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

namespace asperity::fem {
namespace {

/// Halvings of the interval in which the step length lies.
constexpr int halvings = 40;

/// The same where the material flows, and each takes a pass over the cells.
constexpr int halvings_in_flow = 10;

/// The excess of the mean gap over the prescribed one at a nominal pressure
/// [Pa], in m.
using Excess = std::function<double(double pressure)>;

struct ExcessAt {
  ExcessAt(const Excess& function, double at)
      : pressure(at), excess(function(at)) {}

  double pressure, excess;
};

/// Positive at the lower pressure, and not at the higher one.
struct Bracket {
  ExcessAt low, high;
};

/// Searches between three pressures, of which the middle has the smallest
/// excess, for one without an excess.
std::optional<Bracket> bracket_between(const Excess& function, ExcessAt low,
                                       ExcessAt middle, ExcessAt high) {
  constexpr int most_loads = 16;
  for (int i = 0; i < most_loads; ++i) {
    const bool is_above =
        high.pressure * low.pressure > middle.pressure * middle.pressure;
    ExcessAt& side = is_above ? high : low;
    const ExcessAt next(function, std::sqrt(middle.pressure * side.pressure));
    if (next.excess <= 0.0)
      return Bracket{is_above ? middle : low, next};
    if (next.excess < middle.excess) {
      (is_above ? low : high) = middle;
      middle = next;
    } else {
      side = next;
    }
  }
  return {};
}

/// Brackets the smallest pressure without an excess, beginning at a guess. The
/// mean gap first falls with the pressure. It may have a least value, beyond
/// which a heterogeneous block lifts more of the surface than it lowers.
std::optional<Bracket> first_bracket(const Excess& function, double guess) {
  constexpr double factor = 2.0;
  constexpr double most_factor = 1e6;
  constexpr double least_factor = 1e-12; // the guess may be far too high
  ExcessAt middle(function, guess);
  ExcessAt low(function, guess / factor);
  while ((low.excess <= 0.0 || low.excess < middle.excess) &&
         low.pressure > least_factor * guess) {
    middle = low;
    low = ExcessAt(function, low.pressure / factor);
  }
  if (low.excess <= 0.0)
    return {};
  if (middle.excess <= 0.0)
    return Bracket{low, middle};
  while (middle.pressure < most_factor * guess) {
    const ExcessAt high(function, factor * middle.pressure);
    if (high.excess <= 0.0)
      return Bracket{middle, high};
    if (high.excess >= middle.excess)
      return bracket_between(function, low, middle, high);
    low = middle;
    middle = high;
  }
  return {};
}

} // namespace

void SpringNewton::begin() {
  settled_ = state_.placement();
  has_linear_failure_ = false;
}

bool SpringNewton::solve(const mechanics::LoadTarget& load,
                         const BlockContact& contact, BlockSolution& answer) {
  return iterate(load, contact, answer, false);
}

void SpringNewton::return_to(const ContactState::Placement& placement,
                             double penalty) {
  state_.return_to(placement);
  state_.press_springs(penalty);
}

/// @param is_hard_to_find  full steps have not found the contact set
bool SpringNewton::iterate(const mechanics::LoadTarget& load,
                           const BlockContact& contact, BlockSolution& answer,
                           bool is_hard_to_find) {
  const bool is_load = load.control == mechanics::Control::nominal_pressure;
  const double penalty = contact.penalty;
  const ContactSet nothing(state_.pressure.size(), false);
  std::vector<double> springs(state_.pressure.size());
  ContactIteration iteration(contact.tolerance);
  if (is_hard_to_find)
    iteration.expect_cycles();
  state_.press_springs(penalty);
  while (answer.iterations < contact.max_iterations) {
    const bool is_cycling = iteration.is_cycling();
    if (is_cycling && !is_load) {
      iteration.take_full_steps();
      if (!approach_by_load(load.amount, contact, answer))
        return false;
    }
    const ContactSet before = contact_set(state_.pressure);
    ++answer.iterations;
    if (is_load && !is_any(before)) {
      state_.rigid_gap = state_.touching_gap(load.amount, penalty);
      state_.press_springs(penalty);
      continue;
    }
    for (std::size_t i = 0; i < springs.size(); ++i)
      springs[i] = before[i] ? penalty * state_.points()[i].area : 0.0;
    std::optional<ContactState::Placement> start;
    if (is_cycling && is_load)
      start = state_.placement();
    if (!step_.take(load, springs, nothing, iteration.accuracy_on_springs())) {
      if (!iteration.is_cycling()) { // a full step may lead anywhere
        return_to(settled_, penalty);
        iteration.expect_cycles();
        continue;
      }
      answer.note = step_.failure();
      has_linear_failure_ = true;
      return false;
    }
    if (start)
      shorten_step(*start, penalty);
    state_.press_springs(penalty);
    const int changed = n_changed(contact_set(state_.pressure), before);
    const double imbalance = state_.unbalanced();
    step_.tell(answer.iterations, imbalance, changed);
    if (iteration.has_ended(changed, imbalance, state_.is_flowing())) {
      settled_ = state_.placement();
      return true;
    }
  }
  answer.note = "the contact set did not converge";
  return false;
}

/// Sums a_c p_c dgap_c/dt [N m] over the points of all ranks, at the share t of
/// the step from `before` to the present state.
double SpringNewton::contact_work(const ContactState::Placement& before,
                                  double share, double penalty) const {
  double work = 0.0;
  for (std::size_t i = 0; i < state_.pressure.size(); ++i) {
    if (!state_.points()[i].is_opposed)
      continue;
    const double moved = state_.rigid_gap - before.rigid_gap +
                         state_.face_displacement[i] -
                         before.face_displacement[i];
    const double gap_there = state_.gap(i) - (1.0 - share) * moved;
    work += state_.points()[i].area *
            std::max(0.0, state_.multiplier[i] - penalty * gap_there) * moved;
  }
  return dealii::Utilities::MPI::sum(work, MPI_COMM_WORLD);
}

/// Shortens the step from `before` to the present state to the minimum of the
/// energy along it. At the far pressure P of the step and fixed multipliers,
/// the solution minimises
///
///     1/2 u K u + sum_c a_c p_c^2 / (2 k) + P (g u + A d),
///
/// which is convex, so that its derivative along the step increases and the
/// step of Newton's method descends. So is the energy with the work of plastic
/// flow during the load step in it.
void SpringNewton::shorten_step(const ContactState::Placement& before,
                                double penalty) {
  dealii::TrilinosWrappers::MPI::Vector step(state_.displacement);
  step -= before.displacement;
  const double far_work =
      state_.far_pressure *
      (state_.far_load() * step +
       state_.area() * (state_.rigid_gap - before.rigid_gap));
  const double start = before.elastic * step + far_work;
  const double increase = state_.elastic * step - before.elastic * step;
  const auto derivative = [&](double share) {
    const double total =
        state_.flow() != nullptr
            ? state_.stress_work(before, step, share) + far_work
            : start + share * increase;
    return total - contact_work(before, share, penalty);
  };
  if (derivative(0.0) >= 0.0 || derivative(1.0) <= 0.0)
    return;
  double low = 0.0;
  double high = 1.0;
  const int most = state_.flow() != nullptr ? halvings_in_flow : halvings;
  for (int i = 0; i < most; ++i) {
    const double middle = 0.5 * (low + high);
    (derivative(middle) > 0.0 ? high : low) = middle;
  }
  state_.displacement.sadd(high, 1.0 - high, before.displacement);
  state_.elastic.sadd(high, 1.0 - high, before.elastic);
  for (std::size_t i = 0; i < state_.face_displacement.size(); ++i)
    state_.face_displacement[i] += (1.0 - high) * (before.face_displacement[i] -
                                                   state_.face_displacement[i]);
  state_.rigid_gap += (1.0 - high) * (before.rigid_gap - state_.rigid_gap);
  if (state_.flow() != nullptr)
    state_.follow_displacement();
}

/// Finds the nominal pressure whose solution has the prescribed mean gap [m],
/// and that solution, from the last state that was a solution. Returns whether
/// it was found; if not, the note gives the reason.
bool SpringNewton::approach_by_load(double mean_gap_target,
                                    const BlockContact& contact,
                                    BlockSolution& answer) {
  constexpr int bits = 30; // of the pressure
  std::uintmax_t most_loads = 100;
  return_to(settled_, contact.penalty);
  const double present = state_.borne() / state_.area();
  const double guess = present > 0.0 ? present
                                     : state_.stiffness_scale() *
                                           std::max(std::abs(state_.mean_gap()),
                                                    std::abs(mean_gap_target));
  double least = std::numeric_limits<double>::infinity();
  bool has_failed = false;
  const Excess excess_at = [&](double pressure) {
    const mechanics::LoadTarget load{mechanics::Control::nominal_pressure,
                                     pressure};
    has_failed = has_failed || !iterate(load, contact, answer, true);
    least = std::min(least, state_.mean_gap());
    return has_failed ? 0.0 : state_.mean_gap() - mean_gap_target;
  };
  const std::optional<Bracket> found = first_bracket(excess_at, guess);
  if (has_failed)
    return false;
  if (!found) {
    answer.note = fmt::format(
        "no nominal pressure was found that closes the gap to {:.3g} m",
        mean_gap_target);
    if (least > mean_gap_target)
      answer.note += fmt::format("; its mean must be at least {:.3g} m", least);
    return false;
  }
  boost::math::tools::toms748_solve(
      excess_at, found->low.pressure, found->high.pressure, found->low.excess,
      found->high.excess, boost::math::tools::eps_tolerance<double>(bits),
      most_loads);
  return !has_failed;
}

} // namespace asperity::fem
