// The stiffness of a contact: reactions to a unit displacement of its nodes.
#include "fem/newton/contact_newton.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace asperity::fem {
namespace {

using dealii::TrilinosWrappers::MPI::Vector;

/// Relative residual of the linear solves. The reaction is an energy, whose
/// error is smaller than that of the displacement.
constexpr double stiffness_tolerance = 1e-8;

} // namespace

/// Finds the force on the touching points along `component` if they move by the
/// unit of length along it. Their other components are zero if they stick, and
/// otherwise only u_z is prescribed.
/// @param reaction  [N/m]
/// @return          false if the linear solver did not converge
bool ContactNewton::reaction_to(unsigned int component,
                                const std::vector<bool>& touching,
                                bool is_sticking, double& reaction) {
  const ContactPoints& points = system_.contact();
  solver_.set_contact(std::vector<double>(points.size(), 0.0), touching,
                      is_sticking);
  std::vector<dealii::types::global_dof_index> held, moved;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (touching[i]) {
      append_held(points[i].row.front().first, is_sticking, held);
      moved.push_back(points[i].row.front().first - 2 + component);
    }
  Vector unit = system_.space().make_vector();
  for (const auto unknown : moved)
    unit(unknown) = 1.0;
  unit.compress(dealii::VectorOperation::insert);
  Vector forces = system_.space().make_vector();
  solver_.multiply(forces, unit);
  forces *= -1.0;
  for (const auto unknown : held)
    forces(unknown) = 0.0;
  forces.compress(dealii::VectorOperation::insert);
  Vector displacement = system_.space().make_vector();
  if (!solver_.solve(displacement, forces,
                     stiffness_tolerance * forces.l2_norm()))
    return false;
  displacement += unit;
  solver_.multiply(forces, displacement);
  double sum = 0.0;
  for (const auto unknown : moved)
    sum += forces(unknown);
  reaction = dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  return true;
}

ContactStiffness ContactNewton::stiffness() {
  std::vector<bool> touching(pressure_.size());
  std::transform(pressure_.begin(), pressure_.end(), touching.begin(),
                 [](double pressure) { return pressure > 0.0; });
  ContactStiffness found;
  if (!any(touching)) {
    found.converged = true;
    return found;
  }
  const int iterations = solver_.iterations();
  double along_x = 0.0;
  double along_y = 0.0;
  found.converged = reaction_to(2, touching, false, found.normal) &&
                    reaction_to(0, touching, true, along_x) &&
                    reaction_to(1, touching, true, along_y);
  found.tangential = 0.5 * (along_x + along_y);
  found.linear_iterations = solver_.iterations() - iterations;
  return found;
}

} // namespace asperity::fem
