#include "fem/block/block_solver.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {

using dealii::TrilinosWrappers::PreconditionAMG;
using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

namespace {

/// Whether this process runs alone. MUMPS called through Amesos deadlocks at
/// its second matrix on two ranks.
bool is_alone() {
  return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
}

} // namespace

bool is_small(const BlockSystem& system) {
  const auto n_unknowns = system.n_unknowns();
  const auto most_stiff = is_alone() ? most_direct_stiff_unknowns
                                     : most_direct_stiff_unknowns_on_ranks;
  return n_unknowns <= most_direct_unknowns ||
         (n_unknowns <= most_stiff && !is_compressible(system));
}

bool is_compressible(const BlockSystem& system) {
  double largest = 0.0;
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const Moduli own = system.moduli_of(cell);
    largest = std::max(largest, own.lame_modulus / own.shear_modulus);
  }
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD) <=
         largest_lame_ratio;
}

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

struct BlockSolver::Factors {
  dealii::SolverControl control;
  std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> direct;
  PreconditionAMG multigrid;
  PreconditionAMG::AdditionalData settings;
};

/// Applies a preconditioner between two projections onto the unknowns that are
/// not held.
class BlockSolver::Masked {
public:
  explicit Masked(const BlockSolver& solver) : solver_(solver) {}

  void vmult(Vector& to, const Vector& from) const {
    if (solver_.own_) {
      solver_.own_->vmult(to, from);
    } else if (solver_.joined_.exist()) {
      Vector force(from);
      Vector displacement(from);
      solver_.joined_.multiply(force, from, true);
      solver_.factors_->multigrid.vmult(displacement, force);
      solver_.joined_.multiply(to, displacement, false);
    } else {
      solver_.factors_->multigrid.vmult(to, from);
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

BlockSolver::BlockSolver(const BlockSystem& system, LinearSolver kind,
                         std::unique_ptr<BlockPreconditioner> own,
                         std::unique_ptr<MatrixFreeBlock> matrix_free)
    : system_(system),
      is_direct_(!matrix_free && (kind == LinearSolver::direct ||
                                  (kind == LinearSolver::automatic && !own &&
                                   is_small(system)))),
      may_turn_direct_(kind == LinearSolver::automatic && is_alone() &&
                       system.n_unknowns() <= most_unknowns_of_last_resort),
      own_(std::move(own)),
      matrix_free_(std::move(matrix_free)),
      factors_(std::make_unique<Factors>()) {
  if (matrix_free_)
    return;
  static_cast<void>(system.stiffness()); // is assembled here
  if (is_direct_ || own_)
    return;
  const bool is_low_order = has_low_order(system.space());
  if (is_low_order)
    assemble_low_order(system, low_order_);
  factors_->settings = multigrid_settings(
      system.space(), system.space().element().degree > 1 && !is_low_order);
}

BlockSolver::~BlockSolver() = default;

std::string BlockSolver::name() const {
  if (is_direct_)
    return is_alone() ? "direct (MUMPS)" : "direct (KLU)";
  if (matrix_free_)
    return matrix_free_->name();
  return own_ ? "CG, " + own_->name() : "CG, multigrid (Trilinos ML)";
}

void BlockSolver::multiply(Vector& to, const Vector& from) const {
  if (matrix_free_)
    matrix_free_->vmult(to, from);
  else
    system_.stiffness().vmult(to, from);
}

std::string BlockSolver::failure() const {
  const std::string own = own_ ? own_->failure() : "";
  return "the linear solver did not converge" + (own.empty() ? "" : ": " + own);
}

std::string BlockSolver::advice() const {
  if (is_direct_ || last_.has_converged || (own_ && !own_->failure().empty()))
    return {};
  std::string text = fmt::format(
      "; after {} iterations of {} a residual of {:.2g} N is left, which must "
      "be at most {:.2g} N",
      last_.iterations, name(), last_.last_residual, last_tolerance_);
  if (system_.n_unknowns() <= most_unknowns_of_last_resort)
    text += "; linear_solver must be \"direct\" for this block";
  return text;
}

double BlockSolver::memory() const {
  if (matrix_free_)
    return dealii::Utilities::MPI::sum(
        static_cast<double>(matrix_free_->bytes()), MPI_COMM_WORLD);
  std::size_t bytes = system_.stiffness().memory_consumption();
  if (own_) {
    bytes += own_->bytes();
  } else {
    bytes += low_order_.memory_consumption() + matrix_.memory_consumption() +
             joined_.bytes();
    if (!is_direct_ && !is_stale_)
      bytes += hierarchy_bytes(factors_->multigrid);
  }
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
    factors_->direct = std::make_unique<dealii::TrilinosWrappers::SolverDirect>(
        factors_->control,
        dealii::TrilinosWrappers::SolverDirect::AdditionalData(
            false, is_alone() ? "Amesos_Mumps" : "Amesos_Klu"));
    factors_->direct->initialize(matrix_);
    ++setups_;
  } else if (matrix_free_) {
    matrix_free_->prepare(springs, held, is_sticking);
    setups_ = matrix_free_->setups();
  } else if (own_) {
    own_->prepare(springs, held);
    ++setups_;
  }
}

void BlockSolver::refresh_multigrid() {
  if (!is_stale_)
    return;
  factors_->multigrid.clear();
  joined_.write(system_,
                has_low_order(system_.space()) ? low_order_
                                               : system_.stiffness(),
                springs_, matrix_);
  hold(matrix_, system_.space(), held_);
  PreconditionAMG::AdditionalData settings = factors_->settings;
  joined_.clear_in(settings.constant_modes);
  factors_->multigrid.initialize(matrix_, settings);
  is_stale_ = false;
  is_new_ = true;
  steps_per_decade_ = 0.0;
  lost_steps_ = 0.0;
  ++setups_;
}

/// Decides whether the hierarchy is still efficient: it is stale as soon as the
/// accumulated excess of iterations since its setup would have paid for a new
/// one. Short solves are not counted because they are not representative.
void BlockSolver::judge(int steps, double decades) {
  constexpr int fewest_steps = 5;
  if (own_ || steps < fewest_steps || !(decades > 1.0))
    return;
  if (is_new_) {
    steps_per_decade_ = std::max(steps_per_decade_, steps / decades);
  } else {
    lost_steps_ += std::max(0.0, steps - steps_per_decade_ * decades);
    is_stale_ = lost_steps_ > setup_steps;
  }
}

bool BlockSolver::solve(Vector& unknowns, const Vector& forces,
                        double tolerance) {
  if (forces.l2_norm() == 0.0) {
    unknowns = 0.0;
    return true;
  }
  if (is_direct_) {
    factors_->direct->solve(unknowns, forces);
    return true;
  }
  if (solve_iteratively(unknowns, forces, tolerance))
    return true;
  if (!may_turn_direct_)
    return false;
  turn_direct();
  factors_->direct->solve(unknowns, forces);
  return true;
}

/// Replaces conjugate gradients by the direct solver, in the same contact
/// state.
void BlockSolver::turn_direct() {
  is_direct_ = true;
  matrix_free_.reset();
  own_.reset();
  factors_->multigrid.clear();
  low_order_.clear();
  is_set_ = false;
  const std::vector<double> springs = springs_;
  const std::vector<bool> held = holds_;
  set_contact(springs, held, is_sticking_);
}

bool BlockSolver::solve_iteratively(Vector& unknowns, const Vector& forces,
                                    double tolerance) {
  const unsigned int most_steps =
      may_turn_direct_ ? most_steps_before_direct : most_steps_without_direct;
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
  if (own_)
    return iterate(unknowns, forces, tolerance, most_steps);
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
  judge(steps, std::log10(last_.first_residual / last_.last_residual));
  return has_converged;
}

} // namespace asperity::fem
