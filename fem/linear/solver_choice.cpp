#include "fem/linear/solver_choice.hpp"

namespace asperity::fem {

BlockSolverKind solver_of(const BlockTraits& block) {
  if (block.is_plastic)
    return block.structure == MeshStructure::hexahedra
               ? BlockSolverKind::hexahedra
               : BlockSolverKind::halved; // a lattice has no halvings
  if (block.requested == LinearSolver::direct)
    return BlockSolverKind::direct;
  if (block.requested == LinearSolver::fourier)
    return block.has_fourier ? BlockSolverKind::fourier
                             : BlockSolverKind::algebraic;
  const bool is_automatic = block.requested == LinearSolver::automatic;
  const bool is_lattice = block.structure == MeshStructure::lattice;
  if (is_automatic && block.unknowns <= most_direct_unknowns &&
      !(is_lattice && block.ranks > 1))
    return BlockSolverKind::direct;
  if (is_lattice && (block.is_compressible || !is_automatic))
    return BlockSolverKind::lattice;
  if (block.is_compressible && block.structure == MeshStructure::halved)
    return BlockSolverKind::halved;
  if (block.is_compressible && block.structure == MeshStructure::hexahedra)
    return BlockSolverKind::hexahedra;
  if (!is_automatic)
    return BlockSolverKind::algebraic;
  if (block.has_fourier)
    return BlockSolverKind::fourier;
  const double most_stiff = block.ranks == 1
                                ? most_direct_stiff_unknowns
                                : most_direct_stiff_unknowns_on_ranks;
  return !block.is_compressible && block.unknowns <= most_stiff
             ? BlockSolverKind::direct
             : BlockSolverKind::algebraic;
}

bool is_compressible(const Moduli& moduli) {
  constexpr double largest_ratio = 49.0; // that of nu = 0.49
  return moduli.lame_modulus <= largest_ratio * moduli.shear_modulus;
}

} // namespace asperity::fem
