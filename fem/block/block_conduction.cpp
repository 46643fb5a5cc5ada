#include "fem/block/block_conduction.hpp"

#include "base/special_numbers.hpp"
#include "fem/block/block_assembly.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <algorithm>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::types::global_dof_index;
using ConductionMatrix = dealii::TrilinosWrappers::SparseMatrix;

constexpr unsigned int most_conduction_iterations = 10000;

/// Of the residual, relative to that of T = 0 inside.
constexpr double conduction_tolerance = 1e-8;

/// Assembles int grad phi_a . grad phi_b dV [m] on the unknowns u_z. Those of
/// u_x and u_y keep the diagonal alone.
void assemble_laplace(const BlockSystem& system, ConductionMatrix& matrix) {
  const dealii::FESystem<3>& element = system.space().element();
  const unsigned int unknowns = element.n_dofs_per_cell();
  dealii::Table<2, bool> couples(unknowns, unknowns);
  for (unsigned int i = 0; i < unknowns; ++i)
    for (unsigned int j = 0; j < unknowns; ++j)
      couples(i, j) =
          i == j || (element.system_to_component_index(i).first == 2 &&
                     element.system_to_component_index(j).first == 2);
  CellMatrices matrices(system.space());
  dealii::FullMatrix<double> own;
  assemble(
      system,
      [&](const auto& cell) -> const auto& {
        own = matrices.of(cell, {-1.0, 1.0});
        for (unsigned int i = 0; i < unknowns; ++i)
          for (unsigned int j = 0; j < unknowns; ++j)
            if (!couples(i, j))
              own(i, j) = 0.0;
        return own;
      },
      couples, matrix);
}

/// The unknowns of this rank with a given temperature: those in contact first.
std::vector<global_dof_index> given_unknowns(const BlockSystem& system,
                                             const std::vector<bool>& touching,
                                             std::size_t& n_touching) {
  const ContactPoints& points = system.contact();
  std::vector<global_dof_index> given;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (touching[i])
      given.push_back(points[i].row.front().first);
  n_touching = given.size();
  // A pressure-loaded far boundary is not constrained.
  const BlockSpace& space = system.space();
  for (const FaceNode& node : space.face_nodes(meshes::FaceGroup::far_boundary))
    if (space.owned().is_element(node.unknowns[2]) &&
        !space.constraints().is_constrained(node.unknowns[2]))
      given.push_back(node.unknowns[2]);
  return given;
}

} // namespace

BlockConduction conduction(const BlockSystem& system,
                           const std::vector<bool>& touching, double depth) {
  if (system.has_counter())
    throw std::domain_error("the conduction of a block needs one body");
  if (dealii::Utilities::MPI::max(std::ranges::count(touching, true),
                                  MPI_COMM_WORLD) == 0)
    return {0.0, 0.0, 0, true};
  const BlockSpace& space = system.space();
  ConductionMatrix matrix;
  assemble_laplace(system, matrix);
  std::size_t n_touching = 0;
  const std::vector<global_dof_index> given =
      given_unknowns(system, touching, n_touching);
  auto unit = space.make_vector();
  for (std::size_t i = 0; i < n_touching; ++i)
    unit(given[i]) = 1.0;
  unit.compress(dealii::VectorOperation::insert);
  auto flux = space.make_vector();
  matrix.vmult(flux, unit);
  const double of_unit = unit * flux;
  auto source = flux;
  source *= -1.0;
  for (const global_dof_index unknown : given)
    source(unknown) = 0.0;
  source.compress(dealii::VectorOperation::insert);
  hold(matrix, space, given);
  dealii::TrilinosWrappers::PreconditionSSOR smoother;
  smoother.initialize(matrix);
  dealii::SolverControl control(most_conduction_iterations,
                                conduction_tolerance * source.l2_norm(), false,
                                false);
  dealii::SolverCG<dealii::TrilinosWrappers::MPI::Vector> gradients(control);
  auto temperature = space.make_vector(); // but for the unit
  BlockConduction found;
  try {
    gradients.solve(matrix, temperature, source, smoother);
    found.converged = true;
  } catch (const dealii::SolverControl::NoConvergence&) {
    found.converged = false;
  }
  found.linear_iterations = static_cast<int>(control.last_step());
  found.conductance = of_unit + temperature * flux;
  // Below roundoff of the depth there is no constriction.
  const double constriction =
      system.contact().area() / found.conductance - depth;
  found.relative = constriction > 1e-9 * depth ? 0.5 / constriction : infinity;
  return found;
}

} // namespace asperity::fem
