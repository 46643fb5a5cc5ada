#pragma once

// Linear solvers with the assembled stiffness matrix: factorisation, and
// conjugate gradients with algebraic multigrid.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_assembly.hpp"
#include "fem/linear/block_inverse.hpp"

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <memory>

namespace asperity::fem {

/// Whether the direct solver is MUMPS, which deadlocks at its second matrix on
/// two ranks if it is called through Amesos; else it is KLU.
bool has_mumps();

/// The matrix with its contact, and its factors.
class DirectBlock final : public BlockInverse {
public:
  /// Assembles the stiffness. @param system must outlive this object
  explicit DirectBlock(const BlockSystem& system);

  void vmult(Vector& to, const Vector& from) const override {
    system_.stiffness().vmult(to, from);
  }

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override;
  LinearSolution solve(Vector& unknowns, const Vector& forces,
                       double /*tolerance*/, int /*most_iterations*/) override;

  int setups() const override { return setups_; }

  std::string name() const override {
    return has_mumps() ? "direct (MUMPS)" : "direct (KLU)";
  }

  /// The factors are not included, because their size is not available.
  std::size_t bytes() const override;

private:
  const BlockSystem& system_;
  dealii::SolverControl control_;
  dealii::TrilinosWrappers::SparseMatrix matrix_;
  std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> factors_;
  int setups_ = 0;
};

/// Settings of Trilinos ML for a matrix on the unknowns of a block.
/// @param is_second_order  whether the matrix is that of second-order cells
dealii::TrilinosWrappers::PreconditionAMG::AdditionalData
multigrid_settings(const BlockSpace& space, bool is_second_order);

/// Algebraic multigrid (Trilinos ML) is set up for the first contact state. The
/// hierarchy is reused for later contact states while it is efficient. Nodes of
/// one body that stiff springs join to another have their relative displacement
/// as the unknown of the hierarchy (JoinedNodes). The contact of the present
/// state is applied beside the matrix, and held unknowns are masked outside of
/// the hierarchy, so a hierarchy that was set up without them remains symmetric
/// and contains no large penalty numbers.
class AlgebraicBlock final : public BlockInverse {
public:
  /// Assembles the stiffness. @param system must outlive this object
  explicit AlgebraicBlock(const BlockSystem& system);

  void vmult(Vector& to, const Vector& from) const override {
    system_.stiffness().vmult(to, from);
  }

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override;
  LinearSolution solve(Vector& unknowns, const Vector& forces, double tolerance,
                       int most_iterations) override;

  int setups() const override { return age_.setups(); }

  std::string name() const override { return "CG, multigrid (Trilinos ML)"; }

  std::size_t bytes() const override;

private:
  class Masked;
  class Operator;
  void clear_held(Vector& vector) const;
  void refresh();
  LinearSolution iterate(Vector& unknowns, const Vector& forces,
                         double tolerance, int most_steps);

  const BlockSystem& system_;
  std::vector<double> springs_;
  std::vector<dealii::types::global_dof_index> held_;
  bool has_springs_ = false;                      ///< on any rank
  dealii::TrilinosWrappers::SparseMatrix matrix_; ///< of the hierarchy
  JoinedNodes joined_;                            ///< of matrix_
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData settings_;
  /// Declared after matrix_, so destroyed first.
  dealii::TrilinosWrappers::PreconditionAMG multigrid_;
  HierarchyAge age_{5};
};

} // namespace asperity::fem
