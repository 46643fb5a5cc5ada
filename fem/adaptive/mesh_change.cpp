#include "fem/adaptive/mesh_change.hpp"

#include "fem/block/all_ranks.hpp"

#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::fem {
namespace {

/// Finds the places of the cells of a mesh of layers of boxes. The columns are
/// equal, the layers need not be.
class BoxCells {
public:
  BoxCells(const BlockProblem& problem, const MeshChange::Mesh& mesh)
      : lengths_({problem.mesh.length_x, problem.mesh.length_y}),
        planes_(planes_of(mesh, same_depth * problem.mesh.depth)) {
    const dealii::BoundingBox<3> box = mesh.begin(0)->bounding_box();
    for (unsigned int i = 0; i < 2; ++i)
      coarsest_.at(i) =
          static_cast<int>(std::lround(lengths_.at(i) / box.side_length(i)));
    coarsest_[2] = static_cast<int>(planes_.size()) - 1;
  }

  const std::array<int, 3>& coarsest() const { return coarsest_; }

  BoxCell of(const dealii::Triangulation<3>::cell_iterator& cell) const {
    BoxCell found{cell->level(), {}};
    const dealii::Point<3> centre = cell->center();
    for (unsigned int i = 0; i < 2; ++i)
      found.place.at(i) = static_cast<int>(centre[i] / lengths_.at(i) *
                                           (coarsest_.at(i) << found.level));
    const auto below =
        std::upper_bound(planes_.begin() + 1, planes_.end() - 1, centre[2]);
    const double above = *(below - 1);
    found.place[2] =
        (static_cast<int>(below - planes_.begin() - 1) << found.level) +
        static_cast<int>((centre[2] - above) / (*below - above) *
                         (1 << found.level));
    return found;
  }

private:
  /// Roundoff of the depth of a vertex, relative to the depth of the block.
  static constexpr double same_depth = 1e-12;

  /// Depths of the planes between the layers of the coarsest cells, which every
  /// rank knows [m].
  static std::vector<double> planes_of(const MeshChange::Mesh& mesh,
                                       double tolerance) {
    std::vector<double> planes;
    for (const auto& cell : mesh.cell_iterators_on_level(0)) {
      const dealii::BoundingBox<3> box = cell->bounding_box();
      planes.push_back(box.lower_bound(2));
      planes.push_back(box.upper_bound(2));
    }
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end(),
                             [tolerance](double a, double b) {
                               return b - a < tolerance;
                             }),
                 planes.end());
    return planes;
  }

  std::array<double, 2> lengths_;
  std::vector<double> planes_;
  std::array<int, 3> coarsest_{};
};

/// The cells of all ranks and what is to become of them.
std::vector<MeshPlan::Wish> wishes(const BoxCells& boxes,
                                   const MeshChange::Mesh& mesh,
                                   const std::vector<CellChange>& changes) {
  std::vector<int> own; // five numbers for each cell
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const BoxCell box = boxes.of(cell);
    own.insert(own.end(),
               {box.level, box.place[0], box.place[1], box.place[2],
                static_cast<int>(changes.at(cell->active_cell_index()))});
  }
  std::vector<MeshPlan::Wish> all;
  all.reserve(mesh.n_global_active_cells());
  const std::vector<int> cells = of_all_ranks(own);
  for (std::size_t i = 0; i < cells.size(); i += 5)
    all.push_back({{cells[i], {cells[i + 1], cells[i + 2], cells[i + 3]}},
                   static_cast<CellChange>(cells[i + 4])});
  return all;
}

} // namespace

MeshChange::MeshChange(const BlockProblem& problem, Mesh& mesh,
                       const std::vector<CellChange>& changes)
    : problem_(problem),
      mesh_(mesh),
      plan_(BoxCells(problem, mesh).coarsest(),
            problem.sides == mechanics::BlockSides::periodic,
            wishes(BoxCells(problem, mesh), mesh, changes)) {
  const BoxCells boxes(problem, mesh);
  for (const auto& cell : mesh_.active_cell_iterators()) {
    cell->clear_refine_flag();
    cell->clear_coarsen_flag();
    const CellChange change = plan_.change_of(boxes.of(cell));
    if (change == CellChange::refine)
      cell->set_refine_flag();
    else if (change == CellChange::coarsen)
      cell->set_coarsen_flag();
  }
}

MeshChange::Vector
MeshChange::execute(const Vector& displacement,
                    const std::function<void()>& before_change) {
  // The unknowns of this numbering are those of BlockSpace, because element and
  // mesh are equal.
  const dealii::FESystem<3> element(
      dealii::FE_Q<3>(static_cast<unsigned int>(problem_.degree)), 3);
  dealii::DoFHandler<3> unknowns(mesh_);
  unknowns.distribute_dofs(element);
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(unknowns, relevant);
  Vector before(unknowns.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
  before = displacement;
  dealii::parallel::distributed::SolutionTransfer<3, Vector> transfer(unknowns);
  transfer.prepare_for_coarsening_and_refinement(before);
  before_change();
  mesh_.execute_coarsening_and_refinement();
  if (mesh_.n_global_active_cells() != plan_.cells_after())
    throw std::logic_error("the mesh differs from the one that was planned");
  unknowns.distribute_dofs(element);
  Vector after(unknowns.locally_owned_dofs(), MPI_COMM_WORLD);
  transfer.interpolate(after);
  return after;
}

} // namespace asperity::fem
