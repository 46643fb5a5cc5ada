#pragma once

// The interpolation from first-order functions on boxes to the nodes of finer
// ones, and what it makes of forces and contact. This file does not depend on
// deal.II.

#include "fem/multigrid/level_transfer.hpp"
#include "fem/multigrid/unknown_layout.hpp"
#include "fem/refined/mesh_plan.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace asperity::fem {

/// Cells with u_x of each of their nodes, x fastest.
struct NodesOfCells {
  std::span<const std::uint32_t> nodes;
  std::size_t in_line = 2; ///< nodes of a cell along an axis, 2 or 3
  std::span<const BoxCell> cells;

  std::size_t in_cell() const { return in_line * in_line * in_line; }
};

/// The values at the nodes of cells of the first-order functions on coarser or
/// the same cells: at vertices of first-order cells if these may be merged
/// once, and at nodes of second-order cells that are the same. All weights of a
/// node are then equal. A coarse node is held in contact if the fine node at
/// its place is. Contact on nodes of other ranks is transferred, too.
class NodeInterpolation final : public LevelTransfer {
public:
  /// The fine nodes, whose three unknowns are consecutive.
  struct Fine {
    NodesOfCells cells;
    /// Number of the coarse cell that covers each cell.
    std::span<const std::uint32_t> coarse_of;
    /// Of each node, first unknown / 3: whether it is interpolated; false for
    /// those of other ranks.
    std::vector<bool> is_wanted;
    const GhostValues* ghosts = nullptr; ///< null if this rank has all nodes
  };

  /// Collective if there are nodes of other ranks.
  /// @param unknowns  of the vertices of coarse cells
  NodeInterpolation(Fine fine, const NodesOfCells& coarse,
                    const UnknownLayout& unknowns);

  void add_interpolated(const std::vector<float>& coarse,
                        std::vector<float>& fine) override;

  std::size_t bytes() const override {
    return (nodes_.size() + start_.size() + column_.size()) *
               sizeof(std::uint32_t) +
           contact().bytes();
  }

private:
  void add_restricted(const std::vector<float>& fine,
                      std::vector<float>& coarse) override;
  void add_row(std::uint32_t node, const std::array<double, 3>& at,
               const std::uint32_t* corners);
  void add_surface_of_others(const GhostValues& ghosts, std::size_t nodes);
  void add_contact(const UnknownConstraints& constraints);

  std::size_t rows() const { return start_.size() - 1; }

  /// Nodes lie in the middle of edges, faces and cells, or at vertices.
  double weight_of(std::size_t row) const {
    return 1.0 / (start_[row + 1] - start_[row]);
  }

  std::size_t step_; ///< of the coarse unknowns
  /// u_x of each row; rows of nodes of other ranks follow without.
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> start_{0};
  std::vector<std::uint32_t> column_; ///< u_x
  /// Nodes of the contact surface and their rows.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> surface_;
};

} // namespace asperity::fem
