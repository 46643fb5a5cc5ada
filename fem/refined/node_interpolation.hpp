#pragma once

// The interpolation from first-order functions on halved boxes to the nodes of
// finer ones, and what it makes of forces and contact. This file does not
// depend on deal.II.

#include "fem/hexahedra/smoothed_level.hpp"
#include "fem/refined/box_levels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace asperity::fem {

/// Cells with the first unknown of each of their nodes, x fastest.
struct NodesOfCells {
  std::span<const std::uint32_t> nodes;
  std::size_t in_line = 2; ///< nodes of a cell along an axis, 2 or 3
  std::span<const BoxCell> cells;
  /// The nodes of other ranks; null if this rank has all.
  const GhostValues* ghosts = nullptr;

  std::size_t in_cell() const { return in_line * in_line * in_line; }
};

/// The values at the nodes of cells of the first-order functions on coarser or
/// the same cells: at vertices of first-order cells if these may be merged
/// once, and at nodes of second-order cells that are the same. All weights of a
/// node are then equal.
class NodeInterpolation {
public:
  /// @param coarse_of   number of the coarse cell that covers each cell
  /// @param is_wanted   of each node, first unknown / 3: whether it is
  ///                    interpolated; false for those of other ranks
  ///
  /// Contact on nodes of other ranks is transferred, too. Collective if there
  /// are such nodes.
  NodeInterpolation(const NodesOfCells& fine, const BoxLevel& coarse,
                    std::span<const std::uint32_t> coarse_of,
                    std::vector<bool> is_wanted);

  /// Adds the forces at the nodes, times `factor`, to those of the coarse
  /// functions.
  void restrict_force(const std::vector<float>& fine, float factor,
                      std::vector<float>& coarse) const;

  /// Adds the displacement, whose constrained values must be known, to that of
  /// the nodes.
  void interpolate(const std::vector<float>& coarse,
                   std::vector<float>& fine) const;

  /// Contact of the coarse functions: springs by the Galerkin product; a node
  /// is held if the fine node at its place is. Neither contains the springs and
  /// held nodes that other ranks have.
  MeshContact coarse(const MeshContact& fine, const BoxLevel& level) const;

  std::size_t bytes() const {
    return (nodes_.size() + start_.size() + column_.size() +
            2 * surface_.size()) *
           sizeof(std::uint32_t);
  }

private:
  void add_row(std::uint32_t node, const std::array<double, 3>& at,
               const std::uint32_t* corners);
  void add_surface_of_others(const GhostValues& ghosts, std::size_t nodes);
  std::size_t row_of(std::size_t unknown) const;

  std::size_t rows() const { return start_.size() - 1; }

  /// Nodes lie in the middle of edges, faces and cells, or at vertices.
  double weight_of(std::size_t row) const {
    return 1.0 / (start_[row + 1] - start_[row]);
  }

  /// First unknown of each row; those of nodes of other ranks follow without.
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> start_{0};
  std::vector<std::uint32_t> column_; ///< first unknowns
  /// Nodes of the contact surface, increasing, and their rows.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> surface_;
};

} // namespace asperity::fem
