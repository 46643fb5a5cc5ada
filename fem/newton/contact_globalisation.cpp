#include "fem/newton/contact_newton.hpp"

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

ContactNewton::State ContactNewton::state() const {
  return {displacement_, elastic_, face_displacement_, rigid_gap_};
}

void ContactNewton::return_to(const State& state, double penalty) {
  displacement_ = state.displacement;
  elastic_ = state.elastic;
  face_displacement_ = state.face_displacement;
  rigid_gap_ = state.rigid_gap;
  update_pressure(penalty);
}

/// Sums a_c p_c dgap_c/dt [N m] over the points of all ranks, at the share t of
/// the step from `before` to the present state.
double ContactNewton::contact_work(const State& before, double share,
                                   double penalty) const {
  double work = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i) {
    if (!system_.contact()[i].is_opposed)
      continue;
    const double moved = rigid_gap_ - before.rigid_gap + face_displacement_[i] -
                         before.face_displacement[i];
    const double gap_there = gap(i) - (1.0 - share) * moved;
    work += system_.contact()[i].area *
            std::max(0.0, multiplier_[i] - penalty * gap_there) * moved;
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
/// step of Newton's method descends.
void ContactNewton::shorten_step(const State& before, double penalty) {
  dealii::TrilinosWrappers::MPI::Vector step(displacement_);
  step -= before.displacement;
  const double start =
      before.elastic * step +
      far_pressure_ * (system_.far_load() * step +
                       area() * (rigid_gap_ - before.rigid_gap));
  const double increase = elastic_ * step - before.elastic * step;
  const auto derivative = [&](double share) {
    return start + share * increase - contact_work(before, share, penalty);
  };
  if (derivative(0.0) >= 0.0 || derivative(1.0) <= 0.0)
    return;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (derivative(middle) > 0.0 ? high : low) = middle;
  }
  displacement_.sadd(high, 1.0 - high, before.displacement);
  elastic_.sadd(high, 1.0 - high, before.elastic);
  for (std::size_t i = 0; i < face_displacement_.size(); ++i)
    face_displacement_[i] +=
        (1.0 - high) * (before.face_displacement[i] - face_displacement_[i]);
  rigid_gap_ += (1.0 - high) * (before.rigid_gap - rigid_gap_);
}

/// Finds the nominal pressure whose solution has the prescribed mean gap [m],
/// and that solution, from the last state that was a solution. Returns whether
/// it was found; if not, the note gives the reason.
bool ContactNewton::approach_by_load(double mean_gap_target,
                                     const BlockContact& contact,
                                     BlockSolution& answer) {
  constexpr int bits = 30; // of the pressure
  std::uintmax_t most_loads = 100;
  return_to(settled_, contact.penalty);
  const double present = borne() / area();
  const double guess =
      present > 0.0 ? present
                    : stiffness_scale_ * std::max(std::abs(mean_gap()),
                                                  std::abs(mean_gap_target));
  double least = std::numeric_limits<double>::infinity();
  bool has_failed = false;
  const Excess excess_at = [&](double pressure) {
    const mechanics::LoadTarget load{mechanics::Control::nominal_pressure,
                                     pressure};
    has_failed = has_failed || !newton(load, contact, answer, true);
    least = std::min(least, mean_gap());
    return has_failed ? 0.0 : mean_gap() - mean_gap_target;
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
