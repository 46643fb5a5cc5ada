#include "fem/block/contact_newton.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace asperity::fem {
namespace {

/// Halvings of the interval in which the step length lies.
constexpr int halvings = 40;

} // namespace

ContactNewton::State ContactNewton::state() const {
  return {displacement_, elastic_, face_displacement_, rigid_gap_};
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
/// and that solution. Returns whether it was found; if not, the note gives the
/// reason. A heterogeneous block between flat surfaces may lift some nodes
/// under any pressure, and the gap then has a least mean.
bool ContactNewton::approach_by_load(double mean_gap_target,
                                     const BlockContact& contact,
                                     BlockSolution& answer) {
  constexpr double first_factor = 2.0;
  constexpr double largest_factor = 1e6;
  constexpr int bits = 30; // of the pressure
  std::uintmax_t most_loads = 100;
  const double present = borne() / area();
  const double guess =
      present > 0.0 ? present : stiffness_scale_ * std::abs(mean_gap());
  double least = std::numeric_limits<double>::infinity();
  bool has_failed = false;
  const auto excess_at = [&](double pressure) {
    if (!has_failed && pressure > largest_factor * guess) {
      answer.note = fmt::format(
          "no nominal pressure up to {:.3g} Pa closes the gap to {:.3g} m; its "
          "mean must be at least {:.3g} m",
          pressure, mean_gap_target, least);
      has_failed = true;
    }
    const mechanics::LoadTarget load{mechanics::Control::nominal_pressure,
                                     pressure};
    has_failed = has_failed || !newton(load, contact, answer, true);
    least = std::min(least, mean_gap());
    return has_failed ? 0.0 : mean_gap() - mean_gap_target;
  };
  boost::math::tools::bracket_and_solve_root(
      excess_at, guess, first_factor, false,
      boost::math::tools::eps_tolerance<double>(bits), most_loads);
  return !has_failed;
}

} // namespace asperity::fem
