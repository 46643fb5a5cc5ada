#include "fem/linear/assembled_block.hpp"

#include "fem/parallel/ranks.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::fem {

using dealii::TrilinosWrappers::PreconditionAMG;
using dealii::TrilinosWrappers::SolverDirect;

namespace {

/// The unknowns of held contact points.
std::vector<dealii::types::global_dof_index>
held_unknowns(const BlockSystem& system, const std::vector<bool>& held,
              bool is_sticking) {
  std::vector<dealii::types::global_dof_index> unknowns;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i])
      append_held(system.contact()[i].row.front().first, is_sticking, unknowns);
  return unknowns;
}

} // namespace

void BlockInverse::set_tangents(std::span<const CellTangents> /*cells*/) {
  throw std::logic_error("only second-order hexahedra have tangents");
}

void HierarchyAge::count(int iterations, double decades) {
  if (iterations < fewest_steps_ || !(decades > 1.0))
    return;
  if (is_new_) {
    steps_per_decade_ = std::max(steps_per_decade_, iterations / decades);
  } else {
    lost_steps_ += std::max(0.0, iterations - steps_per_decade_ * decades);
    is_stale_ = lost_steps_ > setup_steps;
  }
}

bool has_mumps() {
  return n_ranks() == 1;
}

DirectBlock::DirectBlock(const BlockSystem& system) : system_(system) {
  static_cast<void>(system.stiffness()); // is assembled here
}

void DirectBlock::prepare(std::span<const double> springs,
                          const std::vector<bool>& held, bool is_sticking) {
  matrix_.copy_from(system_.stiffness());
  system_.contact().add_springs(springs, matrix_);
  hold(matrix_, system_.space(), held_unknowns(system_, held, is_sticking));
  factors_ = std::make_unique<SolverDirect>(
      control_, SolverDirect::AdditionalData(
                    false, has_mumps() ? "Amesos_Mumps" : "Amesos_Klu"));
  factors_->initialize(matrix_);
  ++setups_;
}

LinearSolution DirectBlock::solve(Vector& unknowns, const Vector& forces,
                                  double /*tolerance*/,
                                  int /*most_iterations*/) {
  factors_->solve(unknowns, forces);
  return {.has_converged = true};
}

std::size_t DirectBlock::bytes() const {
  return system_.stiffness().memory_consumption() +
         matrix_.memory_consumption();
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

AlgebraicBlock::AlgebraicBlock(const BlockSystem& system)
    : system_(system),
      settings_(multigrid_settings(system.space(),
                                   system.space().element().degree > 1)) {
  static_cast<void>(system.stiffness()); // is assembled here
}

void AlgebraicBlock::prepare(std::span<const double> springs,
                             const std::vector<bool>& held, bool is_sticking) {
  springs_.assign(springs.begin(), springs.end());
  held_ = held_unknowns(system_, held, is_sticking);
  const bool has_any =
      std::ranges::any_of(springs, [](double s) { return s != 0.0; });
  has_springs_ =
      dealii::Utilities::MPI::max(has_any ? 1 : 0, MPI_COMM_WORLD) == 1;
  age_.change_contact();
}

void AlgebraicBlock::clear_held(Vector& vector) const {
  for (const auto unknown : held_)
    vector(unknown) = 0.0;
  vector.compress(dealii::VectorOperation::insert);
}

/// Applies the hierarchy between two projections onto the unknowns that are not
/// held.
class AlgebraicBlock::Masked {
public:
  explicit Masked(const AlgebraicBlock& block) : block_(block) {}

  void vmult(Vector& to, const Vector& from) const {
    if (block_.joined_.exist()) {
      Vector force(from);
      Vector displacement(from);
      block_.joined_.multiply(force, from, true);
      block_.multigrid_.vmult(displacement, force);
      block_.joined_.multiply(to, displacement, false);
    } else {
      block_.multigrid_.vmult(to, from);
    }
    block_.clear_held(to);
  }

private:
  const AlgebraicBlock& block_;
};

/// Applies K + B^T diag(s) B to vectors that are zero at held unknowns.
class AlgebraicBlock::Operator {
public:
  explicit Operator(const AlgebraicBlock& block) : block_(block) {}

  void vmult(Vector& to, const Vector& from) const {
    block_.vmult(to, from);
    if (block_.has_springs_) {
      const ContactPoints& points = block_.system_.contact();
      points.take_displacement(from, forces_);
      for (std::size_t i = 0; i < forces_.size(); ++i)
        forces_[i] *= block_.springs_[i];
      points.add_force(forces_, to);
    }
    block_.clear_held(to);
  }

private:
  const AlgebraicBlock& block_;
  mutable std::vector<double> forces_; ///< forces on the points [N]
};

void AlgebraicBlock::refresh() {
  if (!age_.is_stale())
    return;
  multigrid_.clear();
  joined_.write(system_, system_.stiffness(), springs_, matrix_);
  hold(matrix_, system_.space(), held_);
  PreconditionAMG::AdditionalData settings = settings_;
  joined_.clear_in(settings.constant_modes);
  multigrid_.initialize(matrix_, settings);
  age_.renew();
}

LinearSolution AlgebraicBlock::solve(Vector& unknowns, const Vector& forces,
                                     double tolerance, int most_iterations) {
  // A hierarchy of another contact state may be useless for this one.
  constexpr int most_with_old = 100;
  int before = 0;
  refresh();
  if (!age_.is_new()) {
    const LinearSolution found =
        iterate(unknowns, forces, tolerance, most_with_old);
    if (found.has_converged)
      return found;
    before = found.iterations;
    age_.expire();
    refresh();
  }
  LinearSolution found = iterate(unknowns, forces, tolerance, most_iterations);
  found.iterations += before;
  return found;
}

LinearSolution AlgebraicBlock::iterate(Vector& unknowns, const Vector& forces,
                                       double tolerance, int most_steps) {
  dealii::SolverControl control(static_cast<unsigned int>(most_steps),
                                tolerance, false, false);
  dealii::SolverCG<Vector> conjugate_gradients(control);
  LinearSolution found{.has_converged = true};
  try {
    conjugate_gradients.solve(Operator(*this), unknowns, forces, Masked(*this));
  } catch (const dealii::SolverControl::NoConvergence&) {
    found.has_converged = false;
  }
  found.iterations = static_cast<int>(control.last_step());
  found.first_residual = control.initial_value();
  found.last_residual = control.last_value();
  age_.count(found.iterations,
             std::log10(found.first_residual / found.last_residual));
  return found;
}

std::size_t AlgebraicBlock::bytes() const {
  return system_.stiffness().memory_consumption() +
         matrix_.memory_consumption() + joined_.bytes() +
         (age_.is_stale() ? 0 : hierarchy_bytes(multigrid_));
}

} // namespace asperity::fem
