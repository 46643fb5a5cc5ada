#pragma once

// A multigrid cycle over the coarser meshes of halved boxes, which ends on the
// lattice of the coarsest cells. This file does not depend on deal.II.

#include "fem/hexahedra/smoothed_level.hpp"
#include "fem/multigrid/multigrid_cycle.hpp"
#include "fem/refined/node_interpolation.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace asperity::fem {

/// Approximates (K + S)^-1 on the unknowns of a mesh of halved boxes by
/// first-order functions on coarser meshes. Each merges all cells that may
/// merge (global coarsening), until the cells are those of the lattice, whose
/// own cycle goes on. Smoother and treatment of contact are those of
/// MultigridCycle. Without contact, the lattice may have rigid motions that a
/// pin of the mesh prevents.
class RefinedCycle {
public:
  /// @param lattice  the coarsest cells, in units in which the stiffness fits
  ///                 into a float; its moduli are not used
  /// @param boxes    all cells of the mesh, with moduli in these units
  /// @param own      cells with the unknowns that the cycle serves, among them:
  ///                 from number `first` on
  /// @param is_wanted  of each node of these unknowns: whether it takes part
  /// @param is_second_order  whether first-order functions on the mesh itself
  ///                 are coarser than those of the unknowns
  RefinedCycle(const BoxLattice& lattice, HalvedBoxes boxes,
               const NodesOfCells& own, std::size_t first,
               std::vector<bool> is_wanted, bool is_second_order);
  ~RefinedCycle();

  /// From the unknowns to the finest mesh of the cycle.
  const NodeInterpolation& interpolation() const { return interpolations_[0]; }

  /// The finest mesh of the cycle.
  const BoxLevel& finest() const { return *finest_; }

  /// Transfers contact to all meshes.
  /// @param contact  of the finest mesh, springs in the unit of the stiffness
  void set_contact(MeshContact contact, bool is_sticking);

  /// The force on the finest mesh, to be written before run(), including what
  /// acts on constrained unknowns; overwritten by it.
  std::vector<float>& force();

  /// The displacement after run(), with its constrained values.
  const std::vector<float>& displacement() const;

  void run() { descend(0); }

  std::size_t levels() const; ///< coarser than the unknowns

  std::size_t bytes() const;

private:
  struct Level;
  struct Coarsest;

  void descend(std::size_t level);
  std::vector<float>& force_of(std::size_t level);

  /// interpolations_[i] leads from level i to the next finer one, and
  /// interpolations_[0] to the unknowns.
  std::vector<NodeInterpolation> interpolations_;
  std::vector<std::unique_ptr<Level>> levels_; ///< all but the lattice
  std::unique_ptr<Coarsest> coarsest_;
  const BoxLevel* finest_ = nullptr;
};

} // namespace asperity::fem
