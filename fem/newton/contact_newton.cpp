#include "fem/newton/contact_newton.hpp"

#include "base/require.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::fem {

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::sum;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

double larger_residual(double largest, double residual) {
  if (std::isnan(residual))
    return std::numeric_limits<double>::infinity();
  return std::max(largest, residual);
}

ContactNewton::ContactNewton(const BlockSystem& system,
                             LinearSolver linear_solver,
                             std::unique_ptr<BlockPreconditioner> own,
                             std::unique_ptr<MatrixFreeBlock> matrix_free)
    : system_(system),
      solver_(system, linear_solver, std::move(own), std::move(matrix_free)),
      stiffness_scale_(system.face_shear_modulus() / system.grid().spacing_x()),
      displacement_(system.space().make_vector()),
      multiplier_(system.contact().size(), 0.0),
      pressure_(system.contact().size(), 0.0),
      heights_(system.contact().size(), 0.0),
      face_displacement_(system.contact().size(), 0.0),
      elastic_(displacement_),
      imbalance_(displacement_),
      by_imbalance_(displacement_),
      by_approach_(displacement_),
      by_far_pressure_(displacement_) {}

bool ContactNewton::solve_linear(std::span<const double> pressure,
                                 Vector& displacement) {
  const ContactPoints& points = system_.contact();
  std::vector<double> forces(points.size());
  double total = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i)
    total += forces[i] = points[i].area * pressure[i];
  Vector right = system_.space().make_vector();
  points.add_force(forces, right);
  right.add(-sum(total, MPI_COMM_WORLD) / area(), system_.far_load());
  solver_.set_contact(std::vector<double>(points.size(), 0.0),
                      std::vector<bool>(points.size(), false));
  displacement = 0.0;
  return solver_.solve(displacement, right, 1e-12 * right.l2_norm());
}

void ContactNewton::start_from(ContactStart start) {
  displacement_ = start.displacement;
  pressure_ = std::move(start.pressure);
  rigid_gap_ = start.rigid_gap;
  highest_ = start.highest;
  far_pressure_ = start.far_pressure;
  system_.contact().take_displacement(displacement_, face_displacement_);
  solver_.multiply(elastic_, displacement_);
}

double ContactNewton::mean_gap() const {
  double mean = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    mean += system_.contact()[i].area * gap(i);
  return sum(mean, MPI_COMM_WORLD) / area();
}

double ContactNewton::borne() const {
  double force = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    force += system_.contact()[i].area * pressure_[i];
  return sum(force, MPI_COMM_WORLD);
}

/// Stores heights relative to the highest at a contact point: the points that
/// carry a small load lie near it, and the gap there is then not a difference
/// of large numbers. The map may be higher between the points. The position of
/// the block does not change.
void ContactNewton::take_heights(std::vector<double> heights) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (system_.contact()[i].is_opposed)
      highest = std::max(highest, heights[i]);
  highest = max(highest, MPI_COMM_WORLD);
  rigid_gap_ += highest_ - highest;
  highest_ = highest;
  heights_ = std::move(heights);
  for (double& height : heights_)
    height -= highest;
}

/// The mean gap [m] of the undeformed block at which its highest point touches.
/// At a larger one there is no contact. A heterogeneous block may have such a
/// mean gap under a load, too, by lifting more of the surface than it lowers,
/// and Newton's method with full steps then finds neither.
double ContactNewton::touching_mean_gap() const {
  double depth = 0.0;
  for (std::size_t i = 0; i < heights_.size(); ++i)
    depth -= system_.contact()[i].area * heights_[i];
  return sum(depth, MPI_COMM_WORLD) / area();
}

/// Sets the solution without contact at a prescribed mean gap, which is known
/// exactly. The iterations leave a part of the displacement before, against
/// which no contact force measures.
void ContactNewton::lift_off(double mean_gap_target) {
  displacement_ = 0.0;
  elastic_ = 0.0;
  far_pressure_ = 0.0;
  std::fill(face_displacement_.begin(), face_displacement_.end(), 0.0);
  rigid_gap_ += mean_gap_target - mean_gap();
}

/// Ends without pressure.
void ContactNewton::leave_contact(BlockSolution& answer) {
  std::fill(multiplier_.begin(), multiplier_.end(), 0.0);
  std::fill(pressure_.begin(), pressure_.end(), 0.0);
  answer.converged = true;
}

/// Writes the energies and the place of the resultant force.
void ContactNewton::add_up(const BlockContact& contact,
                           BlockSolution& answer) const {
  const Grid& grid = system_.grid();
  const int middle_x = grid.points_x / 2, middle_y = grid.points_y / 2;
  const dealii::Point<2> middle(middle_x * grid.spacing_x(),
                                middle_y * grid.spacing_y());
  // Of a: w; of a p: 1, x, y, w, p.
  std::array<double, 6> sums{};
  for (std::size_t i = 0; i < pressure_.size(); ++i) {
    const ContactPoint& point = system_.contact()[i];
    const double force = point.area * pressure_[i];
    const std::array terms{point.area * face_displacement_[i],
                           force,
                           force * (point.place[0] - middle[0]),
                           force * (point.place[1] - middle[1]),
                           force * face_displacement_[i],
                           force * pressure_[i]};
    for (std::size_t k = 0; k < terms.size(); ++k)
      sums[k] += terms[k];
  }
  for (double& value : sums)
    value = sum(value, MPI_COMM_WORLD);
  const auto& [displacement, force, moment_x, moment_y, work, square] = sums;
  answer.elastic_energy = 0.5 * (work - force * displacement / area()) / area();
  if (!mechanics::has_wall(contact.law))
    answer.contact_energy = 0.5 * square / (contact.penalty * area());
  if (force > 0.0)
    answer.pressure_centre = {moment_x / force, moment_y / force};
}

void ContactNewton::solve(std::vector<double> heights, double height_scale,
                          const mechanics::LoadTarget& load,
                          const BlockContact& contact, BlockSolution& answer) {
  take_heights(std::move(heights));
  const int iterations = solver_.iterations();
  const int setups = solver_.setups();
  watch_ = contact.watch;
  progress_ = {.unknowns = system_.n_unknowns()};
  iterations_before_ = iterations;
  settled_ = state();
  is_careful_ = false;
  has_linear_failure_ = false;
  const bool is_gap = load.control == mechanics::Control::mean_gap;
  if (is_gap && load.amount < 0.0 && mechanics::has_wall(contact.law))
    answer.note = fmt::format("the mean gap of the contact points is {:.3g} m, "
                              "but must be >= 0 m where nothing overlaps",
                              load.amount);
  else if (is_gap && load.amount >= touching_mean_gap())
    leave_contact(answer);
  else if (mechanics::traits_of(contact.law).block_solver ==
           mechanics::BlockSolver::wall)
    solve_wall(load, contact, height_scale, answer);
  else
    solve_springs(load, contact, height_scale, answer);

  if (answer.converged && !any(contact_set(pressure_)))
    lift_off(load.amount);
  if (!answer.converged && has_linear_failure_)
    answer.note += solver_.advice();
  double touching = 0.0;
  for (std::size_t i = 0; i < pressure_.size(); ++i)
    touching += pressure_[i] > 0.0 ? system_.contact()[i].area : 0.0;
  answer.area_by_points = sum(touching, MPI_COMM_WORLD) / area();
  add_up(contact, answer);
  answer.mean_gap = mean_gap();
  answer.nominal_pressure = borne() / area();
  answer.residual = larger_residual(answer.residual, unbalanced());
  // Sums propagate a NaN or an infinity of any point.
  if (!std::isfinite(answer.mean_gap) ||
      !std::isfinite(answer.nominal_pressure)) {
    answer.residual = std::numeric_limits<double>::infinity();
    answer.converged = false;
    answer.note = "a gap or a pressure is not a finite number";
  }
  answer.linear_iterations = solver_.iterations() - iterations;
  answer.preconditioner_setups = solver_.setups() - setups;
  answer.linear_solver = solver_.name();
  answer.memory = solver_.memory();
  if (answer.converged && !(answer.residual <= contact.tolerance)) {
    answer.converged = false;
    answer.note = why_unbalanced(contact.tolerance, answer.residual);
  }
}

/// The note of a step whose forces are not balanced. The tolerance may be below
/// the roundoff of the forces, where the contact force is that of soft springs
/// and the block is stiff.
std::string ContactNewton::why_unbalanced(double tolerance,
                                          double residual) const {
  constexpr double most_roundings = 10.0;
  const double rounding = rounding_force() / largest_force();
  std::string note = fmt::format(
      "the nodal forces are not balanced to the tolerance of "
      "{}: {} of the largest contact force is left",
      number_text(tolerance, residual, 2), number_text(residual, tolerance, 2));
  if (most_roundings * rounding > tolerance &&
      residual <= most_roundings * rounding)
    note += fmt::format(
        "; the roundoff of the displacements of this block is a force of "
        "{:.2g} of it, so that the tolerance must be at least {:.2g}",
        rounding, most_roundings * rounding);
  return note;
}

} // namespace asperity::fem
