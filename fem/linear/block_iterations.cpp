// Conjugate gradients of BlockSolver and their algebraic multigrid hierarchy.

#include "fem/linear/block_solver.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {

using dealii::TrilinosWrappers::PreconditionAMG;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

PreconditionAMG::AdditionalData multigrid_settings(const BlockSpace& space,
                                                   bool is_second_order) {
  PreconditionAMG::AdditionalData settings;
  settings.elliptic = true;
  settings.higher_order_elements = is_second_order;
  settings.smoother_sweeps = 2;
  settings.aggregation_threshold = 1e-4; // 0.02 as in step-42 needs more steps
  dealii::DoFTools::extract_constant_modes(space.dof_handler(),
                                           dealii::ComponentMask(3, true),
                                           settings.constant_modes);
  return settings;
}

/// Applies a preconditioner between two projections onto the unknowns that are
/// not held.
class BlockSolver::Masked {
public:
  explicit Masked(const BlockSolver& solver) : solver_(solver) {}

  void vmult(Vector& to, const Vector& from) const {
    if (solver_.joined_.exist()) {
      Vector force(from);
      Vector displacement(from);
      solver_.joined_.multiply(force, from, true);
      solver_.factors_.multigrid.vmult(displacement, force);
      solver_.joined_.multiply(to, displacement, false);
    } else {
      solver_.factors_.multigrid.vmult(to, from);
    }
    solver_.clear_held(to);
  }

private:
  const BlockSolver& solver_;
};

/// Applies K + B^T diag(s) B to vectors that are zero at held unknowns.
class BlockSolver::Operator {
public:
  explicit Operator(const BlockSolver& solver) : solver_(solver) {}

  void vmult(Vector& to, const Vector& from) const {
    solver_.multiply(to, from);
    if (solver_.has_springs_) {
      const ContactPoints& points = solver_.system_.contact();
      points.take_displacement(from, forces_);
      for (std::size_t i = 0; i < forces_.size(); ++i)
        forces_[i] *= solver_.springs_[i];
      points.add_force(forces_, to);
    }
    solver_.clear_held(to);
  }

private:
  const BlockSolver& solver_;
  mutable std::vector<double> forces_; ///< forces on the points [N]
};

void BlockSolver::refresh_multigrid() {
  if (!is_stale_)
    return;
  factors_.multigrid.clear();
  joined_.write(system_,
                has_low_order(system_.space()) ? low_order_
                                               : system_.stiffness(),
                springs_, matrix_);
  hold(matrix_, system_.space(), held_);
  PreconditionAMG::AdditionalData settings = factors_.settings;
  joined_.clear_in(settings.constant_modes);
  factors_.multigrid.initialize(matrix_, settings);
  is_stale_ = false;
  is_new_ = true;
  steps_per_decade_ = 0.0;
  lost_steps_ = 0.0;
  ++setups_;
}

/// Decides whether the hierarchy is still efficient: it is stale as soon as the
/// accumulated excess of iterations since its setup would have paid for a new
/// one. Short solves are not counted because they are not representative.
void BlockSolver::check_efficiency(int steps, double decades) {
  constexpr int fewest_steps = 5;
  if (steps < fewest_steps || !(decades > 1.0))
    return;
  if (is_new_) {
    steps_per_decade_ = std::max(steps_per_decade_, steps / decades);
  } else {
    lost_steps_ += std::max(0.0, steps - steps_per_decade_ * decades);
    is_stale_ = lost_steps_ > setup_steps;
  }
}

bool BlockSolver::solve_iteratively(Vector& unknowns, const Vector& forces,
                                    double tolerance) {
  const unsigned int before_direct = is_automatic_
                                         ? most_steps_before_direct
                                         : most_prescribed_steps_before_direct;
  const unsigned int most_steps =
      may_turn_direct_ ? before_direct : most_steps_without_direct;
  last_tolerance_ = tolerance;
  // A hierarchy of another contact state may be useless for this one.
  constexpr unsigned int most_with_old = 100;
  if (matrix_free_) {
    last_ = matrix_free_->solve(unknowns, forces, tolerance,
                                static_cast<int>(most_steps));
    iterations_ += last_.iterations;
    setups_ = matrix_free_->setups();
    return last_.has_converged;
  }
  refresh_multigrid();
  if (!is_new_) {
    if (iterate(unknowns, forces, tolerance, most_with_old))
      return true;
    is_stale_ = true;
    refresh_multigrid();
  }
  return iterate(unknowns, forces, tolerance, most_steps);
}

bool BlockSolver::iterate(Vector& unknowns, const Vector& forces,
                          double tolerance, unsigned int most_steps) {
  dealii::SolverControl control(most_steps, tolerance, false, false);
  dealii::SolverCG<Vector> conjugate_gradients(control);
  bool has_converged = true;
  try {
    conjugate_gradients.solve(Operator(*this), unknowns, forces, Masked(*this));
  } catch (const dealii::SolverControl::NoConvergence&) {
    has_converged = false;
  }
  const int steps = static_cast<int>(control.last_step());
  iterations_ += steps;
  last_ = {has_converged, steps, control.initial_value(), control.last_value()};
  check_efficiency(steps,
                   std::log10(last_.first_residual / last_.last_residual));
  return has_converged;
}

} // namespace asperity::fem
