#include "fem/linear/block_solver.hpp"

#include "base/require.hpp"
#include "fem/parallel/ranks.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace asperity::fem {

using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

namespace {

/// Whether the direct solver is MUMPS, which deadlocks at its second matrix on
/// two ranks if it is called through Amesos; else it is KLU.
bool has_mumps() {
  return n_ranks() == 1;
}

} // namespace

void MatrixFreeBlock::set_tangents(std::span<const CellTangents> /*cells*/) {
  throw std::logic_error("only second-order hexahedra have tangents");
}

BlockSolver::BlockSolver(const BlockSystem& system, LinearSolver kind,
                         std::unique_ptr<MatrixFreeBlock> matrix_free)
    : system_(system),
      is_direct_(kind == LinearSolver::direct),
      is_automatic_(kind == LinearSolver::automatic),
      may_turn_direct_(has_mumps() && !system.plasticity() &&
                       system.n_unknowns() <= most_unknowns_of_last_resort),
      matrix_free_(std::move(matrix_free)) {
  if (matrix_free_)
    return;
  static_cast<void>(system.stiffness()); // is assembled here
  if (is_direct_)
    return;
  const bool is_low_order = has_low_order(system.space());
  if (is_low_order)
    assemble_low_order(system, low_order_);
  factors_.settings = multigrid_settings(
      system.space(), system.space().element().degree > 1 && !is_low_order);
}

std::string BlockSolver::name() const {
  if (is_direct_)
    return has_mumps() ? "direct (MUMPS)" : "direct (KLU)";
  return matrix_free_ ? matrix_free_->name() : "CG, multigrid (Trilinos ML)";
}

void BlockSolver::multiply(Vector& to, const Vector& from) const {
  if (matrix_free_)
    matrix_free_->vmult(to, from);
  else
    system_.stiffness().vmult(to, from);
}

std::string BlockSolver::advice() const {
  if (is_direct_ || last_.has_converged)
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
  if (matrix_free_)
    return dealii::Utilities::MPI::sum(
        static_cast<double>(matrix_free_->bytes()), MPI_COMM_WORLD);
  std::size_t bytes = system_.stiffness().memory_consumption() +
                      low_order_.memory_consumption() +
                      matrix_.memory_consumption() + joined_.bytes();
  if (!is_direct_ && !is_stale_)
    bytes += hierarchy_bytes(factors_.multigrid);
  return dealii::Utilities::MPI::sum(static_cast<double>(bytes),
                                     MPI_COMM_WORLD);
}

bool BlockSolver::is_same_contact(std::span<const double> springs,
                                  const std::vector<bool>& held,
                                  bool is_sticking) const {
  const bool is_same = is_set_ && is_sticking == is_sticking_ &&
                       std::ranges::equal(springs, springs_) && held == holds_;
  return dealii::Utilities::MPI::min(is_same ? 1 : 0, MPI_COMM_WORLD) == 1;
}

void BlockSolver::clear_held(Vector& vector) const {
  for (const auto unknown : held_)
    vector(unknown) = 0.0;
  vector.compress(dealii::VectorOperation::insert);
}

/// Sets matrix_ to the stiffness with the springs added and the rows and
/// columns of held unknowns cleared.
void BlockSolver::write_matrix(const Matrix& stiffness) {
  matrix_.copy_from(stiffness);
  system_.contact().add_springs(springs_, matrix_);
  hold(matrix_, system_.space(), held_);
}

void BlockSolver::set_contact(std::span<const double> springs,
                              const std::vector<bool>& held, bool is_sticking) {
  if (is_same_contact(springs, held, is_sticking))
    return;
  is_sticking_ = is_sticking;
  is_set_ = true;
  is_new_ = false;
  springs_.assign(springs.begin(), springs.end());
  holds_ = held;
  held_.clear();
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i])
      append_held(system_.contact()[i].row.front().first, is_sticking, held_);
  const bool has_any =
      std::ranges::any_of(springs, [](double s) { return s != 0.0; });
  has_springs_ =
      dealii::Utilities::MPI::max(has_any ? 1 : 0, MPI_COMM_WORLD) == 1;
  if (is_direct_) {
    write_matrix(system_.stiffness());
    factors_.direct = std::make_unique<dealii::TrilinosWrappers::SolverDirect>(
        factors_.control,
        dealii::TrilinosWrappers::SolverDirect::AdditionalData(
            false, has_mumps() ? "Amesos_Mumps" : "Amesos_Klu"));
    factors_.direct->initialize(matrix_);
    ++setups_;
  } else if (matrix_free_) {
    matrix_free_->prepare(springs, held, is_sticking);
    setups_ = matrix_free_->setups();
  }
}

bool BlockSolver::solve(Vector& unknowns, const Vector& forces,
                        double tolerance) {
  if (forces.l2_norm() == 0.0) {
    unknowns = 0.0;
    return true;
  }
  if (is_direct_) {
    factors_.direct->solve(unknowns, forces);
    return true;
  }
  if (solve_iteratively(unknowns, forces, tolerance))
    return true;
  if (!may_turn_direct_)
    return false;
  turn_direct();
  factors_.direct->solve(unknowns, forces);
  return true;
}

/// Replaces conjugate gradients by the direct solver, in the same contact
/// state.
void BlockSolver::turn_direct() {
  is_direct_ = true;
  matrix_free_.reset();
  factors_.multigrid.clear();
  low_order_.clear();
  is_set_ = false;
  const std::vector<double> springs = springs_;
  const std::vector<bool> held = holds_;
  set_contact(springs, held, is_sticking_);
}

} // namespace asperity::fem
