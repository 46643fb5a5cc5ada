#include "fem/refined/refined_block.hpp"

#include "base/ranks/rank_sums.hpp"
#include "fem/linear/box_grid_block.hpp"
#include "fem/linear/hexahedron_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace asperity::fem {
namespace {

/// The grid of boxes with the moduli of the cells, all of which are its own.
BoxGrid with_moduli(BoxGrid box_grid, const HalvedBoxes& boxes) {
  const auto rows = static_cast<std::size_t>(box_grid.cells_y);
  const auto columns = static_cast<std::size_t>(box_grid.cells_x);
  box_grid.moduli.resize(boxes.cells.size());
  for (std::size_t i = 0; i < boxes.cells.size(); ++i) {
    const auto& at = boxes.cells[i].place;
    box_grid.moduli[(static_cast<std::size_t>(at[2]) * rows +
                     static_cast<std::size_t>(at[1])) *
                        columns +
                    static_cast<std::size_t>(at[0])] = boxes.moduli[i];
  }
  return box_grid;
}

/// u_x of the vertices of the cells of a grid of boxes in its vectors.
std::vector<std::uint32_t> vertices_of(const BoxGrid& box_grid,
                                       const std::vector<BoxCell>& cells) {
  const NodeLayout layout(box_grid);
  const auto wrapped = [&](int place, int nodes) {
    return box_grid.is_periodic ? place % nodes : place;
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

void add_coarser_boxes(const BoxGrid& box_grid, HalvedBoxes boxes,
                       FinestNodes finest, bool is_second_order,
                       MultigridCycle& cycle) {
  std::vector<std::uint32_t> coarse_of;
  if (is_second_order || boxes.is_box_grid()) {
    coarse_of.resize(boxes.cells.size());
    std::iota(coarse_of.begin(), coarse_of.end(), 0U);
  } else {
    boxes = merged(box_grid, boxes, coarse_of);
  }
  NodeInterpolation::Fine fine{
      finest.cells,
      std::span(coarse_of).subspan(finest.first, finest.cells.cells.size()),
      std::move(finest.is_wanted), finest.ghosts};
  std::unique_ptr<BoxLevel> level; // to which `fine` refers
  while (!boxes.is_box_grid()) {
    auto next = std::make_unique<BoxLevel>(box_grid, std::move(boxes));
    const BoxMesh& mesh = next->mesh;
    const NodesOfCells cells{*mesh.nodes, 2, next->boxes.cells};
    cycle.add_level(std::make_unique<NodeInterpolation>(std::move(fine), cells,
                                                        mesh.unknowns),
                    std::make_unique<SmoothedLevel>(
                        std::make_unique<BoxOperator<float>>(mesh),
                        diagonal_of(mesh), no_bound));
    boxes = merged(box_grid, next->boxes, coarse_of);
    fine = {cells, coarse_of, free_nodes(*next), nullptr};
    level = std::move(next);
  }
  const BoxGrid coarsest = with_moduli(box_grid, boxes);
  const BoxGridSlab all_rows(coarsest);
  const std::vector<std::uint32_t> vertices =
      vertices_of(coarsest, boxes.cells);
  cycle.add_box_grids(std::make_unique<NodeInterpolation>(
                          std::move(fine),
                          NodesOfCells{vertices, 2, boxes.cells},
                          unknowns_of(coarsest, all_rows)),
                      coarsest, all_rows);
}

namespace {

/// The grid of boxes of the coarsest cells.
std::optional<BoxGrid> coarsest_box_grid(const BlockProblem& problem) {
  BlockProblem coarsest = problem;
  coarsest.mesh.refine_below.clear();
  coarsest.degree = 1;
  return box_grid_of(coarsest);
}

/// The cells of this rank.
HalvedBoxes own_boxes(const BoxGrid& box_grid, const BlockSystem& system) {
  std::vector<double> bottoms(box_grid.thickness.size());
  std::partial_sum(box_grid.thickness.begin(), box_grid.thickness.end(),
                   bottoms.begin());
  HalvedBoxes own;
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const dealii::Point<3> centre = cell->center();
    const auto layer = static_cast<std::size_t>(
        std::ranges::lower_bound(bottoms, centre[2]) - bottoms.begin());
    const double top = layer == 0 ? 0.0 : bottoms[layer - 1];
    const int level = cell->level();
    const double halves = 1 << level;
    own.cells.push_back(
        {level,
         {static_cast<int>(centre[0] / box_grid.width_x() * halves),
          static_cast<int>(centre[1] / box_grid.width_y() * halves),
          static_cast<int>((static_cast<double>(layer) +
                            (centre[2] - top) / box_grid.thickness[layer]) *
                           halves)}});
    const Moduli moduli = system.moduli_of(cell);
    own.moduli.push_back({moduli.lame_modulus, moduli.shear_modulus});
  }
  return own;
}

/// The own nodes with an unknown that is not constrained.
std::vector<bool> free_nodes(const LocalUnknowns& unknowns) {
  std::vector<unsigned int> constrained(unknowns.size() / 3, 0);
  unknowns.layout().constraints->visit(
      [&](std::size_t unknown) { ++constrained[unknown / 3]; });
  std::vector<bool> is_free(constrained.size(), false);
  for (std::size_t node = 0; node < unknowns.owned() / 3; ++node)
    is_free[node] = constrained[node] < 3;
  return is_free;
}

/// First-order boxes.
class BoxBlock final : public MeshBlock {
public:
  using MeshBlock::MeshBlock;

  void set_tangents(std::span<const CellTangents> cells) override {
    static_cast<BoxOperator<double>&>(stiffness()).set_tangents(cells);
  }
};

BoxMesh box_mesh_of(const BlockProblem& problem, const BlockSystem& system,
                    const LocalUnknowns& unknowns) {
  const BoxGrid box_grid = *coarsest_box_grid(problem);
  HalvedBoxes boxes = own_boxes(box_grid, system);
  BoxMesh mesh;
  mesh.nodes = shared_nodes(unknowns.cell_nodes());
  for (const BoxCell& cell : boxes.cells)
    mesh.edges.push_back(edges_of(box_grid, cell));
  mesh.moduli = std::move(boxes.moduli);
  mesh.unknowns = unknowns.layout();
  return mesh;
}

} // namespace

RefinedCorrection::RefinedCorrection(const BlockProblem& problem,
                                     const BlockSystem& system,
                                     const LocalUnknowns& unknowns,
                                     const MeshUnits& units)
    : unit_(units.stiffness()) {
  const BoxGrid box_grid = *coarsest_box_grid(problem);
  const HalvedBoxes own = own_boxes(box_grid, system);
  RankGroup* const ranks = unknowns.layout().ranks();
  HalvedBoxes all{values_of_ranks(ranks, std::span(own.cells)),
                  values_of_ranks(ranks, std::span(own.moduli))};
  for (CellModuli& cell : all.moduli)
    cell = {cell.lame / units.modulus, cell.shear / units.modulus};
  const std::vector<double> counts =
      of_ranks(ranks, static_cast<double>(own.cells.size()));
  const std::size_t before = static_cast<std::size_t>(std::accumulate(
      counts.begin(), counts.begin() + (ranks == nullptr ? 0 : ranks->rank()),
      0.0));
  const bool is_second_order = problem.degree == 2;
  add_coarser_boxes(
      scaled(box_grid, units), std::move(all),
      {{unknowns.cell_nodes(), is_second_order ? 3U : 2U, own.cells},
       before,
       free_nodes(unknowns),
       unknowns.layout().ghosts.get()},
      is_second_order, cycle_);
  cycle_.set_contact({});
}

void RefinedCorrection::prepare(std::span<const double> /*springs*/,
                                const std::vector<bool>& /*held*/,
                                bool /*is_sticking*/,
                                const MeshContact& contact) {
  cycle_.set_contact(contact.in_units_of(unit_));
}

std::string RefinedCorrection::name() const {
  return "first order on " + std::to_string(cycle_.levels()) +
         " coarser meshes";
}

bool is_refined_block(const BlockProblem& problem) {
  return !problem.counter && coarsest_box_grid(problem).has_value();
}

std::unique_ptr<BlockInverse> refined_block_of(const BlockProblem& problem,
                                               const BlockSystem& system) {
  const auto unknowns = std::make_shared<LocalUnknowns>(
      system.space(), system.contact().needed());
  const auto correction = [&](const MeshUnits& units) {
    return std::make_unique<RefinedCorrection>(problem, system, *unknowns,
                                               units);
  };
  if (problem.degree == 1) {
    const BoxMesh mesh = box_mesh_of(problem, system, *unknowns);
    const MeshUnits units = units_of(mesh);
    return std::make_unique<BoxBlock>(system, unknowns,
                                      stiffness_of<BoxOperator>(mesh, units),
                                      correction(units));
  }
  const HexahedronMesh mesh = hexahedron_mesh(system, *unknowns);
  return std::make_unique<HexahedronBlock>(system, unknowns, mesh,
                                           correction(units_of(mesh)));
}

} // namespace asperity::fem
