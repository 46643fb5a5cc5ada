#include "fem/refined/refined_block.hpp"

#include "fem/linear/hexahedron_block.hpp"
#include "fem/linear/lattice_block.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::fem {
namespace {

/// The lattice of the coarsest cells.
std::optional<BoxLattice> coarsest_lattice(const BlockProblem& problem) {
  BlockProblem coarsest = problem;
  coarsest.mesh.refine_below.clear();
  coarsest.degree = 1;
  return box_lattice(coarsest);
}

/// The cells of this rank.
HalvedBoxes own_boxes(const BoxLattice& lattice, const BlockSystem& system) {
  std::vector<double> bottoms(lattice.thickness.size());
  std::partial_sum(lattice.thickness.begin(), lattice.thickness.end(),
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
         {static_cast<int>(centre[0] / lattice.width_x() * halves),
          static_cast<int>(centre[1] / lattice.width_y() * halves),
          static_cast<int>((static_cast<double>(layer) +
                            (centre[2] - top) / lattice.thickness[layer]) *
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

BoxMesh box_mesh_of(const BlockProblem& problem, const BlockSystem& system,
                    const LocalUnknowns& unknowns) {
  const BoxLattice lattice = *coarsest_lattice(problem);
  HalvedBoxes boxes = own_boxes(lattice, system);
  BoxMesh mesh;
  mesh.nodes = shared_nodes(unknowns.cell_nodes());
  for (const BoxCell& cell : boxes.cells)
    mesh.edges.push_back(edges_of(lattice, cell));
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
  const BoxLattice lattice = *coarsest_lattice(problem);
  const HalvedBoxes own = own_boxes(lattice, system);
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
      scaled(lattice, units), std::move(all),
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
  return !problem.counter && coarsest_lattice(problem).has_value();
}

std::unique_ptr<MatrixFreeBlock> refined_block_of(const BlockProblem& problem,
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
    return std::make_unique<MeshBlock>(system, unknowns,
                                       stiffness_of<BoxOperator>(mesh, units),
                                       correction(units));
  }
  const HexahedronMesh mesh = hexahedron_mesh(system, *unknowns);
  return std::make_unique<HexahedronBlock>(system, unknowns, mesh,
                                           correction(units_of(mesh)));
}

} // namespace asperity::fem
