#include "fem/newton/spring_newton.hpp"

#include "base/require.hpp"

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

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::min;

/// Bounds of the first working penalty in Newton's method, in shear moduli per
/// node spacing. With a softer one the multiplier needs many augmentations;
/// with a stiffer one the roundoff of the gap may no longer be small in the
/// pressure.
constexpr double softest_spring = 1e3;
constexpr double stiffest_spring = 1e5;

/// The working penalty grows by this factor if an augmentation has left more
/// than this share of the violation.
constexpr double stiffer = 10.0;
constexpr double slow = 0.25;

/// Share of the tolerance of forces that the roundoff of gaps may have in the
/// pressure of the working penalty.
constexpr double roundoff_share = 0.1;

} // namespace

/// Takes this share of the pressure, and of `more` [Pa] on top of it, as
/// multiplier.
void AugmentedLagrangian::keep_pressure(double share, double more) {
  for (std::size_t i = 0; i < state_.multiplier.size(); ++i)
    state_.multiplier[i] = share * (state_.pressure[i] + more);
}

/// The working penalty in Newton's method. A penalty within the bounds is used
/// itself; for hard contact the solution does not depend on the working
/// penalty.
double AugmentedLagrangian::first_penalty(const BlockContact& contact) const {
  const double low = mechanics::has_wall(contact.law)
                         ? softest_spring * state_.stiffness_scale()
                         : 0.0;
  return std::clamp(contact.penalty, low,
                    stiffest_spring * state_.stiffness_scale());
}

/// The working penalty [Pa/m] above which the roundoff of a gap in contact, the
/// difference of rigid gap, displacement and height, is no longer small in the
/// pressure.
double AugmentedLagrangian::stiffest_penalty(double tolerance) const {
  double length =
      std::max(std::abs(state_.rigid_gap), std::numeric_limits<double>::min());
  double highest = 0.0;
  for (std::size_t i = 0; i < state_.pressure.size(); ++i) {
    if (state_.pressure[i] <= 0.0)
      continue;
    length = std::max({length, std::abs(state_.face_displacement[i]),
                       std::abs(state_.heights[i])});
    highest = std::max(highest, state_.pressure[i]);
  }
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return roundoff_share * tolerance * max(highest, MPI_COMM_WORLD) /
         (epsilon * max(length, MPI_COMM_WORLD));
}

/// The next working penalty [Pa/m] if augmentations with the present one reduce
/// the violation slowly, because modes of the block are stiffer: a thin, nearly
/// incompressible coating is stiffer than its shear modulus per node spacing by
/// a factor of 1e4 and more. A penalty stays softer than that of the contact.
double AugmentedLagrangian::stiffer_penalty(const BlockContact& working,
                                            const BlockContact& contact) const {
  double limit = stiffest_penalty(working.tolerance);
  if (!mechanics::has_wall(contact.law))
    limit = std::min(limit, contact.penalty);
  return std::max(working.penalty, std::min(stiffer * working.penalty, limit));
}

/// The next working penalty [Pa/m] if forces are not balanced with the present
/// one, because the roundoff of a gap is not small in its pressure. The first
/// penalty is a multiple of the largest shear modulus at the contact surface,
/// but the displacement is that of the softest cells.
double AugmentedLagrangian::softer_penalty(const BlockContact& working) {
  if (state_.unbalanced() <= working.tolerance)
    return working.penalty;
  return std::min(working.penalty,
                  std::max(softest_spring * state_.stiffness_scale(),
                           stiffest_penalty(working.tolerance)));
}

void AugmentedLagrangian::solve(const mechanics::LoadTarget& load,
                                const BlockContact& contact,
                                double height_scale, BlockSolution& answer) {
  BlockContact spring = contact;
  spring.penalty = first_penalty(contact);
  const double compliance = contact.local_compliance();
  if (state_.is_elastic())
    std::fill(state_.multiplier.begin(), state_.multiplier.end(), 0.0);
  else
    keep_pressure(1.0 - spring.penalty * compliance);
  double last = std::numeric_limits<double>::infinity();
  while (newton_.solve(load, spring, answer)) {
    const bool is_own =
        !mechanics::has_wall(contact.law) && spring.penalty == contact.penalty;
    answer.residual =
        is_own ? 0.0 : state_.violation(compliance) / height_scale;
    const double softer = softer_penalty(spring);
    answer.converged =
        answer.residual <= contact.tolerance && softer == spring.penalty;
    if (answer.converged)
      break;
    const double missing = missing_pressure(load, compliance);
    if (missing > 0.0 &&
        !can_bear(missing, contact.tolerance * height_scale, answer))
      break;
    if (softer < spring.penalty)
      spring.penalty = softer;
    else if (answer.residual > slow * last)
      spring.penalty = stiffer_penalty(spring, contact);
    last = answer.residual;
    // The part of a pressure that the working penalty does not represent in the
    // gap.
    keep_pressure(1.0 - spring.penalty * compliance, missing);
  }
}

/// The uniform pressure [Pa] by which the points must be pressed more to have
/// the prescribed mean gap; 0 if it is not known. If all points are in contact,
/// the mean gap under a penalty k is minus the nominal pressure over k, so that
/// the multipliers need not approach this pressure in steps of the working
/// penalty.
double AugmentedLagrangian::missing_pressure(const mechanics::LoadTarget& load,
                                             double compliance) const {
  const bool is_full = std::ranges::all_of(
      state_.pressure, [](double pressure) { return pressure > 0.0; });
  if (load.control != mechanics::Control::mean_gap || compliance == 0.0 ||
      min(is_full ? 1 : 0, MPI_COMM_WORLD) == 0)
    return 0.0;
  return std::max(0.0,
                  -load.amount / compliance - state_.borne() / state_.area());
}

/// Whether the gaps are known to the tolerance [m] under a nominal pressure
/// that is greater by `missing` [Pa]. The rigid gap grows with the pressure, by
/// the compression of the block, and gaps are differences from it.
bool AugmentedLagrangian::can_bear(double missing, double gap_tolerance,
                                   BlockSolution& answer) const {
  const double pressure = state_.borne() / state_.area() + missing;
  const double compression =
      std::abs(state_.rigid_gap) / (state_.borne() / state_.area()) * pressure;
  const double roundoff = std::numeric_limits<double>::epsilon() * compression;
  if (roundoff <= gap_tolerance)
    return true;
  answer.note = fmt::format(
      "the mean gap requires a nominal pressure of {:.3g} Pa, which compresses "
      "the block by {:.3g} m; the roundoff of gaps is then {} m, but must "
      "be at most the tolerance of {} m: choose a softer penalty or a "
      "larger mean gap",
      pressure, compression, number_text(roundoff, gap_tolerance, 2),
      number_text(gap_tolerance, roundoff, 2));
  return false;
}

namespace {

/// Halvings of the interval in which the step length lies.
constexpr int halvings = 40;

/// The same where the material is not linear, and each takes a pass over the
/// cells.
constexpr int halvings_by_material = 10;

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
    if (is_load && (is_cycling || !state_.is_elastic()))
      start = state_.placement();
    if (!step_.take(load, springs, nothing, iteration.accuracy_on_springs())) {
      if (!iteration.is_cycling()) { // a full step may lead anywhere
        return_to(settled_, penalty);
        iteration.expect_cycles();
        continue;
      }
      answer.note = "the linear solver did not converge";
      has_linear_failure_ = true;
      return false;
    }
    if (start)
      shorten_step(*start, penalty);
    state_.press_springs(penalty);
    const int changed = n_changed(contact_set(state_.pressure), before);
    const double imbalance = state_.unbalanced();
    step_.tell(answer.iterations, imbalance, changed);
    if (iteration.has_ended(changed, imbalance, state_.is_elastic())) {
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
/// step of Newton's method descends. So is the energy of a material law, with
/// the work that it dissipates during the load step in it.
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
        state_.material() != nullptr
            ? state_.stress_work(before, step, share) + far_work
            : start + share * increase;
    return total - contact_work(before, share, penalty);
  };
  double low = 0.0;
  double high = 1.0;
  const bool is_between = derivative(0.0) < 0.0 && derivative(1.0) > 0.0;
  const int most =
      state_.material() != nullptr ? halvings_by_material : halvings;
  for (int i = 0; is_between && i < most; ++i) {
    const double middle = 0.5 * (low + high);
    (derivative(middle) > 0.0 ? high : low) = middle;
  }
  state_.shorten_way(before, high);
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
