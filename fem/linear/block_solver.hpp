#pragma once

// Linear solves with the stiffness of the block and the contribution of the
// contact.
// Include this header in .cpp files of fem/ only.

#include "fem/linear/block_inverse.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// LinearSolver::automatic replaces conjugate gradients by the direct solver if
/// a solution needs more than this number of steps, on one rank and up to this
/// number of unknowns. Prescribed ones are replaced where a solution takes
/// longer than a factorisation.
inline constexpr int most_steps_before_direct = 200;
inline constexpr int most_prescribed_steps_before_direct = 500;
inline constexpr unsigned int most_unknowns_of_last_resort = 50000;

/// Conjugate gradients end after this number of steps if no direct solver
/// follows. Flat cells beside large contrasts of moduli need a thousand.
inline constexpr int most_steps_without_direct = 3000;

/// Solves by one BlockInverse: the direct one or algebraic multigrid
/// (assembled_block.hpp), or one without a matrix (BoxGridBlock, MeshBlock).
/// Flat cells next to a large contrast of moduli can make any preconditioner
/// useless. The direct solver then goes on, if the block is not too large for
/// it.
class BlockSolver {
public:
  using Vector = BlockInverse::Vector;

  /// @param system   must outlive the solver
  /// @param kind     direct: the direct solver; others: conjugate gradients
  ///                 that may go on with it
  /// @param inverse  null: that of an assembled matrix
  BlockSolver(const BlockSystem& system, LinearSolver kind,
              std::unique_ptr<BlockInverse> inverse = {});

  /// Computes to = K from, without the contact state. This call is collective.
  void multiply(Vector& to, const Vector& from) const {
    inverse_->vmult(to, from);
  }

  /// As BlockInverse::set_tangents.
  void set_tangents(std::span<const CellTangents> cells) {
    inverse_->set_tangents(cells);
  }

  /// Lets the solutions of a block without a matrix depend on the next contact
  /// state alone, and not on those before.
  void forget() {
    is_set_ = false;
    inverse_->forget();
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
  [[nodiscard]] bool solve(Vector& unknowns, const Vector& forces,
                           double tolerance);

  /// Whether a linear solver is prescribed.
  bool is_prescribed() const { return !is_automatic_; }

  /// Factor on the relative tolerance of the systems of a Newton step.
  double tightness() const { return inverse_->tightness(); }

  int iterations() const { return iterations_; } ///< total CG iterations

  /// Factorisations or multigrid setups.
  int setups() const { return setups_; }

  std::string name() const { return inverse_->name(); }

  /// How far the last solve was from its tolerance and which linear solver to
  /// use instead; empty if it has converged.
  std::string advice() const;

  /// Memory of the matrix and the preconditioner on all ranks [bytes]. The
  /// factors of the direct solver are not included.
  double memory() const;

private:
  void turn_direct();

  const BlockSystem& system_;
  bool is_automatic_;
  bool may_turn_direct_; ///< if conjugate gradients need too many steps
  std::unique_ptr<BlockInverse> inverse_;
  // The contact state.
  bool is_set_ = false;
  std::vector<double> springs_;
  std::vector<bool> holds_; ///< whether each point is held
  bool is_sticking_ = false;
  int iterations_ = 0;
  int setups_ = 0;        ///< that a contact state has used
  int setups_before_ = 0; ///< of an inverse that the direct solver replaced
  LinearSolution last_{.has_converged = true};
  double last_tolerance_ = 0.0; ///< of its residual [N]
};

} // namespace asperity::fem
