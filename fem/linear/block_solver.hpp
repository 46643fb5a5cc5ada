#pragma once

// Linear solves with the stiffness matrix of the block and the contribution of
// the contact: a direct solver for small blocks and preconditioned CG for
// larger ones.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_assembly.hpp"
#include "fem/block/block_system.hpp"
#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/multigrid/conjugate_gradients.hpp"

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// LinearSolver::automatic replaces conjugate gradients by the direct solver if
/// a solution needs more than this number of steps, on one rank and up to this
/// number of unknowns. Prescribed ones are replaced where a solution takes
/// longer than a factorisation.
inline constexpr unsigned int most_steps_before_direct = 200;
inline constexpr unsigned int most_prescribed_steps_before_direct = 500;
inline constexpr unsigned int most_unknowns_of_last_resort = 50000;

/// Conjugate gradients end after this number of steps if no direct solver
/// follows. Flat cells beside large contrasts of moduli need a thousand.
inline constexpr unsigned int most_steps_without_direct = 3000;

/// Appends the unknown u_z of a held node and, if it sticks, u_x and u_y. The
/// three unknowns of a node follow each other.
template <class Unknown>
void append_held(dealii::types::global_dof_index normal, bool is_sticking,
                 std::vector<Unknown>& held) {
  for (unsigned int before = is_sticking ? 3 : 1; before-- > 0;)
    held.push_back(static_cast<Unknown>(normal - before));
}

/// Cost of a set-up of Trilinos ML in iterations of conjugate gradients.
inline constexpr double setup_steps = 20.0;

/// The stiffness of the block and its inverse without a matrix. Calls are
/// collective.
class MatrixFreeBlock {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  virtual ~MatrixFreeBlock() = default;

  /// Computes to = K from on the unconstrained unknowns.
  virtual void vmult(Vector& to, const Vector& from) const = 0;

  /// As BlockSolver::set_contact.
  virtual void prepare(std::span<const double> springs,
                       const std::vector<bool>& held, bool is_sticking) = 0;

  /// Solves with K and the contact of the last prepare(), starting from
  /// `unknowns`. Forces and unknowns are zero at held unknowns.
  virtual LinearSolution solve(Vector& unknowns, const Vector& forces,
                               double tolerance, int most_iterations) = 0;

  /// Renews at the next use what was set up for an earlier contact.
  virtual void forget() {}

  /// Replaces the moduli of some cells of this rank by tangents, and gives all
  /// others their moduli again. The preconditioner stays elastic.
  /// @param cells  in the order of the active cells of this rank, each once
  /// @throws std::logic_error  the cells are no second-order hexahedra
  virtual void set_tangents(std::span<const CellTangents> cells);

  /// Factor on the relative tolerance of the systems of a Newton step, below 1
  /// if a smaller residual costs little.
  virtual double tightness() const { return 1.0; }

  virtual int setups() const = 0; ///< so far

  virtual std::string name() const = 0;

  virtual std::size_t bytes() const = 0;
};

/// Settings of Trilinos ML for a matrix on the unknowns of a block.
/// @param is_second_order  whether the matrix is that of second-order cells
dealii::TrilinosWrappers::PreconditionAMG::AdditionalData
multigrid_settings(const BlockSpace& space, bool is_second_order);

/// Solves with K + B^T diag(s) B, in which the rows and columns of held
/// unknowns are zero except for their diagonal. Only the direct solver
/// assembles this matrix; conjugate gradients apply it matrix-free.
///
/// A block on a lattice of boxes and one of second-order hexahedra are solved
/// by multigrid without their matrix (LatticeBlock, HexahedronBlock).
///
/// Algebraic multigrid (Trilinos ML) is set up for the first contact state: for
/// the matrix itself, or for a block of second-order hexahedra for the matrix
/// of first-order cells on the same nodes (block_assembly.hpp), for which setup
/// and smoothing take half the time. The hierarchy is reused for later contact
/// states until the iterations in excess of those with the new hierarchy would
/// pay for another setup. Nodes of one body that stiff springs join to another
/// have their relative displacement as the unknown of the hierarchy
/// (JoinedNodes). Held unknowns are masked outside of the hierarchy, so
/// a hierarchy that was set up without them remains symmetric and contains no
/// large penalty numbers.
///
/// Flat cells next to a large contrast of moduli can make any of these
/// preconditioners useless. The direct solver then goes on, if the block is not
/// too large for it.
/// block_iterations.cpp implements conjugate gradients, block_solver.cpp the
/// rest.
class BlockSolver {
public:
  /// @param system       must outlive the solver
  /// @param kind         direct: the direct solver; others: conjugate gradients
  ///                     that may go on with it
  /// @param matrix_free  solves in place of all others; may be null
  BlockSolver(const BlockSystem& system, LinearSolver kind,
              std::unique_ptr<MatrixFreeBlock> matrix_free = {});

  /// Computes to = K from, without the contact state. This call is collective.
  void multiply(dealii::TrilinosWrappers::MPI::Vector& to,
                const dealii::TrilinosWrappers::MPI::Vector& from) const;

  /// As MatrixFreeBlock::set_tangents.
  void set_tangents(std::span<const CellTangents> cells) {
    matrix_free_->set_tangents(cells);
  }

  /// Lets the solutions of a block without a matrix depend on the next contact
  /// state alone, and not on those before.
  void forget() {
    is_set_ = false;
    matrix_free_->forget();
  }

  /// Sets the contact state. The call is free if nothing has changed.
  /// @param springs  springs of the contact points of this rank [N/m]
  /// @param held     whether the only unknown of a point is held; may be true
  ///                 only for contact with one body
  /// @param is_sticking  u_x and u_y of held points are held, too
  void set_contact(std::span<const double> springs,
                   const std::vector<bool>& held, bool is_sticking = false);

  /// Solves for `unknowns`, starting from the values in it (zeros are cheapest
  /// if no estimate is known). `forces` must be zero at held unknowns, and so
  /// is the solution.
  /// @param tolerance  of the l2 norm of the residual [N]; ignored by the
  ///                   direct solver
  /// @return           false if CG did not converge and is not replaced
  [[nodiscard]] bool solve(dealii::TrilinosWrappers::MPI::Vector& unknowns,
                           const dealii::TrilinosWrappers::MPI::Vector& forces,
                           double tolerance);

  bool is_direct() const { return is_direct_; }

  /// Whether a linear solver is prescribed.
  bool is_prescribed() const { return !is_automatic_; }

  /// Factor on the relative tolerance of the systems of a Newton step.
  double tightness() const {
    return matrix_free_ ? matrix_free_->tightness() : 1.0;
  }

  int iterations() const { return iterations_; } ///< total CG iterations

  int setups() const { return setups_; } ///< factorisations or multigrid setups

  std::string name() const;

  /// How far the last solve was from its tolerance and which linear solver to
  /// use instead; empty if it was none of conjugate gradients.
  std::string advice() const;

  /// Memory of the matrix and the preconditioner on all ranks [bytes]. The
  /// factors of the direct solver are not included, because their size is not
  /// available.
  double memory() const;

private:
  struct Factors {
    dealii::SolverControl control;
    std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> direct;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData settings;
  };
  class Masked;
  class Operator;
  bool is_same_contact(std::span<const double> springs,
                       const std::vector<bool>& held, bool is_sticking) const;
  void write_matrix(const dealii::TrilinosWrappers::SparseMatrix& stiffness);
  void clear_held(dealii::TrilinosWrappers::MPI::Vector& vector) const;
  bool solve_iteratively(dealii::TrilinosWrappers::MPI::Vector& unknowns,
                         const dealii::TrilinosWrappers::MPI::Vector& forces,
                         double tolerance);
  void turn_direct();
  void refresh_multigrid();
  bool iterate(dealii::TrilinosWrappers::MPI::Vector& unknowns,
               const dealii::TrilinosWrappers::MPI::Vector& forces,
               double tolerance, unsigned int most_steps);
  void check_efficiency(int steps, double decades);

  const BlockSystem& system_;
  bool is_direct_;
  bool is_automatic_;
  bool may_turn_direct_; ///< if conjugate gradients need too many steps
  std::unique_ptr<MatrixFreeBlock> matrix_free_;
  dealii::TrilinosWrappers::SparseMatrix low_order_; ///< empty if not used
  dealii::TrilinosWrappers::SparseMatrix matrix_;    ///< matrix that factors_
                                                     ///< belong to
  JoinedNodes joined_;                               ///< of matrix_
  Factors factors_; ///< declared after matrix_, so destroyed first
  // The contact state.
  bool is_set_ = false;
  std::vector<double> springs_;
  std::vector<bool> holds_; ///< whether each point is held
  bool is_sticking_ = false;
  std::vector<dealii::types::global_dof_index> held_;
  bool has_springs_ = false;      ///< on any rank
  bool is_stale_ = true;          ///< multigrid hierarchy must be set up again
  bool is_new_ = false;           ///< hierarchy is that of the current contact
  double steps_per_decade_ = 0.0; ///< CG steps per decade with a new hierarchy
  double lost_steps_ = 0.0;       ///< steps in excess of these, accumulated
  int iterations_ = 0;
  int setups_ = 0;
  LinearSolution last_;         ///< by conjugate gradients
  double last_tolerance_ = 0.0; ///< of its residual [N]
};

} // namespace asperity::fem
