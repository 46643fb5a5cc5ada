#include "fem/refined/refined_cycle.hpp"

#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace asperity::fem {
namespace {

/// The lattice with the moduli of the cells, all of which are its own.
BoxLattice with_moduli(BoxLattice lattice, const HalvedBoxes& boxes) {
  const auto rows = static_cast<std::size_t>(lattice.cells_y);
  const auto columns = static_cast<std::size_t>(lattice.cells_x);
  lattice.moduli.resize(boxes.cells.size());
  for (std::size_t i = 0; i < boxes.cells.size(); ++i) {
    const auto& at = boxes.cells[i].place;
    lattice.moduli[(static_cast<std::size_t>(at[2]) * rows +
                    static_cast<std::size_t>(at[1])) *
                       columns +
                   static_cast<std::size_t>(at[0])] = boxes.moduli[i];
  }
  return lattice;
}

/// u_x of the vertices of the cells of a lattice in its vectors.
std::vector<std::uint32_t> vertices_of(const BoxLattice& lattice,
                                       const std::vector<BoxCell>& cells) {
  const NodeLayout layout(lattice);
  const auto wrapped = [&](int place, int nodes) {
    return lattice.is_periodic ? place % nodes : place;
  };
  std::vector<std::uint32_t> vertices;
  vertices.reserve(nodes_in_box * cells.size());
  for (const BoxCell& cell : cells)
    for (int v = 0; v < static_cast<int>(nodes_in_box); ++v)
      vertices.push_back(static_cast<std::uint32_t>(
          layout.index(wrapped(cell.place[0] + v % 2, layout.nodes_x()),
                       wrapped(cell.place[1] + v / 2 % 2, layout.nodes_y()),
                       cell.place[2] + v / 4, 0)));
  return vertices;
}

/// The nodes with an unknown that is not constrained.
std::vector<bool> free_nodes(const BoxLevel& level) {
  std::vector<bool> is_free(level.mesh.unknowns.size / 3, true);
  level.mesh.unknowns.constraints->visit([&](std::size_t unknown) {
    if (unknown % 3 == 2 && level.is_constrained(unknown - 1))
      is_free[unknown / 3] = false;
  });
  return is_free;
}

} // namespace

void add_coarser_boxes(const BoxLattice& lattice, HalvedBoxes boxes,
                       FinestNodes finest, bool is_second_order,
                       MultigridCycle& cycle) {
  std::vector<std::uint32_t> coarse_of;
  if (is_second_order || boxes.is_lattice()) {
    coarse_of.resize(boxes.cells.size());
    std::iota(coarse_of.begin(), coarse_of.end(), 0U);
  } else {
    boxes = merged(lattice, boxes, coarse_of);
  }
  NodeInterpolation::Fine fine{
      finest.cells,
      std::span(coarse_of).subspan(finest.first, finest.cells.cells.size()),
      std::move(finest.is_wanted), finest.ghosts};
  std::unique_ptr<BoxLevel> level; // to which `fine` refers
  while (!boxes.is_lattice()) {
    auto next = std::make_unique<BoxLevel>(lattice, std::move(boxes));
    const BoxMesh& mesh = next->mesh;
    const NodesOfCells cells{*mesh.nodes, 2, next->boxes.cells};
    cycle.add_level(std::make_unique<NodeInterpolation>(std::move(fine), cells,
                                                        mesh.unknowns),
                    std::make_unique<SmoothedLevel>(
                        std::make_unique<BoxOperator<float>>(mesh),
                        diagonal_of(mesh), no_bound));
    boxes = merged(lattice, next->boxes, coarse_of);
    fine = {cells, coarse_of, free_nodes(*next), nullptr};
    level = std::move(next);
  }
  const BoxLattice coarsest = with_moduli(lattice, boxes);
  const LatticeSlab all_rows(coarsest);
  const std::vector<std::uint32_t> vertices =
      vertices_of(coarsest, boxes.cells);
  cycle.add_lattices(std::make_unique<NodeInterpolation>(
                         std::move(fine),
                         NodesOfCells{vertices, 2, boxes.cells},
                         unknowns_of(coarsest, all_rows)),
                     coarsest, all_rows);
}

} // namespace asperity::fem
