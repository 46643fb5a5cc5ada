#pragma once

// Predicts the cost of a full 3-D block before it is solved. This file defines
// the model of the Newton steps, the linear iterations and the memory; its
// constants are measured.

#include "app/plan/cost_model.hpp"

namespace asperity::app {

/// CPU time for loading deal.II, on the reference machine of cost_model.cpp
/// [s].
inline constexpr double fem_load_time = 0.25;

/// Factor by which a prediction for a full block may be off in either direction
/// [1]. docs/numerics/skip.md shows the spread, because the iterations depend
/// on load, contact and moduli.
inline constexpr double block_factor = 3.0;

/// Predicts the cost of a method with solver = "full". A condensed method is
/// treated as if it used the full block. The prediction is NaN if the mesh is
/// read from a file.
/// @param ranks  number of processes that share the block
MethodCost cost_of_full_block(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              const Grid& grid, MachineRates& rates,
                              int ranks = 1);

/// The linear solvers of a full block, by what they cost.
enum class BlockCostKind {
  direct,    ///< sparse factorisation
  algebraic, ///< multigrid from the matrix
  fourier,   ///< preconditioner of a lattice of boxes
  lattice,   ///< multigrid without a matrix on a lattice of boxes
  halved,    ///< the same on boxes that are halved from a lattice, one body
  hexahedra, ///< the same for other second-order hexahedra, one body
  pair       ///< the same for a block and a counter-body of finite size
};

/// Returns the linear solver that fem/ will choose for a block, by the rules of
/// docs/numerics/full-block.md.
BlockCostKind block_cost_kind(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              double unknowns, int ranks);

/// Returns the memory that deal.II and Trilinos need for any full block, in
/// addition to the memory for loading them [B].
double full_block_memory();

} // namespace asperity::app
