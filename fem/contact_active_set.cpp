#include "fem/contact_newton.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

using dealii::Utilities::MPI::max;

/// What a start from nothing presses with, in shear moduli a spacing.
constexpr double first_spring = 1e3;

/// Share of the tolerance below which an overlap or a pull is rounding.
constexpr double slack = 0.1;

} // namespace

/// p of held points from what holds them; 0 elsewhere.
void ContactNewton::take_wall_pressure(const std::vector<bool>& active) {
  std::fill(pressure_.begin(), pressure_.end(), 0.0);
  find_imbalance(); // K u + P g alone
  const ContactPoints& points = system_.contact();
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    if (active[i])
      pressure_[i] = imbalance_(points[i].row.front().first) / points[i].area;
}

/// Leaves out what is pulled and takes in what overlaps.
std::vector<bool> ContactNewton::next_active(const std::vector<bool>& active,
                                             double gap_tolerance) const {
  double highest = 0.0;
  for (const double pressure : pressure_)
    highest = std::max(highest, pressure);
  const double pull = slack * gap_tolerance * stiffness_scale_;
  const double rounding = 1e-12 * max(highest, MPI_COMM_WORLD);
  std::vector<bool> next(active.size());
  for (std::size_t i = 0; i < next.size(); ++i)
    next[i] = active[i] ? pressure_[i] >= -std::max(pull, rounding)
                        : gap(i) < -slack * gap_tolerance;
  return next;
}

/// The primal-dual active set: hold, balance, look who pulls and who overlaps.
void ContactNewton::solve_wall(const BlockLoad& load,
                               const BlockContact& contact, double height_scale,
                               BlockSolution& answer) {
  const double spring = first_spring * stiffness_scale_;
  const double gap_tolerance = contact.tolerance * height_scale;
  const std::vector<double> no_springs(pressure_.size(), 0.0);
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);
  std::vector<bool> active(pressure_.size());
  std::transform(pressure_.begin(), pressure_.end(), active.begin(),
                 [](double pressure) { return pressure > 0.0; });
  int refinements = 0;
  answer.note = "the contact set did not come to rest";
  while (answer.iterations < contact.max_iterations) {
    ++answer.iterations;
    if (load.control == cases::Control::nominal_pressure && !any(active)) {
      rigid_gap_ = touching_gap(load.target, spring);
      for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = gap(i) < 0.0;
    }
    for (std::size_t i = 0; i < active.size(); ++i)
      pressure_[i] = active[i] ? pressure_[i] : 0.0;
    if (!step(load, no_springs, active, contact.tolerance, refinements)) {
      answer.note = "the linear solver gave up";
      break;
    }
    take_wall_pressure(active);
    const std::vector<bool> next = next_active(active, gap_tolerance);
    if (!is_same(next, active)) {
      refinements = 0;
    } else if (unbalanced() <= contact.tolerance ||
               refinements++ == most_refinements) {
      answer.converged = true;
      answer.note.clear();
      break;
    }
    active = next;
  }
  // A pull of the size of rounding is no contact.
  for (double& pressure : pressure_)
    pressure = std::max(0.0, pressure);
  answer.residual = violation(0.0) / height_scale;
}

} // namespace asperity::fem
