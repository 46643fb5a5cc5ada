#include "fem/adaptive/mesh_change.hpp"

#include "fem/block/block_triangulation.hpp"
#include "fem/block/place_map.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <stdexcept>

namespace asperity::fem {
namespace {

using meshes::FaceGroup;

/// The centre of the cell's face in a group, without the coordinate along which
/// the two sides differ; the cell need not have such a face.
std::optional<dealii::Point<3>>
face_centre(const MeshChange::Mesh::active_cell_iterator& cell, FaceGroup group,
            unsigned int axis) {
  for (const auto& face : cell->face_iterators())
    if (face->at_boundary() && face->boundary_id() == boundary_of(group)) {
      dealii::Point<3> centre = face->center();
      centre[axis] = 0.0;
      return centre;
    }
  return {};
}

} // namespace

MeshChange::MeshChange(const BlockProblem& problem, Mesh& mesh,
                       const std::vector<CellChange>& changes)
    : problem_(problem), mesh_(mesh) {
  for (const auto& cell : mesh_.active_cell_iterators()) {
    cell->clear_refine_flag();
    cell->clear_coarsen_flag();
    const CellChange change = changes.at(cell->active_cell_index());
    if (change == CellChange::refine)
      cell->set_refine_flag();
    else if (change == CellChange::coarsen)
      cell->set_coarsen_flag();
  }
  if (problem.sides == mechanics::BlockSides::periodic)
    find_pairs();
  do
    mesh_.prepare_coarsening_and_refinement();
  while (make_pairs_equal());
}

void MeshChange::find_pairs() {
  const double tolerance =
      1e-6 * std::min(problem_.grid.spacing_x(), problem_.grid.spacing_y());
  std::vector<Cell> cells;
  for (const auto& cell : mesh_.active_cell_iterators())
    cells.push_back(cell);
  const auto pair_up = [&](FaceGroup low, FaceGroup high, unsigned int axis) {
    PlaceMap places(tolerance);
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (const auto centre = face_centre(cells[i], low, axis))
        places.insert(*centre, i);
    for (const Cell& cell : cells)
      if (const auto centre = face_centre(cell, high, axis)) {
        const auto partner = places.find(*centre);
        if (!partner)
          throw std::logic_error("the periodic sides of the mesh differ");
        pairs_.emplace_back(cells[*partner], cell);
      }
  };
  pair_up(FaceGroup::left, FaceGroup::right, 0);
  pair_up(FaceGroup::front, FaceGroup::back, 1);
}

/// Lets both cells of a pair refine if one does, and none coarsen unless both
/// do. Returns whether a flag has changed.
bool MeshChange::make_pairs_equal() {
  bool has_changed = false;
  for (const auto& [one, other] : pairs_) {
    if (one->refine_flag_set() != other->refine_flag_set()) {
      for (const Cell& cell : {one, other}) {
        cell->clear_coarsen_flag();
        cell->set_refine_flag();
      }
      has_changed = true;
    }
    if (one->coarsen_flag_set() != other->coarsen_flag_set()) {
      one->clear_coarsen_flag();
      other->clear_coarsen_flag();
      has_changed = true;
    }
  }
  return has_changed;
}

ChangedCells MeshChange::count() const {
  ChangedCells changed;
  for (const auto& cell : mesh_.active_cell_iterators()) {
    changed.refined += cell->refine_flag_set() ? 1 : 0;
    changed.coarsened += cell->coarsen_flag_set() ? 1 : 0;
  }
  return changed;
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
  Vector before(unknowns.locally_owned_dofs(), MPI_COMM_WORLD);
  before = displacement;
  dealii::parallel::distributed::SolutionTransfer<3, Vector> transfer(unknowns);
  transfer.prepare_for_coarsening_and_refinement(before);
  before_change();
  mesh_.execute_coarsening_and_refinement();
  unknowns.distribute_dofs(element);
  Vector after(unknowns.locally_owned_dofs(), MPI_COMM_WORLD);
  transfer.interpolate(after);
  return after;
}

} // namespace asperity::fem
