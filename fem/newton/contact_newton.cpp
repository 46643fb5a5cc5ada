#include "fem/newton/contact_newton.hpp"

#include "base/require.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace asperity::fem {
namespace {

using dealii::Utilities::MPI::max;
using dealii::Utilities::MPI::sum;

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

/// Shortens the step from `before` to the present state if more points touch in
/// it than A may grow by.
void ActiveSet::shorten_step(const ContactState::Placement& before,
                             const ContactSet& active) {
  constexpr double growth = 0.25;
  constexpr int halvings = 10;
  const auto n_touching = [&](double share) {
    int touching = 0;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const double way = state_.rigid_gap - before.rigid_gap +
                         state_.face_displacement[i] -
                         before.face_displacement[i];
      touching += !active[i] && state_.gap(i) - (1.0 - share) * way < 0.0;
    }
    return sum(touching, MPI_COMM_WORLD);
  };
  const int held = n_changed(active, ContactSet(active.size(), false));
  const double most = std::max(1.0, growth * held);
  if (n_touching(1.0) <= most)
    return;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (n_touching(middle) > most ? high : low) = middle;
  }
  state_.shorten_way(before, high);
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
    std::optional<ContactState::Placement> start;
    if (!state_.is_elastic())
      start = state_.placement();
    if (!step_.take(load, no_springs, active,
                    iteration.accuracy_on_wall(steps))) {
      answer.note = "the linear solver did not converge";
      return false;
    }
    if (start)
      shorten_step(*start, active);
    take_pressure(active);
    ContactSet next = next_active(active, contact, gap_tolerance);
    const int changed = n_changed(next, active);
    const double imbalance = state_.unbalanced();
    step_.tell(answer.iterations, imbalance, changed);
    if (iteration.has_ended(changed, imbalance, state_.is_elastic()))
      return true;
    active = std::move(next);
  }
  answer.note = "the active set did not converge";
  return false;
}

namespace {

using dealii::TrilinosWrappers::MPI::Vector;

/// Relative residual of the linear solves. The reaction is an energy, whose
/// error is smaller than that of the displacement.
constexpr double stiffness_tolerance = 1e-8;

/// Returns the force [N/m] on the touching points along `component` if they
/// move by the unit of length along it; nothing if the linear solver did not
/// converge. Their other components are zero if they stick, and otherwise only
/// u_z is prescribed.
std::optional<double> reaction_to(const BlockSystem& system,
                                  BlockSolver& solver,
                                  const ContactSet& touching,
                                  unsigned int component, bool is_sticking) {
  const ContactPoints& points = system.contact();
  solver.set_contact(std::vector<double>(points.size(), 0.0), touching,
                     is_sticking);
  std::vector<dealii::types::global_dof_index> held, moved;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (touching[i]) {
      append_held(points[i].row.front().first, is_sticking, held);
      moved.push_back(points[i].row.front().first - 2 + component);
    }
  Vector unit = system.space().make_vector();
  for (const auto unknown : moved)
    unit(unknown) = 1.0;
  unit.compress(dealii::VectorOperation::insert);
  Vector forces = system.space().make_vector();
  solver.multiply(forces, unit);
  forces *= -1.0;
  for (const auto unknown : held)
    forces(unknown) = 0.0;
  forces.compress(dealii::VectorOperation::insert);
  Vector displacement = system.space().make_vector();
  if (!solver.solve(displacement, forces,
                    stiffness_tolerance * forces.l2_norm()))
    return std::nullopt;
  displacement += unit;
  solver.multiply(forces, displacement);
  double reaction = 0.0;
  for (const auto unknown : moved)
    reaction += forces(unknown);
  return dealii::Utilities::MPI::sum(reaction, MPI_COMM_WORLD);
}

} // namespace

ContactStiffness contact_stiffness(const BlockSystem& system,
                                   BlockSolver& solver,
                                   const ContactSet& touching) {
  ContactStiffness found;
  found.converged = true;
  if (!is_any(touching))
    return found;
  const int iterations = solver.iterations();
  std::array<double, 3> along{}; // z, x, y
  constexpr std::array components{2U, 0U, 1U};
  for (std::size_t k = 0; found.converged && k < components.size(); ++k) {
    const std::optional<double> reaction =
        reaction_to(system, solver, touching, components[k], k > 0);
    found.converged = reaction.has_value();
    along[k] = reaction.value_or(0.0);
  }
  found.normal = along[0];
  found.tangential = 0.5 * (along[1] + along[2]);
  found.linear_iterations = solver.iterations() - iterations;
  return found;
}

ContactNewton::ContactNewton(const BlockSystem& system,
                             LinearSolver linear_solver,
                             std::unique_ptr<BlockInverse> inverse)
    : system_(system),
      solver_(system, linear_solver, std::move(inverse)),
      state_(system, solver_),
      step_(system, solver_, state_),
      newton_(state_, step_),
      augmented_(state_, newton_),
      active_set_(state_, step_) {}

bool ContactNewton::solve_linear(std::span<const double> pressure,
                                 Vector& displacement) {
  const ContactPoints& points = system_.contact();
  std::vector<double> forces(points.size());
  double total = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i)
    total += forces[i] = points[i].area * pressure[i];
  Vector right = system_.space().make_vector();
  points.add_force(forces, right);
  right.add(-sum(total, MPI_COMM_WORLD) / state_.area(), system_.far_load());
  solver_.set_contact(std::vector<double>(points.size(), 0.0),
                      std::vector<bool>(points.size(), false));
  displacement = 0.0;
  return solver_.solve(displacement, right, 1e-12 * right.l2_norm());
}

void ContactNewton::start_from(ContactStart start) {
  state_.displacement = start.displacement;
  state_.pressure = std::move(start.pressure);
  state_.rigid_gap = start.rigid_gap;
  state_.highest = start.highest;
  state_.far_pressure = start.far_pressure;
  state_.follow_displacement();
}

std::vector<double> ContactNewton::memory() const {
  if (state_.material() == nullptr)
    return {};
  std::vector<double> numbers{
      static_cast<double>(state_.displacement.locally_owned_size()),
      static_cast<double>(state_.pressure.size()), state_.rigid_gap,
      state_.highest, carried_};
  for (const Vector* field :
       {&state_.displacement, &step_.response_to_approach()})
    numbers.insert(numbers.end(), field->begin(), field->end());
  numbers.insert(numbers.end(), state_.pressure.begin(), state_.pressure.end());
  state_.material()->save(numbers);
  return numbers;
}

bool ContactNewton::recall(std::span<const double> memory) {
  constexpr std::size_t head = 5;
  const std::size_t unknowns = state_.displacement.locally_owned_size();
  const std::size_t points = state_.pressure.size();
  const bool fits = state_.material() != nullptr &&
                    memory.size() >= head + 2 * unknowns + points &&
                    memory[0] == static_cast<double>(unknowns) &&
                    memory[1] == static_cast<double>(points);
  if (dealii::Utilities::MPI::min(fits ? 1 : 0, MPI_COMM_WORLD) == 0)
    return false;
  state_.rigid_gap = memory[2];
  state_.highest = memory[3];
  carried_ = memory[4];
  auto take = [rest = memory.subspan(head)](std::size_t count) mutable {
    const std::span<const double> taken = rest.first(count);
    rest = rest.subspan(count);
    return taken;
  };
  std::ranges::copy(take(unknowns), state_.displacement.begin());
  std::ranges::copy(take(unknowns), step_.response_to_approach().begin());
  std::ranges::copy(take(points), state_.pressure.begin());
  state_.material()->restore(memory.subspan(head + 2 * unknowns + points));
  // The set-up of the solver then belongs to the steps before.
  solver_.set_contact(std::vector<double>(points, 0.0),
                      ContactSet(points, false));
  return true;
}

/// Writes area, load, mean gap, energies and the place of the resultant force.
void ContactNewton::add_up(const BlockContact& contact,
                           BlockSolution& answer) const {
  const Grid& grid = system_.grid();
  const int middle_x = grid.points_x / 2, middle_y = grid.points_y / 2;
  const dealii::Point<2> middle(middle_x * grid.spacing_x(),
                                middle_y * grid.spacing_y());
  double touching = 0.0;
  for (std::size_t i = 0; i < state_.pressure.size(); ++i)
    touching += state_.pressure[i] > 0.0 ? system_.contact()[i].area : 0.0;
  answer.area_by_points = sum(touching, MPI_COMM_WORLD) / state_.area();
  answer.mean_gap = state_.mean_gap();
  answer.nominal_pressure = state_.borne() / state_.area();
  // Of a: w; of a p: 1, x, y, w, p.
  std::array<double, 6> sums{};
  for (std::size_t i = 0; i < state_.pressure.size(); ++i) {
    const ContactPoint& point = system_.contact()[i];
    const double force = point.area * state_.pressure[i];
    const std::array terms{point.area * state_.face_displacement[i],
                           force,
                           force * (point.place[0] - middle[0]),
                           force * (point.place[1] - middle[1]),
                           force * state_.face_displacement[i],
                           force * state_.pressure[i]};
    for (std::size_t k = 0; k < terms.size(); ++k)
      sums[k] += terms[k];
  }
  for (double& value : sums)
    value = sum(value, MPI_COMM_WORLD);
  const auto& [displacement, force, moment_x, moment_y, work, square] = sums;
  answer.elastic_energy =
      0.5 * (work - force * displacement / state_.area()) / state_.area();
  if (const MaterialPoints* const material = state_.material()) {
    answer.elastic_energy = std::numeric_limits<double>::quiet_NaN();
    answer.of_material = material->quantities();
  }
  if (!mechanics::has_wall(contact.law))
    answer.contact_energy = 0.5 * square / (contact.penalty * state_.area());
  if (force > 0.0)
    answer.pressure_centre = {moment_x / force, moment_y / force};
}

/// Hard contact, by constraints if these find it, otherwise by augmentation.
void ContactNewton::search_wall(double height_scale,
                                const mechanics::LoadTarget& load,
                                const BlockContact& contact,
                                BlockSolution& answer) {
  answer.converged = active_set_.solve(
      load, contact, contact.tolerance * height_scale, answer);
  answer.residual = state_.violation(0.0) / height_scale;
  if (answer.converged || answer.iterations >= contact.max_iterations ||
      !state_.is_elastic())
    return;
  const std::string why = answer.note;
  answer.note.clear();
  augmented_.solve(load, contact, height_scale, answer);
  answer.note =
      why + (answer.note.empty() ? "; solved by the augmented Lagrangian"
                                 : "; augmented Lagrangian: " + answer.note);
}

void ContactNewton::search(double height_scale,
                           const mechanics::LoadTarget& load,
                           const BlockContact& contact, BlockSolution& answer) {
  const bool is_gap = load.control == mechanics::Control::mean_gap;
  if (is_gap && load.amount < 0.0 && mechanics::has_wall(contact.law)) {
    answer.note = fmt::format("the mean gap of the contact points is {:.3g} m, "
                              "but must be >= 0 m where nothing overlaps",
                              load.amount);
  } else if (is_gap && load.amount >= state_.touching_mean_gap()) {
    state_.leave_contact();
    answer.converged = true;
  } else if (mechanics::traits_of(contact.law).block_solver ==
             mechanics::BlockSolver::wall) {
    std::ranges::fill(state_.multiplier, 0.0);
    search_wall(height_scale, load, contact, answer);
  } else {
    augmented_.solve(load, contact, height_scale, answer);
  }
  if (answer.converged && !is_any(contact_set(state_.pressure)))
    state_.lift_off(load.amount);
  if (!answer.converged && newton_.has_linear_failure())
    answer.note += solver_.advice();
}

/// Finds the contact at a load, first with the inelastic strain of the last
/// part of the loading path, and with the material law from there. Returns
/// whether it is found.
bool ContactNewton::search_part(double height_scale, double nominal_pressure,
                                const BlockContact& contact,
                                BlockSolution& answer) {
  const mechanics::LoadTarget load{mechanics::Control::nominal_pressure,
                                   nominal_pressure};
  answer.converged = false;
  answer.note.clear();
  state_.material()->freeze(true);
  state_.follow_displacement();
  search(height_scale, load, contact, answer);
  state_.material()->freeze(false);
  if (!answer.converged)
    return false;
  state_.follow_displacement();
  if (state_.is_elastic())
    return true;
  answer.converged = false;
  newton_.begin();
  search(height_scale, load, contact, answer);
  return answer.converged;
}

/// Goes from the load of the last step to that of this one. A part of the way
/// that is not found, because the material changes too much in it, is taken in
/// two halves.
void ContactNewton::search_material(double height_scale,
                                    const mechanics::LoadTarget& load,
                                    const BlockContact& contact,
                                    BlockSolution& answer) {
  constexpr double smallest_part = 1.0 / 64.0;
  solver_.forget(); // so that a run that is resumed has the same bits
  const double start = carried_;
  const double way = load.amount - start;
  double done = 0.0;
  double part = 1.0;
  while (done < 1.0 && answer.iterations < contact.max_iterations) {
    const ContactState::Placement placement = state_.placement();
    const std::vector<double> pressure = state_.pressure;
    const double next =
        done + part < 1.0 ? start + (done + part) * way : load.amount;
    if (search_part(height_scale, next, contact, answer)) {
      state_.material()->end_step();
      carried_ = next;
      done += part;
      continue;
    }
    if (part <= smallest_part)
      return;
    part *= 0.5;
    state_.return_to(placement);
    state_.pressure = pressure;
  }
}

void ContactNewton::solve(std::vector<double> heights, double height_scale,
                          const mechanics::LoadTarget& load,
                          const BlockContact& contact, BlockSolution& answer) {
  state_.take_heights(std::move(heights));
  const int iterations = solver_.iterations();
  const int setups = solver_.setups();
  const std::string solver = solver_.name();
  step_.begin(contact.watch);
  newton_.begin();
  if (state_.material() != nullptr)
    search_material(height_scale, load, contact, answer);
  else
    search(height_scale, load, contact, answer);
  add_up(contact, answer);
  answer.linear_iterations = solver_.iterations() - iterations;
  answer.preconditioner_setups = solver_.setups() - setups;
  answer.linear_solver = solver_.name();
  answer.memory = solver_.memory();
  if (answer.linear_solver != solver && solver_.is_prescribed())
    answer.note += fmt::format(
        "{}{} has not converged in {} iterations; the linear solver is now {}",
        answer.note.empty() ? "" : "; ", solver,
        most_prescribed_steps_before_direct, answer.linear_solver);
  judge(contact.tolerance, answer);
}

/// Whether what the iterations call converged is balanced and finite.
void ContactNewton::judge(double tolerance, BlockSolution& answer) {
  answer.residual = larger_residual(answer.residual, state_.unbalanced());
  // Sums propagate a NaN or an infinity of any point.
  if (!std::isfinite(answer.mean_gap) ||
      !std::isfinite(answer.nominal_pressure)) {
    answer.residual = std::numeric_limits<double>::infinity();
    answer.converged = false;
    answer.note = "a gap or a pressure is not a finite number";
  }
  if (answer.converged && !(answer.residual <= tolerance)) {
    answer.converged = false;
    answer.note = why_unbalanced(tolerance, answer.residual);
  }
}

/// The note of a step whose forces are not balanced. The tolerance may be below
/// the roundoff of the forces, where the contact force is that of soft springs
/// and the block is stiff.
std::string ContactNewton::why_unbalanced(double tolerance,
                                          double residual) const {
  constexpr double most_roundings = 10.0;
  const double rounding = state_.rounding_force() / state_.largest_force();
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
