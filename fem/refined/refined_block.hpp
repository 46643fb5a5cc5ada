#pragma once

// Geometric multigrid for blocks whose mesh is halved from a lattice of boxes:
// hanging nodes, and meshes that follow the contact.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/linear/mesh_block.hpp"
#include "fem/refined/refined_cycle.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

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
/// is a lattice of boxes.
bool is_refined_block(const BlockProblem& problem);

/// The block of a problem that is_refined_block() permits, in either order.
/// @param problem  whose mesh is the coarsest mesh of the system
/// @param system   must outlive the result
std::unique_ptr<MatrixFreeBlock> refined_block_of(const BlockProblem& problem,
                                                  const BlockSystem& system);

} // namespace asperity::fem
