#pragma once

// Which linear solver is used for a block. The run asks with what it finds of
// the block, the plan with what it expects of it (expected_block(), in
// fem/full_request.hpp). Does not depend on deal.II.

#include "fem/waves/moduli_field.hpp"
#include "mechanics/fem_settings.hpp"

namespace asperity::fem {

using mechanics::LinearSolver;

/// LinearSolver::automatic uses the direct solver up to this number of
/// unknowns. On several ranks a grid of boxes is never too small for multigrid.
inline constexpr double most_direct_unknowns = 500;

/// The same above a Poisson's ratio of 0.49, on one rank: multigrid may need
/// hundreds of iterations there.
inline constexpr double most_direct_stiff_unknowns = 12000;

/// The same on several ranks, where the direct solver is KLU.
inline constexpr double most_direct_stiff_unknowns_on_ranks = 2000;

/// The linear solvers of a block.
enum class BlockSolverKind {
  direct,    ///< sparse factorisation
  algebraic, ///< conjugate gradients with multigrid from the matrix
  box_grid,  ///< geometric multigrid on a grid of boxes
  halved,    ///< multigrid without a matrix on boxes that are halved from one
  hexahedra  ///< the same for other second-order hexahedra
};

/// What a mesh permits besides a matrix.
enum class MeshStructure {
  box_grid,  ///< equal columns of boxes
  halved,    ///< boxes halved from a grid of boxes, one body
  hexahedra, ///< second-order, one body or a counter-body with a mesh
  other
};

/// What the choice depends on.
struct BlockTraits {
  LinearSolver requested = LinearSolver::automatic;
  double unknowns = 0.0;
  int ranks = 1;
  MeshStructure structure = MeshStructure::other;
  bool is_compressible = true; ///< every cell, see below
  bool is_nonlinear = false;   ///< its stiffness has tangents
};

/// The linear solver of a block.
/// @throws RefusedArgument  the block is nearly incompressible and too large
///                          for the direct solver; multigrid must be requested
BlockSolverKind solver_of(const BlockTraits& block);

/// Whether multigrid without a matrix converges in few iterations: up to a
/// Poisson's ratio of 0.49.
bool is_compressible(const Moduli& moduli);

} // namespace asperity::fem
