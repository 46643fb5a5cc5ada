#pragma once

// Coarser and coarser meshes for a mesh of halved boxes, and the interpolation
// from one to the other. This file does not depend on deal.II.

#include "fem/multigrid/smoothed_level.hpp"
#include "fem/refined/box_operator.hpp"
#include "fem/refined/mesh_plan.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace asperity::fem {

/// Boxes that are halved from the cells of a lattice, and their moduli.
struct HalvedBoxes {
  std::vector<BoxCell> cells;
  std::vector<CellModuli> moduli;

  /// Whether all cells are those of the lattice.
  bool is_lattice() const;
};

/// The boxes after merging all those that may merge.
/// @param lattice    the coarsest cells; its moduli are not used
/// @param merged_in  receives the number of the new cell that covers each cell
/// @throws std::logic_error  nothing can merge
HalvedBoxes merged(const BoxLattice& lattice, const HalvedBoxes& boxes,
                   std::vector<std::uint32_t>& merged_in);

/// The edges of a cell.
std::array<double, 3> edges_of(const BoxLattice& lattice, const BoxCell& cell);

/// First-order functions on halved boxes with hanging nodes, periodic or free
/// sides, and the far boundary that the lattice holds. Periodic images are the
/// same node. Nodes are numbered by their places, x fastest, then y and z.
struct BoxLevel {
  BoxLevel(const BoxLattice& lattice, HalvedBoxes own);

  bool is_constrained(std::size_t unknown) const;

  HalvedBoxes boxes;
  BoxMesh mesh; ///< in the units of the lattice
};

/// Cells with the first unknown of each of their nodes, x fastest.
struct NodesOfCells {
  std::span<const std::uint32_t> nodes;
  std::size_t in_line = 2; ///< nodes of a cell along an axis, 2 or 3
  std::span<const BoxCell> cells;

  std::size_t in_cell() const { return in_line * in_line * in_line; }
};

/// The values at the nodes of cells of the first-order functions on coarser or
/// the same cells.
class NodeInterpolation {
public:
  /// @param coarse_of   number of the coarse cell that covers each cell
  /// @param is_wanted   of each node, first unknown / 3: whether it is
  ///                    interpolated
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
  /// is held if the fine node at its place is. Neither contains what only other
  /// ranks know.
  MeshContact coarse(const MeshContact& fine, const BoxLevel& level) const;

  std::size_t bytes() const {
    return (nodes_.size() + start_.size() + column_.size()) *
               sizeof(std::uint32_t) +
           weight_.size() * sizeof(float);
  }

private:
  void add_row(std::uint32_t node, const std::array<double, 3>& at,
               const std::array<std::uint32_t, nodes_in_box>& corners);
  std::size_t row_of(std::size_t unknown) const;

  std::vector<std::uint32_t> nodes_; ///< first unknown of each row
  std::vector<std::uint32_t> start_{0};
  std::vector<std::uint32_t> column_; ///< first unknowns
  std::vector<float> weight_;
  /// Nodes of the contact surface, increasing, and their rows.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> surface_;
};

} // namespace asperity::fem
