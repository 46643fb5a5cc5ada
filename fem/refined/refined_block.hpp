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
  /// @param unknowns  those of the system; must outlive this object
  RefinedCorrection(const BlockProblem& problem, const BlockSystem& system,
                    const LocalUnknowns& unknowns);

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking, const MeshContact& contact) override;
  void add(const std::vector<float>& residual, std::vector<float>& displacement,
           double unit) override;

  void check_efficiency(int /*iterations*/, double /*decades*/) override {}

  bool is_current() const override { return true; }

  void renew() override {}

  int setups() const override { return 1; }

  std::string name() const override;

  std::size_t bytes() const override;

private:
  RankGroup* ranks_;  ///< null if there is only one
  double unit_ = 1.0; ///< of the stiffness of the cycle [N/m]
  std::unique_ptr<RefinedCycle> cycle_;
  std::vector<float> all_; ///< forces of all ranks
};

/// The block of first-order boxes with this correction.
class RefinedBlock : public MeshBlock<BoxOperator> {
public:
  /// @param problem  whose mesh is the coarsest mesh of the system
  /// @param system   must outlive this object
  RefinedBlock(const BlockProblem& problem, const BlockSystem& system);

private:
  RefinedBlock(const BlockProblem& problem, const BlockSystem& system,
               const std::shared_ptr<LocalUnknowns>& unknowns);
};

/// Whether RefinedCorrection serves the problem: one body whose coarsest mesh
/// is a lattice of boxes.
bool is_refined_block(const BlockProblem& problem);

/// The block of a problem that is_refined_block() permits, in either order.
std::unique_ptr<MatrixFreeBlock> refined_block_of(const BlockProblem& problem,
                                                  const BlockSystem& system);

} // namespace asperity::fem
