#include "fem/block/block_system.hpp"

#include "fem/block/block_assembly.hpp"
#include "fem/block/block_triangulation.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace asperity::fem {
namespace {

using dealii::types::global_dof_index;
using meshes::FaceGroup;

} // namespace

BlockSystem::BlockSystem(const BlockProblem& problem)
    : BlockSystem(problem, nullptr) {}

BlockSystem::BlockSystem(const BlockProblem& problem,
                         const BlockSystem& same_mesh)
    : BlockSystem(problem, same_mesh.space().shared_triangulation()) {}

BlockSystem::BlockSystem(
    const BlockProblem& problem,
    std::shared_ptr<dealii::parallel::TriangulationBase<3>> triangulation)
    : grid_(problem.grid),
      field_(problem.moduli),
      law_(problem.law),
      far_boundary_(problem.far_boundary),
      quality_(problem.quality),
      space_(problem, std::move(triangulation)),
      contact_(space_, problem) {
  if (problem.counter)
    counter_ = moduli(*problem.counter);
  integrate_far_load();
  find_face_modulus();
}

const dealii::TrilinosWrappers::SparseMatrix& BlockSystem::stiffness() const {
  if (!is_assembled_) {
    CellMatrices matrices(space_);
    assemble(
        *this,
        [&](const auto& cell) -> const auto& {
          return matrices.of(cell, moduli_of(cell));
        },
        {}, stiffness_);
    is_assembled_ = true;
  }
  return stiffness_;
}

Moduli BlockSystem::moduli_of(
    const dealii::Triangulation<3>::cell_iterator& cell) const {
  const dealii::Point<3> centre = cell->center();
  if (counter_ && centre[2] < 0.0)
    return *counter_;
  return field_.at({centre[0], centre[1], centre[2]});
}

void BlockSystem::integrate_far_load() {
  far_load_ = space_.make_vector();
  if (far_boundary_ != mechanics::FarBoundary::pressure)
    return;
  dealii::FEFaceValues<3> values(
      space_.mapping(), space_.element(), space_.face_quadrature(),
      dealii::update_values | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Scalar vertical(2);
  dealii::Vector<double> cell_load(space_.element().n_dofs_per_cell());
  std::vector<global_dof_index> unknowns(cell_load.size());
  double far_area = 0.0; // far-boundary area of the first body
  for (const auto& cell : space_.dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const double outward = cell->center()[2] < 0.0 ? -1.0 : 1.0;
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary() ||
          cell->face(f)->boundary_id() != boundary_of(FaceGroup::far_boundary))
        continue;
      values.reinit(cell, f);
      cell_load = 0.0;
      for (const unsigned int q : values.quadrature_point_indices()) {
        for (const unsigned int i : values.dof_indices())
          cell_load(i) +=
              outward * values[vertical].value(i, q) * values.JxW(q);
        if (outward > 0.0)
          far_area += values.JxW(q);
      }
      cell->get_dof_indices(unknowns);
      space_.constraints().distribute_local_to_global(cell_load, unknowns,
                                                      far_load_);
    }
  }
  far_load_.compress(dealii::VectorOperation::add);
  far_area = dealii::Utilities::MPI::sum(far_area, MPI_COMM_WORLD);
  far_load_ *= contact_.area() / far_area;
}

void BlockSystem::find_face_modulus() {
  // The softer of two bodies yields to a contact spring.
  std::array<double, 2> largest{};
  for (const auto& cell : space_.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const auto& face : cell->face_iterators())
        if (face->at_boundary() &&
            face->boundary_id() == boundary_of(FaceGroup::contact))
          largest[cell->center()[2] < 0.0 ? 1 : 0] =
              std::max(largest[cell->center()[2] < 0.0 ? 1 : 0],
                       moduli_of(cell).shear_modulus);
  for (double& modulus : largest)
    modulus = dealii::Utilities::MPI::max(modulus, MPI_COMM_WORLD);
  face_shear_modulus_ =
      counter_ ? std::min(largest[0], largest[1]) : largest[0];
}

std::string BlockSystem::report() const {
  const auto& triangulation = space_.triangulation();
  const auto n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::string text = fmt::format(
      "{} {} of order {}, {} unknowns, {} contact points, {} {}\n",
      triangulation.n_global_active_cells(),
      triangulation.all_reference_cells_are_hyper_cube() ? "hexahedra"
                                                         : "tetrahedra",
      space_.element().degree, n_unknowns(),
      dealii::Utilities::MPI::sum(contact_.size(), MPI_COMM_WORLD), n_ranks,
      n_ranks == 1 ? "rank" : "ranks");
  return text + quality_;
}

} // namespace asperity::fem
