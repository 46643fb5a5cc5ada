#include "fem/block_solver.hpp"

#include "fem/mpi_session.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <optional>

namespace asperity::fem {

using dealii::Vector;
using dealii::TrilinosWrappers::PreconditionAMG;

struct BlockSolver::Factors {
  dealii::SparseDirectUMFPACK direct;
  std::optional<PreconditionAMG> multigrid; // its constructor needs MPI
  PreconditionAMG::AdditionalData settings;
};

BlockSolver::BlockSolver(const BlockSystem& system, LinearSolver kind)
    : system_(system),
      is_direct_(kind == LinearSolver::direct ||
                 (kind == LinearSolver::automatic &&
                  system.n_unknowns() <= most_direct_unknowns)) {
  matrix_.reinit(system.sparsity());
  if (is_direct_) {
    factors_ = std::make_unique<Factors>();
    return;
  }
  start_mpi();
  factors_ = std::make_unique<Factors>();
  PreconditionAMG::AdditionalData& settings = factors_->settings;
  settings.elliptic = true;
  settings.higher_order_elements =
      system.dof_handler().get_fe().tensor_degree() > 1;
  settings.smoother_sweeps = 2;
  settings.aggregation_threshold = 1e-4; // 0.02 of step-42 needs more steps
  dealii::DoFTools::extract_constant_modes(system.dof_handler(),
                                           dealii::ComponentMask(3, true),
                                           settings.constant_modes);
}

BlockSolver::~BlockSolver() = default;

void BlockSolver::set_springs(std::span<const double> springs) {
  matrix_.copy_from(system_.stiffness());
  for (std::size_t i = 0; i < springs.size(); ++i)
    if (springs[i] > 0.0)
      matrix_.add(system_.face_unknowns()[i], system_.face_unknowns()[i],
                  springs[i]);
  if (is_direct_)
    factors_->direct.initialize(matrix_);
  else {
    factors_->multigrid.emplace();
    factors_->multigrid->initialize(matrix_, factors_->settings);
  }
}

bool BlockSolver::solve(Vector<double>& displacement,
                        const Vector<double>& force) {
  displacement = 0.0;
  const double size = force.l2_norm();
  if (size == 0.0)
    return true;
  if (is_direct_) {
    factors_->direct.vmult(displacement, force);
    return true;
  }
  dealii::SolverControl control(1000, 1e-12 * size, false, false);
  dealii::SolverCG<Vector<double>> conjugate_gradients(control);
  try {
    conjugate_gradients.solve(matrix_, displacement, force,
                              *factors_->multigrid);
  } catch (const dealii::SolverControl::NoConvergence&) {
    return false;
  }
  return true;
}

} // namespace asperity::fem
