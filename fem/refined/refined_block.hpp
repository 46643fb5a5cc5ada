#pragma once

// Geometric multigrid for blocks whose mesh is halved from a grid of boxes:
// hanging nodes, and meshes that follow the contact.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/linear/mesh_block.hpp"
#include "fem/multigrid/multigrid_cycle.hpp"
#include "fem/refined/box_levels.hpp"
#include "fem/refined/node_interpolation.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The nodes of this rank on a mesh of halved boxes.
struct FinestNodes {
  NodesOfCells cells;          ///< of this rank
  std::size_t first = 0;       ///< number of the first among those of all ranks
  std::vector<bool> is_wanted; ///< of each node: whether it takes part
  const GhostValues* ghosts = nullptr; ///< null on one process
};

/// Appends first-order functions on coarser meshes to a cycle. Each merges all
/// cells that may merge (global coarsening), until the cells are those of the
/// grid of boxes, whose coarser grids of boxes follow. Every rank has all of
/// these meshes. Without contact, the grid of boxes may have rigid motions that
/// a pin of the mesh prevents. Collective.
/// @param grid of boxes  the coarsest cells, in units in which the stiffness
/// fits
///                 into a float; its moduli are not used
/// @param boxes    all cells of the mesh, with moduli in these units
/// @param is_second_order  whether first-order functions on the mesh itself are
///                 coarser than those of the unknowns
void add_coarser_boxes(const BoxGrid& box_grid, HalvedBoxes boxes,
                       FinestNodes finest, bool is_second_order,
                       MultigridCycle& cycle);

/// The correction by first-order functions on the coarser meshes of a block, or
/// for second-order elements on its own mesh and coarser ones. Each rank holds
/// all of these meshes and computes the same on them. Contact is transferred to
/// them, so that no mesh is made again.
class RefinedCorrection final : public MeshCorrection {
public:
  /// @param problem   whose mesh is the coarsest mesh of the system
  /// @param unknowns  those of the system, with its cells
  /// @param units     of the stiffness of the mesh
  RefinedCorrection(const BlockProblem& problem, const BlockSystem& system,
                    const LocalUnknowns& unknowns, const MeshUnits& units);

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking, const MeshContact& contact) override;

  void add(const std::vector<float>& residual, std::vector<float>& displacement,
           double /*unit*/) override {
    cycle_.add_correction(residual, displacement);
  }

  void check_efficiency(int /*iterations*/, double /*decades*/) override {}

  bool is_current() const override { return true; }

  void renew() override {}

  int setups() const override { return 1; }

  std::string name() const override;

  std::size_t bytes() const override { return cycle_.bytes(); }

private:
  double unit_; ///< of the stiffness of the cycle [N/m]
  MultigridCycle cycle_;
};

/// Whether RefinedCorrection serves the problem: one body whose coarsest mesh
/// is a grid of boxes.
bool is_refined_block(const BlockProblem& problem);

/// The block of a problem that is_refined_block() permits, in either order.
/// @param problem  whose mesh is the coarsest mesh of the system
/// @param system   must outlive the result
std::unique_ptr<BlockInverse> refined_block_of(const BlockProblem& problem,
                                               const BlockSystem& system);

} // namespace asperity::fem
