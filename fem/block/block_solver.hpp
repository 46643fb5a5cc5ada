#pragma once

// Linear solves with the block's stiffness and what contact adds to it: a
// direct solver for small blocks, preconditioned CG beyond.
// Include from .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <deal.II/lac/trilinos_precondition.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// Stands for the inverse of the matrix in CG: symmetric, positive definite.
class BlockPreconditioner {
public:
  virtual ~BlockPreconditioner() = default;

  /// Told of each new contact: a spring [N/m] at each point of this rank, and
  /// whether the point's unknown is held (an infinite spring). Collective.
  virtual void prepare(std::span<const double> springs,
                       const std::vector<bool>& held) = 0;

  /// Collective.
  virtual void vmult(dealii::TrilinosWrappers::MPI::Vector& to,
                     const dealii::TrilinosWrappers::MPI::Vector& from) = 0;

  virtual std::string name() const = 0;

  /// What went wrong in it since the last prepare(); empty: nothing.
  virtual std::string failure() const { return {}; }

  virtual std::size_t bytes() const = 0; ///< of memory, on this rank
};

/// How Trilinos ML is set up for a matrix on the unknowns of a block.
/// @param is_second_order  whether it is of second-order cells
dealii::TrilinosWrappers::PreconditionAMG::AdditionalData
multigrid_settings(const BlockSpace& space, bool is_second_order);

/// K + B^T diag(s) B, with the rows and columns of held unknowns cleared off
/// their diagonal. Only the direct solver writes it down; conjugate gradients
/// apply it.
///
/// Multigrid (Trilinos ML) is set up for the first contact: for the matrix
/// itself, or where the block is of second-order hexahedra for that of
/// first-order cells between the same nodes (block_assembly.hpp), which is set
/// up and swept in half the time. It is kept for the contacts that follow until
/// the iterations they took beyond those it took when new would pay for another
/// one. Held unknowns are masked around it, so a hierarchy that did not know of
/// them stays symmetric and sees no big number.
class BlockSolver {
public:
  /// @param system must outlive the solver
  /// @param own    used in place of multigrid; may be null
  BlockSolver(const BlockSystem& system, LinearSolver kind,
              std::unique_ptr<BlockPreconditioner> own = {});
  ~BlockSolver();

  /// Costs nothing where nothing has changed.
  /// @param springs  [N/m] of the contact points of this rank
  /// @param held     whether a point's only unknown is held; node-wise contact
  ///                 with one body only, else all false
  void set_contact(std::span<const double> springs,
                   const std::vector<bool>& held);

  /// Solves for `unknowns` from what it holds (zeros are cheapest where
  /// nothing is known). `forces` is zero at held unknowns; so is the answer.
  /// @param tolerance  of the residual's l2 norm [N]; of no meaning to the
  ///                   direct solver
  /// @return           false if CG gave up
  [[nodiscard]] bool solve(dealii::TrilinosWrappers::MPI::Vector& unknowns,
                           const dealii::TrilinosWrappers::MPI::Vector& forces,
                           double tolerance);

  bool is_direct() const { return is_direct_; }

  int iterations() const { return iterations_; } ///< of CG, in all

  int setups() const { return setups_; } ///< factorisations or hierarchies

  std::string name() const;

  /// Why the last solve failed.
  std::string failure() const;

  /// Matrix and preconditioner of all ranks [bytes]; of the direct solver's
  /// factors nothing is known.
  double memory() const;

private:
  struct Factors;
  class Masked;
  class Operator;
  bool is_same_contact(std::span<const double> springs,
                       const std::vector<bool>& held) const;
  void write_matrix(const dealii::TrilinosWrappers::SparseMatrix& stiffness);
  void clear_held(dealii::TrilinosWrappers::MPI::Vector& vector) const;
  void refresh_multigrid();
  bool iterate(dealii::TrilinosWrappers::MPI::Vector& unknowns,
               const dealii::TrilinosWrappers::MPI::Vector& forces,
               double tolerance, unsigned int most_steps);
  void judge(int steps, double decades);

  const BlockSystem& system_;
  bool is_direct_;
  std::unique_ptr<BlockPreconditioner> own_;
  dealii::TrilinosWrappers::SparseMatrix low_order_; ///< empty if not used
  dealii::TrilinosWrappers::SparseMatrix matrix_;    ///< what factors_ are of
  std::unique_ptr<Factors> factors_; ///< after the matrix: goes first
  // The contact.
  bool is_set_ = false;
  std::vector<double> springs_;
  std::vector<bool> holds_; ///< a point
  std::vector<dealii::types::global_dof_index> held_;
  bool has_springs_ = false;    ///< on any rank
  bool is_stale_ = true;        ///< multigrid
  bool is_new_ = false;         ///< multigrid is of this very contact
  double steps_a_decade_ = 0.0; ///< when the hierarchy was new
  double lost_steps_ = 0.0;     ///< beyond these, since
  int iterations_ = 0;
  int setups_ = 0;
};

} // namespace asperity::fem
