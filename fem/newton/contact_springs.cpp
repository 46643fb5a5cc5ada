// Newton's method for springs at the contact points with fixed multipliers.

#include "fem/newton/contact_newton.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <optional>

namespace asperity::fem {

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::min;
using dealii::Utilities::MPI::sum;

std::vector<bool> contact_set(const std::vector<double>& pressure) {
  std::vector<bool> set(pressure.size());
  std::transform(pressure.begin(), pressure.end(), set.begin(),
                 [](double p) { return p > 0.0; });
  return set;
}

bool ContactNewton::any(const std::vector<bool>& set) const {
  const bool here = std::find(set.begin(), set.end(), true) != set.end();
  return max(here ? 1 : 0, MPI_COMM_WORLD) == 1;
}

/// The number of points in one set only, over all ranks.
int ContactNewton::n_changed(const std::vector<bool>& a,
                             const std::vector<bool>& b) const {
  int changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    changed += a[i] != b[i] ? 1 : 0;
  return sum(changed, MPI_COMM_WORLD);
}

void ContactNewton::report() {
  progress_.linear_iterations = solver_.iterations() - iterations_before_;
  if (watch_)
    watch_(progress_);
}

void ContactNewton::report_step(int iterations, double residual,
                                int changed_points) {
  progress_.iterations = iterations;
  progress_.residual = residual;
  progress_.changed_points = changed_points;
  report();
}

/// The rigid gap at which the block in its present deformation carries the
/// nominal pressure. The monotone equation is solved by bisection between first
/// contact and all points in contact.
double ContactNewton::touching_gap(double nominal_pressure,
                                   double penalty) const {
  double high = -1e300;
  double low = 1e300;
  for (std::size_t i = 0; i < pressure_.size(); ++i) {
    if (!system_.contact()[i].is_opposed)
      continue;
    const double own =
        heights_[i] - face_displacement_[i] + multiplier_[i] / penalty;
    high = std::max(high, own);
    low = std::min(low, own - nominal_pressure / penalty);
  }
  high = max(high, MPI_COMM_WORLD);
  low = min(low, MPI_COMM_WORLD);
  const auto bears = [&](double d) {
    double force = 0.0;
    for (std::size_t i = 0; i < pressure_.size(); ++i)
      if (system_.contact()[i].is_opposed)
        force += system_.contact()[i].area *
                 std::max(0.0, multiplier_[i] -
                                   penalty * (d + face_displacement_[i] -
                                              heights_[i]));
    return sum(force, MPI_COMM_WORLD) / area();
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (bears(middle) > nominal_pressure ? low : high) = middle;
  }
  return low;
}

void ContactNewton::update_pressure(double penalty) {
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    pressure_[i] = system_.contact()[i].is_opposed
                       ? std::max(0.0, multiplier_[i] - penalty * gap(i))
                       : 0.0;
}

/// Newton's method at fixed multipliers until the contact set no longer
/// changes. Steps on an unchanged set reduce the error that the linear solver,
/// or the roundoff of a large step, has left. If full steps do not find the
/// contact set, steps under a prescribed load are shortened; a prescribed mean
/// gap, which minimises no energy, is approached by loads first. The same if
/// the linear solver fails, which full steps far from any solution may cause.
bool ContactNewton::newton(const mechanics::LoadTarget& load,
                           const BlockContact& contact, BlockSolution& answer,
                           bool is_hard_to_find) {
  int refinements = 0;
  int changes = is_hard_to_find ? most_full_steps : 0;
  const std::vector<bool> nothing(pressure_.size(), false);
  std::vector<double> springs(pressure_.size());
  update_pressure(contact.penalty);
  while (answer.iterations < contact.max_iterations) {
    const bool are_cycling = changes >= most_full_steps;
    if (are_cycling && load.control == mechanics::Control::mean_gap) {
      changes = 0;
      if (!approach_by_load(load.amount, contact, answer))
        return false;
    }
    is_careful_ = changes >= most_loose_steps;
    const std::vector<bool> before = contact_set(pressure_);
    ++answer.iterations;
    if (load.control == mechanics::Control::nominal_pressure && !any(before)) {
      rigid_gap_ = touching_gap(load.amount, contact.penalty);
      update_pressure(contact.penalty);
      continue;
    }
    for (std::size_t i = 0; i < springs.size(); ++i)
      springs[i] =
          before[i] ? contact.penalty * system_.contact()[i].area : 0.0;
    std::optional<State> start;
    if (are_cycling && load.control == mechanics::Control::nominal_pressure)
      start = state();
    if (!step(load, springs, nothing, contact.tolerance, refinements)) {
      if (changes < most_full_steps) {
        return_to(settled_, contact.penalty);
        changes = most_full_steps;
        continue;
      }
      answer.note = solver_.failure();
      has_linear_failure_ = true;
      return false;
    }
    if (start)
      shorten_step(*start, contact.penalty);
    update_pressure(contact.penalty);
    const int changed = n_changed(contact_set(pressure_), before);
    const double residual = unbalanced();
    report_step(answer.iterations, residual, changed);
    if (changed != 0) {
      refinements = 0;
      ++changes;
    } else if (residual <= contact.tolerance ||
               refinements++ == most_refinements) {
      settled_ = state();
      return true;
    }
  }
  answer.note = "the contact set did not converge";
  return false;
}

} // namespace asperity::fem
