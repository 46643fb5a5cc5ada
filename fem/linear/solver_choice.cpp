#include "fem/linear/solver_choice.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

namespace asperity::fem {

BlockSolverKind solver_of(const BlockTraits& block) {
  if (block.is_nonlinear)
    return block.structure == MeshStructure::hexahedra
               ? BlockSolverKind::hexahedra
               : BlockSolverKind::halved; // a grid of boxes has no halvings
  if (block.requested == LinearSolver::direct)
    return BlockSolverKind::direct;
  const bool is_automatic = block.requested == LinearSolver::automatic;
  const bool is_box_grid = block.structure == MeshStructure::box_grid;
  if (is_automatic && block.unknowns <= most_direct_unknowns &&
      !(is_box_grid && block.ranks > 1))
    return BlockSolverKind::direct;
  if (is_box_grid && (block.is_compressible || !is_automatic))
    return BlockSolverKind::box_grid;
  if (block.is_compressible && block.structure == MeshStructure::halved)
    return BlockSolverKind::halved;
  if (block.is_compressible && block.structure == MeshStructure::hexahedra)
    return BlockSolverKind::hexahedra;
  if (!is_automatic || block.is_compressible)
    return BlockSolverKind::algebraic;
  const double most = block.ranks == 1 ? most_direct_stiff_unknowns
                                       : most_direct_stiff_unknowns_on_ranks;
  if (block.unknowns > most)
    refuse_argument(
        Argument{"unknowns of a full block with a Poisson's ratio above 0.49",
                 "method.solver"},
        block.unknowns,
        fmt::format("at most {}, the most of the direct solver; choose solver "
                    "= \"condensed\" (layers, periodic sides), or "
                    "poisson_ratio = 0.49 with the same E*",
                    most));
  return BlockSolverKind::direct;
}

bool is_compressible(const Moduli& moduli) {
  constexpr double largest_ratio = 49.0; // that of nu = 0.49
  return moduli.lame_modulus <= largest_ratio * moduli.shear_modulus;
}

} // namespace asperity::fem
