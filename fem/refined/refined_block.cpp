#include "fem/refined/refined_block.hpp"

#include "fem/linear/hexahedron_block.hpp"
#include "fem/linear/lattice_block.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

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

/// The values of all ranks, in their order.
template <class Value>
std::vector<Value> of_all(RankGroup& ranks, const std::vector<Value>& own) {
  std::vector<std::size_t> counts;
  for (const double count : of_ranks(&ranks, static_cast<double>(own.size())))
    counts.push_back(static_cast<std::size_t>(count) * sizeof(Value));
  std::vector<Value> all(
      std::accumulate(counts.begin(), counts.end(), std::size_t{0}) /
      sizeof(Value));
  ranks.gather_to_all(std::as_bytes(std::span(own)), counts,
                      std::as_writable_bytes(std::span(all)));
  return all;
}

/// The contact of all ranks: the sum of their springs, and all held unknowns.
MeshContact of_all(RankGroup& ranks, const MeshContact& own) {
  struct Spring {
    std::size_t row = 0, column = 0;
    double value = 0.0;
  };

  MeshContact all;
  all.has_springs = own.has_springs;
  all.held = of_all(ranks, own.held);
  all.unknowns = of_all(ranks, own.unknowns);
  for (auto* const unknowns : {&all.held, &all.unknowns}) {
    std::ranges::sort(*unknowns);
    unknowns->erase(std::unique(unknowns->begin(), unknowns->end()),
                    unknowns->end());
  }
  std::vector<Spring> springs;
  for (std::size_t row = 0; row < own.springs.rows(); ++row)
    for (std::size_t k = own.springs.start[row]; k < own.springs.start[row + 1];
         ++k)
      springs.push_back({own.unknowns[row], own.unknowns[own.springs.column[k]],
                         own.springs.weight[k]});
  springs = of_all(ranks, springs);
  std::ranges::stable_sort(springs, {}, &Spring::row);
  auto next = springs.begin();
  for (const std::size_t row : all.unknowns) {
    for (; next != springs.end() && next->row == row; ++next) {
      all.springs.column.push_back(static_cast<std::size_t>(
          std::ranges::lower_bound(all.unknowns, next->column) -
          all.unknowns.begin()));
      all.springs.weight.push_back(next->value);
    }
    all.springs.start.push_back(all.springs.column.size());
  }
  return all;
}

/// The own nodes with an unknown that is not constrained.
std::vector<bool> free_nodes(const LocalUnknowns& unknowns) {
  std::vector<unsigned int> constrained(unknowns.size() / 3, 0);
  unknowns.constraints()->visit(
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
  mesh.unknowns = unknowns.size();
  mesh.constraints = unknowns.constraints();
  mesh.ghosts = unknowns.ghosts();
  return mesh;
}

} // namespace

RefinedCorrection::RefinedCorrection(const BlockProblem& problem,
                                     const BlockSystem& system,
                                     const LocalUnknowns& unknowns)
    : ranks_(n_ranks() > 1 ? &mpi_group() : nullptr) {
  BoxLattice lattice = *coarsest_lattice(problem);
  const HalvedBoxes own = own_boxes(lattice, system);
  HalvedBoxes all = own;
  std::size_t first = 0;
  if (ranks_ != nullptr) {
    all = {of_all(*ranks_, own.cells), of_all(*ranks_, own.moduli)};
    const std::vector<double> counts =
        of_ranks(ranks_, static_cast<double>(own.cells.size()));
    first = static_cast<std::size_t>(
        std::accumulate(counts.begin(), counts.begin() + ranks_->rank(), 0.0));
  }
  double length = lattice.length_x, modulus = 0.0;
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    length =
        std::min(length, std::ranges::min(edges_of(lattice, all.cells[i])));
    modulus = std::max(modulus, all.moduli[i].shear);
  }
  unit_ = length * modulus;
  lattice.length_x /= length;
  lattice.length_y /= length;
  for (double& thickness : lattice.thickness)
    thickness /= length;
  for (CellModuli& cell : all.moduli)
    cell = {cell.lame / modulus, cell.shear / modulus};
  const bool is_second_order = problem.degree == 2;
  cycle_ = std::make_unique<RefinedCycle>(
      lattice, std::move(all),
      NodesOfCells{unknowns.cell_nodes(), is_second_order ? 3U : 2U, own.cells,
                   unknowns.ghosts()},
      first, free_nodes(unknowns), is_second_order);
  cycle_->set_contact({}, false);
}

void RefinedCorrection::prepare(std::span<const double> /*springs*/,
                                const std::vector<bool>& /*held*/,
                                bool is_sticking, const MeshContact& contact) {
  MeshContact coarse =
      cycle_->interpolation().coarse(contact, cycle_->finest());
  for (double& spring : coarse.springs.weight)
    spring /= unit_;
  if (ranks_ != nullptr)
    coarse = of_all(*ranks_, coarse);
  cycle_->set_contact(std::move(coarse), is_sticking);
}

void RefinedCorrection::add(const std::vector<float>& residual,
                            std::vector<float>& displacement, double unit) {
  std::vector<float>& force = cycle_->force();
  std::ranges::fill(force, 0.0F);
  cycle_->interpolation().restrict_force(
      residual, static_cast<float>(unit / unit_), force);
  if (ranks_ != nullptr) {
    all_ = of_all(*ranks_, force);
    std::copy_n(all_.begin(), force.size(), force.begin());
    for (std::size_t i = force.size(); i < all_.size(); ++i)
      force[i % force.size()] += all_[i];
  }
  cycle_->run();
  cycle_->interpolation().interpolate(cycle_->displacement(), displacement);
}

std::string RefinedCorrection::name() const {
  return "first order on " + std::to_string(cycle_->levels()) +
         " coarser meshes";
}

std::size_t RefinedCorrection::bytes() const {
  return cycle_->bytes() + all_.size() * sizeof(float);
}

RefinedBlock::RefinedBlock(const BlockProblem& problem,
                           const BlockSystem& system)
    : RefinedBlock(problem, system,
                   std::make_shared<LocalUnknowns>(system.space(),
                                                   system.contact().needed())) {
}

RefinedBlock::RefinedBlock(const BlockProblem& problem,
                           const BlockSystem& system,
                           const std::shared_ptr<LocalUnknowns>& unknowns)
    : MeshBlock(
          system, unknowns, box_mesh_of(problem, system, *unknowns),
          std::make_unique<RefinedCorrection>(problem, system, *unknowns)) {}

bool is_refined_block(const BlockProblem& problem) {
  return !problem.counter && coarsest_lattice(problem).has_value();
}

std::unique_ptr<MatrixFreeBlock> refined_block_of(const BlockProblem& problem,
                                                  const BlockSystem& system) {
  if (problem.degree == 1)
    return std::make_unique<RefinedBlock>(problem, system);
  const auto unknowns = std::make_shared<LocalUnknowns>(
      system.space(), system.contact().needed());
  return std::make_unique<HexahedronBlock>(
      system, unknowns,
      std::make_unique<RefinedCorrection>(problem, system, *unknowns));
}

} // namespace asperity::fem
