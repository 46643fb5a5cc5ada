#pragma once

// A whole block to be solved, as plain data: its mesh, what it is made of, how
// it is held and how its contact and its linear systems are treated.

#include "base/grid.hpp"
#include "cases/types/case.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/moduli_field.hpp"
#include "meshes/block_mesh.hpp"

#include <memory>
#include <optional>
#include <string>

namespace asperity::fem {

/// What make_full_block builds. Equal on every rank.
struct BlockProblem {
  Grid grid;              ///< of the heights and of the answer's maps
  meshes::BlockMesh mesh; ///< its contact face spans the grid's rectangle
  int degree = 1;         ///< of the shape functions, 1 or 2
  ModuliField moduli;
  cases::TopFace top = cases::TopFace::clamped;
  /// Free sides with a pressed top are refused: such a block may tilt.
  cases::BlockSides sides = cases::BlockSides::periodic;
  cases::ContactPoints contact_at = cases::ContactPoints::nodes;
  LinearSolver linear_solver = LinearSolver::automatic;

  /// The second body, if it is meshed too: the mirror image of the first below
  /// the contact face, held at its own far face as the first is.
  std::optional<cases::BodyModuli> counter = {};

  /// The laterally uniform block on the grid's lattice that the mesh is, or is
  /// near to: what LinearSolver::fourier preconditions with.
  std::optional<LayeredBlock> lattice = {};

  std::string quality = {}; ///< lines about the mesh, for report()
};

/// Builds the mesh, numbers the unknowns and assembles; collective.
/// @throws std::domain_error  a part is outside its range, periodic sides do
///                            not match, or the combination is refused
std::unique_ptr<FullBlock> make_full_block(const BlockProblem& problem);

} // namespace asperity::fem
