#include "fem/newton/contact_newton.hpp"

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
constexpr double slack = 0.1;

/// Maximum number of steps: an active set that converges does so within some
/// ten steps; others cycle.
constexpr int most_steps = 30;

} // namespace

/// Computes p of active points from the constraint forces; p is 0 elsewhere.
void ContactNewton::take_wall_pressure(const std::vector<bool>& active) {
  std::fill(pressure_.begin(), pressure_.end(), 0.0);
  find_imbalance(); // gives K u + P g, since p = 0
  const ContactPoints& points = system_.contact();
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    if (active[i])
      pressure_[i] = imbalance_(points[i].row.front().first) / points[i].area;
}

/// The next active set: removes points under tension and adds points that
/// penetrate. A tension that is kept is set to zero at the end, so that it is
/// small for the gap and for the balance of the forces. Under a light load the
/// pressure of a gap tolerance exceeds all others.
std::vector<bool> ContactNewton::next_active(const std::vector<bool>& active,
                                             const BlockContact& contact,
                                             double gap_tolerance) const {
  double highest = 0.0;
  for (const double pressure : pressure_)
    highest = std::max(highest, pressure);
  const double pull = slack * gap_tolerance * stiffness_scale_;
  const double rounding = 1e-12 * max(highest, MPI_COMM_WORLD);
  const double force = slack * contact.tolerance * largest_force();
  std::vector<bool> next(active.size());
  for (std::size_t i = 0; i < next.size(); ++i) {
    const double tension =
        std::max(std::min(pull, force / system_.contact()[i].area), rounding);
    next[i] =
        active[i] ? pressure_[i] >= -tension : gap(i) < -slack * gap_tolerance;
  }
  return next;
}

/// The primal-dual active-set method: constrain the active points, solve for
/// balance, then update the set from tensile pressures and penetrations.
/// @return  whether the active set converged; if not, the note gives the reason
bool ContactNewton::active_set(const mechanics::LoadTarget& load,
                               const BlockContact& contact,
                               double gap_tolerance, BlockSolution& answer) {
  const double spring = first_spring * stiffness_scale_;
  const std::vector<double> no_springs(pressure_.size(), 0.0);
  std::vector<bool> active(pressure_.size());
  std::transform(pressure_.begin(), pressure_.end(), active.begin(),
                 [](double pressure) { return pressure > 0.0; });
  int refinements = 0;
  const int last = std::min(contact.max_iterations, most_steps);
  while (answer.iterations < last) {
    ++answer.iterations;
    is_careful_ = answer.iterations > most_full_steps;
    if (load.control == mechanics::Control::nominal_pressure && !any(active)) {
      rigid_gap_ = touching_gap(load.amount, spring);
      for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = gap(i) < 0.0;
    }
    for (std::size_t i = 0; i < active.size(); ++i)
      pressure_[i] = active[i] ? pressure_[i] : 0.0;
    if (!step(load, no_springs, active, contact.tolerance, refinements)) {
      answer.note = solver_.failure();
      return false;
    }
    take_wall_pressure(active);
    const std::vector<bool> next = next_active(active, contact, gap_tolerance);
    const int changed = n_changed(next, active);
    const double residual = unbalanced();
    report_step(answer.iterations, residual, changed);
    if (changed != 0) {
      refinements = 0;
    } else if (residual <= contact.tolerance ||
               refinements++ == most_refinements) {
      return true;
    }
    active = next;
  }
  answer.note = "the active set did not converge";
  return false;
}

/// Solves hard contact by the active-set method and, if that fails, by the
/// augmented Lagrangian method, which has the same solution.
void ContactNewton::solve_wall(const mechanics::LoadTarget& load,
                               const BlockContact& contact, double height_scale,
                               BlockSolution& answer) {
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);
  answer.converged =
      active_set(load, contact, contact.tolerance * height_scale, answer);
  // Tensile pressures are set to zero, whether they are roundoff or belong to
  // an active set that did not converge.
  for (double& pressure : pressure_)
    pressure = std::max(0.0, pressure);
  answer.residual = violation(0.0) / height_scale;
  if (answer.converged || answer.iterations >= contact.max_iterations)
    return;
  const std::string why = answer.note;
  answer.note.clear();
  solve_springs(load, contact, height_scale, answer);
  answer.note =
      why + (answer.note.empty() ? "; solved by the augmented Lagrangian"
                                 : "; augmented Lagrangian: " + answer.note);
}

} // namespace asperity::fem
