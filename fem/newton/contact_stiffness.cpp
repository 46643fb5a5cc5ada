#include "fem/newton/contact_stiffness.hpp"

#include <deal.II/base/mpi.h>

#include <array>
#include <optional>
#include <vector>

namespace asperity::fem {
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

} // namespace asperity::fem
