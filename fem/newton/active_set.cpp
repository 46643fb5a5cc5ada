#include "fem/newton/active_set.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

using dealii::Utilities::MPI::max;

/// Spring with which contact is first detected when no node is active, in shear
/// moduli per node spacing.
constexpr double first_spring = 1e3;

/// Fraction of the tolerances of gap and forces below which a penetration or a
/// tensile pressure is considered roundoff.
constexpr double rounding_share = 0.1;

} // namespace

/// Computes p of active points from the constraint forces; p is 0 elsewhere.
void ActiveSet::take_pressure(const ContactSet& active) {
  std::fill(state_.pressure.begin(), state_.pressure.end(), 0.0);
  state_.find_imbalance(); // gives K u + P g, since p = 0
  const ContactPoints& points = state_.points();
  for (std::size_t i = 0; i < state_.pressure.size(); ++i)
    if (active[i])
      state_.pressure[i] =
          state_.imbalance(points[i].row.front().first) / points[i].area;
}

/// The next active set: removes points under tension and adds points that
/// penetrate. A tension that is kept is set to zero at the end, so that it is
/// small for the gap and for the balance of the forces. Under a light load the
/// pressure of a gap tolerance exceeds all others.
ContactSet ActiveSet::next_active(const ContactSet& active,
                                  const BlockContact& contact,
                                  double gap_tolerance) const {
  double highest = 0.0;
  for (const double pressure : state_.pressure)
    highest = std::max(highest, pressure);
  const double pull = rounding_share * gap_tolerance * state_.stiffness_scale();
  const double rounding = 1e-12 * max(highest, MPI_COMM_WORLD);
  const double force =
      rounding_share * contact.tolerance * state_.largest_force();
  ContactSet next(active.size());
  for (std::size_t i = 0; i < next.size(); ++i) {
    const double tension =
        std::max(std::min(pull, force / state_.points()[i].area), rounding);
    next[i] = active[i] ? state_.pressure[i] >= -tension
                        : state_.gap(i) < -rounding_share * gap_tolerance;
  }
  return next;
}

bool ActiveSet::solve(const mechanics::LoadTarget& load,
                      const BlockContact& contact, double gap_tolerance,
                      BlockSolution& answer) {
  const bool is_found = iterate(load, contact, gap_tolerance, answer);
  // Tensile pressures are set to zero, whether they are roundoff or belong to
  // an active set that did not converge.
  for (double& pressure : state_.pressure)
    pressure = std::max(0.0, pressure);
  return is_found;
}

bool ActiveSet::iterate(const mechanics::LoadTarget& load,
                        const BlockContact& contact, double gap_tolerance,
                        BlockSolution& answer) {
  const double spring = first_spring * state_.stiffness_scale();
  const std::vector<double> no_springs(state_.pressure.size(), 0.0);
  ContactSet active = contact_set(state_.pressure);
  ContactIteration iteration(contact.tolerance);
  const int first = answer.iterations;
  const int last = std::min(contact.max_iterations,
                            first + ContactIteration::most_active_sets);
  while (answer.iterations < last) {
    const int steps = answer.iterations++ - first;
    if (load.control == mechanics::Control::nominal_pressure &&
        !is_any(active)) {
      state_.rigid_gap = state_.touching_gap(load.amount, spring);
      for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = state_.gap(i) < 0.0;
    }
    for (std::size_t i = 0; i < active.size(); ++i)
      state_.pressure[i] = active[i] ? state_.pressure[i] : 0.0;
    if (!step_.take(load, no_springs, active,
                    iteration.accuracy_on_wall(steps))) {
      answer.note = step_.failure();
      return false;
    }
    take_pressure(active);
    ContactSet next = next_active(active, contact, gap_tolerance);
    const int changed = n_changed(next, active);
    const double imbalance = state_.unbalanced();
    step_.tell(answer.iterations, imbalance, changed);
    if (iteration.has_ended(changed, imbalance, state_.is_flowing()))
      return true;
    active = std::move(next);
  }
  answer.note = "the active set did not converge";
  return false;
}

} // namespace asperity::fem
