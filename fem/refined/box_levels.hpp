#pragma once

// Coarser and coarser meshes for a mesh of halved boxes. This file does not
// depend on deal.II.

#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/mesh_operator.hpp"
#include "fem/refined/box_flow.hpp"
#include "fem/refined/box_kernel.hpp"
#include "fem/refined/mesh_plan.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asperity::fem {

/// The first unknown of each of the nodes of each cell, x fastest, filled up to
/// whole groups of cells by zeros.
using SharedNodes = std::shared_ptr<const std::vector<std::uint32_t>>;

SharedNodes shared_nodes(std::vector<std::uint32_t> nodes);

/// Boxes with edges along the axes, those of this rank if several share the
/// block; the three unknowns of a node are consecutive.
struct BoxMesh {
  SharedNodes nodes;
  std::vector<std::array<double, 3>> edges; ///< of each cell [m]
  std::vector<CellModuli> moduli;           ///< of each cell
  UnknownLayout unknowns;
};

/// Those of all ranks. Collective.
MeshUnits units_of(const BoxMesh& mesh);

/// The mesh in these units.
BoxMesh scaled(const BoxMesh& mesh, const MeshUnits& units);

/// Diagonal of K without the terms that couple two masters of one unknown;
/// positive, and zero at constrained unknowns. Collective.
std::vector<double> diagonal_of(const BoxMesh& mesh);

/// K with isotropic linear elasticity.
template <class Number>
class BoxOperator final : public MeshOperator<Number> {
public:
  using Mesh = BoxMesh;

  explicit BoxOperator(const BoxMesh& mesh);

  /// As HexahedronOperator::set_tangents, of which a box has the first eight.
  void set_tangents(std::span<const CellTangents> cells);

  /// The nodes are counted in single precision only, because the operator in
  /// double precision shares them.
  std::size_t bytes() const override;

private:
  void add_cells(const Number* displacement, Number* force,
                 Number factor) const override;

  SharedNodes nodes_;
  std::vector<Number> boxes_;        ///< of the groups that differ
  std::vector<std::uint32_t> kinds_; ///< of each group, its place in boxes_
  std::vector<FlowingBox> flowing_;
};

extern template class BoxOperator<float>;
extern template class BoxOperator<double>;

/// Boxes that are halved from the cells of a grid of boxes, and their moduli.
struct HalvedBoxes {
  std::vector<BoxCell> cells;
  std::vector<CellModuli> moduli;

  /// Whether all cells are those of the grid of boxes.
  bool is_box_grid() const;
};

/// The boxes after merging all those that may merge.
/// @param grid of boxes    the coarsest cells; its moduli are not used
/// @param merged_in  receives the number of the new cell that covers each cell
/// @throws std::logic_error  nothing can merge
HalvedBoxes merged(const BoxGrid& box_grid, const HalvedBoxes& boxes,
                   std::vector<std::uint32_t>& merged_in);

/// The edges of a cell.
std::array<double, 3> edges_of(const BoxGrid& box_grid, const BoxCell& cell);

/// First-order functions on halved boxes with hanging nodes, periodic or free
/// sides, and the far boundary that the grid of boxes holds. Periodic images
/// are the same node. Nodes are numbered by their places, x fastest, then y and
/// z.
struct BoxLevel {
  BoxLevel(const BoxGrid& box_grid, HalvedBoxes own);

  bool is_constrained(std::size_t unknown) const;

  HalvedBoxes boxes;
  BoxMesh mesh; ///< in the units of the grid of boxes
};

} // namespace asperity::fem
