#include "fem/newton/linear_step.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace asperity::fem {
namespace {

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

LinearStep::LinearStep(const BlockSystem& system, BlockSolver& solver,
                       ContactState& state)
    : system_(system),
      solver_(solver),
      state_(state),
      by_imbalance_(system.space().make_vector()),
      by_approach_(by_imbalance_),
      by_far_pressure_(by_imbalance_) {}

void LinearStep::begin(BlockWatch watch) {
  watch_ = std::move(watch);
  progress_ = {.unknowns = system_.n_unknowns()};
  iterations_before_ = solver_.iterations();
}

void LinearStep::tell_linear() {
  progress_.linear_iterations = solver_.iterations() - iterations_before_;
  if (watch_)
    watch_(progress_);
}

void LinearStep::tell(int iterations, double imbalance, int changed_points) {
  progress_.iterations = iterations;
  progress_.residual = imbalance;
  progress_.changed_points = changed_points;
  tell_linear();
}

/// The force per unit of approach, as an l2 norm over the points [N/m]. A
/// spring stiffer than the block counts with the stiffness of the block. The
/// result is infinite without springs.
double LinearStep::stiffness_of(std::span<const double> springs) const {
  double square = 0.0;
  for (std::size_t i = 0; i < springs.size(); ++i)
    square += std::pow(std::min(springs[i], state_.stiffness_scale() *
                                                system_.contact()[i].area),
                       2);
  square = dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD);
  return square > 0.0 ? std::sqrt(square)
                      : std::numeric_limits<double>::infinity();
}

/// The relative residual at which a linear solve stops.
double LinearStep::relative_tolerance(bool has_wall) const {
  const double usual =
      solver_.tightness() * (has_wall ? loose_on_wall : loose_on_springs);
  return is_careful_ ? std::min(usual, careful) : usual;
}

/// Solves answer = (K + springs)^-1 forces with the unknowns of held points
/// fixed at the given displacements. The initial guess is the content of
/// `answer`.
/// @param range  bounds on the l2 norm of the residual, in the unit of the
///               forces
bool LinearStep::solve_for(Vector& answer, const Vector& forces,
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
  tell_linear();
  answer += held;
  return true;
}

bool LinearStep::take(const mechanics::LoadTarget& load,
                      std::span<const double> springs, const ContactSet& held,
                      const StepAccuracy& accuracy) {
  const MaterialPoints* const material = state_.material();
  if (material != nullptr)
    solver_.set_tangents(material->tangents());
  const bool is_solved = solve(load, springs, held, accuracy);
  if (material != nullptr)
    solver_.set_tangents({}); // K, of which the state computes its force
  if (is_solved)
    state_.follow_displacement();
  return is_solved;
}

/// The step but for the force of the new stress.
bool LinearStep::solve(const mechanics::LoadTarget& load,
                       std::span<const double> springs, const ContactSet& held,
                       const StepAccuracy& accuracy) {
  const ContactPoints& points = system_.contact();
  is_careful_ = accuracy.is_careful;
  const bool is_load = load.control == mechanics::Control::nominal_pressure;
  if (is_load)
    state_.far_pressure = load.amount; // d is then the only scalar unknown
  solver_.set_contact(springs, held);
  state_.find_imbalance();

  constexpr double is_free = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> to_wall, with_wall, at_rest;
  if (is_any(held)) {
    to_wall.assign(points.size(), is_free);
    with_wall = at_rest = to_wall;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (held[i]) {
        to_wall[i] = -state_.gap(i);
        with_wall[i] = -1.0;
        at_rest[i] = 0.0;
      }
  }
  Vector forces(state_.imbalance);
  forces *= -1.0;
  by_imbalance_ = 0.0;
  if (!solve_for(
          by_imbalance_, forces, to_wall,
          {.finest = finest * accuracy.tolerance * state_.largest_force()}))
    return false;
  const double share = std::pow(sharpening, accuracy.refinements);
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
  return solve_scalars(load, springs, held);
}

/// Solves the two scalar equations, force balance and control, and applies the
/// step.
bool LinearStep::solve_scalars(const mechanics::LoadTarget& load,
                               std::span<const double> springs,
                               const ContactSet& held) {
  const ContactPoints& points = system_.contact();
  const std::array<Vector*, 3> responses{&by_imbalance_, &by_approach_,
                                         &by_far_pressure_};
  // For each response: the mean displacement and the contact force that it
  // causes.
  std::vector<double> sums(6, 0.0);
  std::vector<double> at_points;
  Vector reaction(state_.imbalance);
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
    now += points[i].area * state_.pressure[i] +
           (held[i] ? state_.imbalance(points[i].row.front().first) : 0.0);
  dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
  now = dealii::Utilities::MPI::sum(now, MPI_COMM_WORLD);

  Border scalars;
  scalars.force_d = sums[4];
  approach_stiffness_ = -sums[4];
  scalars.force_pressure = sums[5] - state_.area();
  scalars.force_right = state_.far_pressure * state_.area() - now - sums[3];
  if (load.control == mechanics::Control::nominal_pressure) {
    scalars.control_pressure = 1.0;
  } else {
    scalars.control_d = sums[1] / state_.area();
    scalars.control_pressure = sums[2] / state_.area();
    scalars.control_right =
        load.amount - state_.mean_gap() - sums[0] / state_.area();
  }
  const auto [approach, pressure] = scalars.solution();
  if (!std::isfinite(approach) || !std::isfinite(pressure))
    return false;
  state_.displacement += by_imbalance_;
  state_.displacement.add(approach, by_approach_, pressure, by_far_pressure_);
  state_.rigid_gap += approach;
  state_.far_pressure += pressure;
  return true;
}

} // namespace asperity::fem
