#include "fem/contact_newton.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::fem {
namespace {

using dealii::TrilinosWrappers::MPI::Vector;

/// Residual of a linear solve over that of its start: while the contact set
/// still moves, and for the last steps.
constexpr double loose = 1e-4;
constexpr double tight = 1e-12;

/// A 2x2 system M (dd, dP) = r, by Cramer's rule.
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
  force_scale_ = imbalance_.l2_norm();
  Vector elastic = system_.space().make_vector();
  system_.stiffness().vmult(elastic, displacement_);
  imbalance_ += elastic;
  imbalance_.add(top_pressure_, system_.top_load());
}

/// The largest force left over, relative to the largest contact force [1].
double ContactNewton::unbalanced() {
  find_imbalance();
  const ContactPoints& points = system_.contact();
  double largest = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    largest = std::max(largest, points[i].area * std::abs(pressure_[i]));
  largest = dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
  return largest > 0.0 ? imbalance_.linfty_norm() / largest : 0.0;
}

/// answer = (K + springs)^-1 forces with the unknowns of held points at the
/// given displacements; starts from what `answer` is.
bool ContactNewton::solve_for(Vector& answer, const Vector& forces,
                              std::span<const double> held_displacement,
                              bool is_tight) {
  const ContactPoints& points = system_.contact();
  Vector right(forces);
  Vector held(forces);
  held = 0.0;
  if (!held_displacement.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::isnan(held_displacement[i]))
        held(points[i].row.front().first) = held_displacement[i];
    held.compress(dealii::VectorOperation::insert);
    Vector reaction(forces);
    system_.stiffness().vmult(reaction, held);
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
      std::max((is_tight ? tight : loose) * right.l2_norm(),
               1e-2 * tight * force_scale_);
  if (!solver_.solve(answer, right, tolerance))
    return false;
  answer += held;
  return true;
}

/// Solves (F.1), linear for one contact set, for the changes of u, d and P: u
/// by block elimination, d and P from the two scalar equations.
bool ContactNewton::step(const BlockLoad& load, std::span<const double> springs,
                         const std::vector<bool>& held, bool is_tight) {
  const ContactPoints& points = system_.contact();
  const bool is_load = load.control == cases::Control::nominal_pressure;
  if (is_load)
    top_pressure_ = load.target; // then d is the one scalar unknown
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
  if (!solve_for(by_imbalance_, forces, to_wall, is_tight))
    return false;
  std::vector<double> pushes(springs.begin(), springs.end());
  for (double& push : pushes)
    push = -push;
  forces = 0.0;
  points.add_force(pushes, forces);
  if (!solve_for(by_approach_, forces, with_wall, is_tight))
    return false;
  forces = system_.top_load();
  forces *= -1.0;
  if (is_load || forces.linfty_norm() == 0.0)
    by_top_ = 0.0;
  else if (!solve_for(by_top_, forces, at_rest, is_tight))
    return false;
  return border(load, springs, held);
}

/// The two scalar equations, balance and control, and the step itself.
bool ContactNewton::border(const BlockLoad& load,
                           std::span<const double> springs,
                           const std::vector<bool>& held) {
  const ContactPoints& points = system_.contact();
  const std::array<Vector*, 3> responses{&by_imbalance_, &by_approach_,
                                         &by_top_};
  // Of each response: the mean displacement and the contact force it brings.
  std::vector<double> sums(6, 0.0);
  std::vector<double> at_points;
  Vector reaction(imbalance_);
  for (std::size_t r = 0; r < 3; ++r) {
    points.take_displacement(*responses[r], at_points);
    system_.stiffness().vmult(reaction, *responses[r]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double moved = at_points[i] + (r == 1 ? 1.0 : 0.0);
      sums[r] += points[i].area * moved;
      sums[3 + r] -= springs[i] * moved;
      if (held[i])
        sums[3 + r] += reaction(points[i].row.front().first);
    }
  }
  // What holds a node now; free points' forces are in p.
  double now = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    now += points[i].area * pressure_[i] +
           (held[i] ? imbalance_(points[i].row.front().first) : 0.0);
  dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
  now = dealii::Utilities::MPI::sum(now, MPI_COMM_WORLD);

  Border scalars;
  scalars.force_d = sums[4];
  scalars.force_pressure = sums[5] - area();
  scalars.force_right = top_pressure_ * area() - now - sums[3];
  if (load.control == cases::Control::nominal_pressure) {
    scalars.control_pressure = 1.0;
  } else {
    scalars.control_d = sums[1] / area();
    scalars.control_pressure = sums[2] / area();
    scalars.control_right = load.target - mean_gap() - sums[0] / area();
  }
  const auto [approach, pressure] = scalars.solution();
  if (!std::isfinite(approach) || !std::isfinite(pressure))
    return false;
  displacement_ += by_imbalance_;
  displacement_.add(approach, by_approach_, pressure, by_top_);
  rigid_gap_ += approach;
  top_pressure_ += pressure;
  points.take_displacement(displacement_, face_displacement_);
  return true;
}

} // namespace asperity::fem
