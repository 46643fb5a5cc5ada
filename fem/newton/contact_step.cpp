#include "fem/newton/contact_newton.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace asperity::fem {
namespace {

using dealii::TrilinosWrappers::MPI::Vector;

/// Relative residual at which a linear solve stops. Newton's steps are equally
/// inexact and continue until the forces balance, so no solve needs to be more
/// accurate than the step that it serves. Stiff springs amplify errors in the
/// pressure, so with 1e-2 the iteration might not find their contact set.
constexpr double loose_on_wall = 1e-2;
constexpr double loose_on_springs = 1e-3;

/// Relative residual where full steps have not found the contact set. Of
/// shortened steps, each must decrease the energy, which those of strongly
/// heterogeneous blocks do not do with 1e-3; and the contact forces of nearly
/// incompressible cells are not known well enough with 1e-2.
constexpr double careful = 1e-6;

/// Factor by which a refinement reduces the residual of a response that it
/// reuses from the previous step.
constexpr double sharpening = 1e-2;

/// Fraction of the permitted imbalance below which no solve needs to go.
constexpr double finest = 0.1;

/// A 2x2 system M (dd, dP) = r, solved by Cramer's rule.
struct Border {
  double force_d = 0.0, force_pressure = 0.0, force_right = 0.0;
  double control_d = 0.0, control_pressure = 0.0, control_right = 0.0;

  std::array<double, 2> solution() const {
    const double determinant =
        force_d * control_pressure - force_pressure * control_d;
    return {(force_right * control_pressure - force_pressure * control_right) /
                determinant,
            (force_d * control_right - force_right * control_d) / determinant};
  }
};

} // namespace

void ContactNewton::find_imbalance() {
  const ContactPoints& points = system_.contact();
  std::vector<double> forces(points.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = -points[i].area * pressure_[i];
  imbalance_ = 0.0;
  points.add_force(forces, imbalance_);
  imbalance_ += elastic_;
  imbalance_.add(far_pressure_, system_.far_load());
}

double ContactNewton::largest_force() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    largest = larger_residual(largest, system_.contact()[i].area *
                                           std::abs(pressure_[i]));
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

/// The largest unbalanced force, relative to the largest contact force [1].
double ContactNewton::unbalanced() {
  find_imbalance();
  const double largest = largest_force();
  // A sum propagates a NaN; the maximum norm need not.
  if (!std::isfinite(imbalance_.l2_norm()))
    return std::numeric_limits<double>::infinity();
  return largest > 0.0 ? imbalance_.linfty_norm() / largest : 0.0;
}

/// The largest nodal force [N] by which displacements differ that differ by
/// half a unit in the last place, with signs from the bits of their values. No
/// solution in double precision is balanced much better.
double ContactNewton::rounding_force() const {
  constexpr double half = 0.5 * std::numeric_limits<double>::epsilon();
  Vector rounding(displacement_);
  for (const auto unknown : rounding.locally_owned_elements()) {
    const bool is_odd = std::hash<double>{}(rounding(unknown)) % 2 == 1;
    rounding(unknown) = (is_odd ? -half : half) * displacement_(unknown);
  }
  rounding.compress(dealii::VectorOperation::insert);
  Vector forces(rounding);
  solver_.multiply(forces, rounding);
  return forces.linfty_norm();
}

/// The force per unit of approach, as an l2 norm over the points [N/m]. A
/// spring stiffer than the block counts with the stiffness of the block. The
/// result is infinite without springs.
double ContactNewton::stiffness_of(std::span<const double> springs) const {
  double square = 0.0;
  for (std::size_t i = 0; i < springs.size(); ++i)
    square += std::pow(
        std::min(springs[i], stiffness_scale_ * system_.contact()[i].area), 2);
  square = dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD);
  return square > 0.0 ? std::sqrt(square)
                      : std::numeric_limits<double>::infinity();
}

/// The relative residual at which a linear solve stops.
double ContactNewton::relative_tolerance(bool has_wall) const {
  const double usual =
      solver_.tightness() * (has_wall ? loose_on_wall : loose_on_springs);
  return is_careful_ ? std::min(usual, careful) : usual;
}

/// Solves answer = (K + springs)^-1 forces with the unknowns of held points
/// fixed at the given displacements. The initial guess is the content of
/// `answer`.
/// @param range  bounds on the l2 norm of the residual, in the unit of the
///               forces
bool ContactNewton::solve_for(Vector& answer, const Vector& forces,
                              std::span<const double> held_displacement,
                              const Range& range) {
  const ContactPoints& points = system_.contact();
  // A rank may have no points at all.
  const bool has_wall =
      dealii::Utilities::MPI::max(held_displacement.empty() ? 0 : 1,
                                  MPI_COMM_WORLD) == 1;
  Vector right(forces);
  Vector held(forces);
  held = 0.0;
  if (has_wall) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::isnan(held_displacement[i]))
        held(points[i].row.front().first) = held_displacement[i];
    held.compress(dealii::VectorOperation::insert);
    Vector reaction(forces);
    solver_.multiply(reaction, held);
    right -= reaction;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::isnan(held_displacement[i])) {
        right(points[i].row.front().first) = 0.0;
        answer(points[i].row.front().first) = 0.0;
      }
    right.compress(dealii::VectorOperation::insert);
    answer.compress(dealii::VectorOperation::insert);
  }
  const double tolerance =
      std::clamp(range.share * relative_tolerance(has_wall) * right.l2_norm(),
                 range.finest, range.coarsest);
  if (!solver_.solve(answer, right, tolerance))
    return false;
  report();
  answer += held;
  return true;
}

/// Solves (F.1), which is linear for a fixed contact set, for the changes of u,
/// d and P: u by block elimination, d and P from the two scalar equations. The
/// response of the block to a unit approach or pressure is the same in every
/// step on one contact set, so its accuracy grows with the number of
/// `refinements`.
bool ContactNewton::step(const mechanics::LoadTarget& load,
                         std::span<const double> springs,
                         const std::vector<bool>& held, double tolerance,
                         int refinements) {
  const ContactPoints& points = system_.contact();
  const bool is_load = load.control == mechanics::Control::nominal_pressure;
  if (is_load)
    far_pressure_ = load.amount; // d is then the only scalar unknown
  solver_.set_contact(springs, held);
  find_imbalance();

  constexpr double is_free = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> to_wall, with_wall, at_rest;
  if (any(held)) {
    to_wall.assign(points.size(), is_free);
    with_wall = at_rest = to_wall;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (held[i]) {
        to_wall[i] = -gap(i);
        with_wall[i] = -1.0;
        at_rest[i] = 0.0;
      }
  }
  Vector forces(imbalance_);
  forces *= -1.0;
  by_imbalance_ = 0.0;
  if (!solve_for(by_imbalance_, forces, to_wall,
                 {.finest = finest * tolerance * largest_force()}))
    return false;
  const double share = std::pow(sharpening, refinements);
  std::vector<double> pushes(springs.begin(), springs.end());
  for (double& push : pushes)
    push = -push;
  forces = 0.0;
  points.add_force(pushes, forces);
  if (!solve_for(by_approach_, forces, with_wall,
                 {.coarsest =
                      share * relative_tolerance(false) * stiffness_of(springs),
                  .share = share}))
    return false;
  forces = system_.far_load();
  forces *= -1.0;
  if (is_load || forces.linfty_norm() == 0.0)
    by_far_pressure_ = 0.0;
  else if (!solve_for(by_far_pressure_, forces, at_rest, {.share = share}))
    return false;
  return border(load, springs, held);
}

/// Solves the two scalar equations, force balance and control, and applies the
/// step.
bool ContactNewton::border(const mechanics::LoadTarget& load,
                           std::span<const double> springs,
                           const std::vector<bool>& held) {
  const ContactPoints& points = system_.contact();
  const std::array<Vector*, 3> responses{&by_imbalance_, &by_approach_,
                                         &by_far_pressure_};
  // For each response: the mean displacement and the contact force that it
  // causes.
  std::vector<double> sums(6, 0.0);
  std::vector<double> at_points;
  Vector reaction(imbalance_);
  for (std::size_t r = 0; r < 3; ++r) {
    if (r == 2 && responses[r]->linfty_norm() == 0.0)
      continue; // the far boundary is held
    points.take_displacement(*responses[r], at_points);
    solver_.multiply(reaction, *responses[r]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double moved = at_points[i] + (r == 1 ? 1.0 : 0.0);
      sums[r] += points[i].area * moved;
      sums[3 + r] -= springs[i] * moved;
      if (held[i])
        sums[3 + r] += reaction(points[i].row.front().first);
    }
  }
  // The present contact force: constraint forces of held points; at the other
  // points it is contained in p.
  double now = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    now += points[i].area * pressure_[i] +
           (held[i] ? imbalance_(points[i].row.front().first) : 0.0);
  dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
  now = dealii::Utilities::MPI::sum(now, MPI_COMM_WORLD);

  Border scalars;
  scalars.force_d = sums[4];
  approach_stiffness_ = -sums[4];
  scalars.force_pressure = sums[5] - area();
  scalars.force_right = far_pressure_ * area() - now - sums[3];
  if (load.control == mechanics::Control::nominal_pressure) {
    scalars.control_pressure = 1.0;
  } else {
    scalars.control_d = sums[1] / area();
    scalars.control_pressure = sums[2] / area();
    scalars.control_right = load.amount - mean_gap() - sums[0] / area();
  }
  const auto [approach, pressure] = scalars.solution();
  if (!std::isfinite(approach) || !std::isfinite(pressure))
    return false;
  displacement_ += by_imbalance_;
  displacement_.add(approach, by_approach_, pressure, by_far_pressure_);
  rigid_gap_ += approach;
  far_pressure_ += pressure;
  points.take_displacement(displacement_, face_displacement_);
  solver_.multiply(elastic_, displacement_);
  return true;
}

} // namespace asperity::fem
