#pragma once

// Which linear solver is used for a block, and why.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/full_block.hpp"

#include <functional>

namespace asperity::fem {

/// LinearSolver::automatic uses a MatrixFreeBlock up to this ratio of Lame's
/// moduli, that of nu = 0.49; beyond, it may need too many iterations.
inline constexpr double largest_lame_ratio = 49.0;

/// LinearSolver::automatic replaces conjugate gradients by the direct solver if
/// a solution needs more than this number of steps, on one rank and up to this
/// number of unknowns.
inline constexpr unsigned int most_steps_before_direct = 200;
inline constexpr unsigned int most_unknowns_of_last_resort = 50000;

/// Conjugate gradients end after this number of steps if no direct solver
/// follows. Flat cells beside large contrasts of moduli need a thousand.
inline constexpr unsigned int most_steps_without_direct = 3000;

/// Why a linear solver is used for a block, or is not.
enum class Choice {
  requested,            ///< used: the problem requests it
  preferred,            ///< used: it is the fastest of those that can be used
  other_requested,      ///< the problem requests another
  small_block,          ///< the direct solver is faster
  unsuitable_mesh,      ///< it cannot solve on this mesh
  nearly_incompressible ///< it may need too many iterations
};

constexpr bool is_used(Choice choice) {
  return choice == Choice::requested || choice == Choice::preferred;
}

/// What a linear solver needs of a block. The functions may be expensive and
/// collective; they are called on all ranks or on none.
struct SolverNeeds {
  LinearSolver kind = LinearSolver::multigrid; ///< by which it is requested
  /// LinearSolver::automatic uses it from this number of unknowns.
  unsigned int fewest_unknowns = most_direct_unknowns + 1;
  std::function<bool()> fits_mesh = {};
  /// Whether the moduli let it converge; empty if all do.
  std::function<bool()> fits_moduli = {};
  bool ignores_moduli_if_requested = false;
};

/// @param requested  by the problem
/// @param unknowns   of the block
Choice choice_of(const SolverNeeds& needs, LinearSolver requested,
                 unsigned int unknowns);

/// Whether the direct solver is MUMPS, which deadlocks at its second matrix on
/// two ranks if it is called through Amesos; else it is KLU.
bool has_mumps();

/// Whether LinearSolver::automatic takes the direct solver if no Fourier
/// preconditioner and no solver without a matrix serves. Collective.
bool is_small(const BlockSystem& system);

/// Whether no cell exceeds largest_lame_ratio. Collective.
bool is_compressible(const BlockSystem& system);

} // namespace asperity::fem
