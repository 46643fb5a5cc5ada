#include "fem/linear/block_solver.hpp"

#include "base/require.hpp"
#include "fem/linear/assembled_block.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>

namespace asperity::fem {

BlockSolver::BlockSolver(const BlockSystem& system, LinearSolver kind,
                         std::unique_ptr<BlockInverse> inverse)
    : system_(system),
      is_automatic_(kind == LinearSolver::automatic),
      may_turn_direct_(has_mumps() && system.law() == nullptr &&
                       system.n_unknowns() <= most_unknowns_of_last_resort),
      inverse_(std::move(inverse)) {
  if (!inverse_ && kind == LinearSolver::direct)
    inverse_ = std::make_unique<DirectBlock>(system);
  else if (!inverse_)
    inverse_ = std::make_unique<AlgebraicBlock>(system);
}

std::string BlockSolver::advice() const {
  if (last_.has_converged)
    return {};
  std::string text = fmt::format(
      "; after {} iterations of {} a residual of {} N is left, which must "
      "be at most {} N",
      last_.iterations, name(),
      number_text(last_.last_residual, last_tolerance_, 2),
      number_text(last_tolerance_, last_.last_residual, 2));
  if (system_.n_unknowns() <= most_unknowns_of_last_resort)
    text += "; linear_solver must be \"direct\" for this block";
  return text;
}

double BlockSolver::memory() const {
  return dealii::Utilities::MPI::sum(static_cast<double>(inverse_->bytes()),
                                     MPI_COMM_WORLD);
}

void BlockSolver::set_contact(std::span<const double> springs,
                              const std::vector<bool>& held, bool is_sticking) {
  const bool is_same = is_set_ && is_sticking == is_sticking_ &&
                       std::ranges::equal(springs, springs_) && held == holds_;
  if (dealii::Utilities::MPI::min(is_same ? 1 : 0, MPI_COMM_WORLD) == 1)
    return;
  is_set_ = true;
  is_sticking_ = is_sticking;
  springs_.assign(springs.begin(), springs.end());
  holds_ = held;
  inverse_->prepare(springs, held, is_sticking);
  setups_ = setups_before_ + inverse_->setups();
}

bool BlockSolver::solve(Vector& unknowns, const Vector& forces,
                        double tolerance) {
  if (forces.l2_norm() == 0.0) {
    unknowns = 0.0;
    return true;
  }
  const int before_direct = is_automatic_ ? most_steps_before_direct
                                          : most_prescribed_steps_before_direct;
  last_ = inverse_->solve(unknowns, forces, tolerance,
                          may_turn_direct_ ? before_direct
                                           : most_steps_without_direct);
  last_tolerance_ = tolerance;
  iterations_ += last_.iterations;
  if (!last_.has_converged && may_turn_direct_) {
    turn_direct();
    last_ = inverse_->solve(unknowns, forces, tolerance, 0);
  }
  setups_ = setups_before_ + inverse_->setups();
  return last_.has_converged;
}

/// Replaces conjugate gradients by the direct solver, in the same contact
/// state.
void BlockSolver::turn_direct() {
  setups_before_ += inverse_->setups();
  inverse_.reset();
  inverse_ = std::make_unique<DirectBlock>(system_);
  inverse_->prepare(springs_, holds_, is_sticking_);
}

} // namespace asperity::fem
