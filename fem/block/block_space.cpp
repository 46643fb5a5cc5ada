#include "fem/block/block_space.hpp"

#include "base/require.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace asperity::fem {
namespace {

using dealii::types::global_dof_index;
using meshes::FaceGroup;

/// Initialises MPI before any member needs it.
std::unique_ptr<dealii::parallel::TriangulationBase<3>>
first_of_all(const BlockProblem& problem) {
  start_mpi();
  require_between("degree", problem.degree, 1.0, 2.0, "1");
  require_positive("mesh.depth", problem.mesh.depth, "m");
  for (const double length : {problem.mesh.length_x, problem.mesh.length_y})
    require_positive("length of the mesh", length, "m");
  return make_triangulation(problem.mesh, problem.counter.has_value(),
                            problem.counter_mesh, true);
}

int axis_of(FaceGroup group) {
  switch (group) {
  case FaceGroup::left:
  case FaceGroup::right:
    return 0;
  case FaceGroup::front:
  case FaceGroup::back:
    return 1;
  default:
    return 2;
  }
}

} // namespace

BlockSpace::BlockSpace(
    const BlockProblem& problem,
    std::shared_ptr<dealii::parallel::TriangulationBase<3>> triangulation)
    : lengths_(
          {problem.mesh.length_x, problem.mesh.length_y, problem.mesh.depth}),
      counter_depth_(problem.counter_mesh ? problem.counter_mesh->depth
                                          : problem.mesh.depth),
      tolerance_(1e-6 *
                 std::min(problem.grid.spacing_x(), problem.grid.spacing_y())),
      triangulation_(triangulation ? std::move(triangulation)
                                   : first_of_all(problem)),
      dof_handler_(*triangulation_) {
  choose_element(problem.degree);
  dof_handler_.distribute_dofs(*element_);
  owned_ = dof_handler_.locally_owned_dofs();
  dealii::DoFTools::extract_locally_relevant_dofs(dof_handler_, relevant_);
  constrain(problem);
}

void BlockSpace::choose_element(int degree) {
  const auto order = static_cast<unsigned int>(degree);
  if (triangulation_->all_reference_cells_are_hyper_cube()) {
    element_ = std::make_unique<dealii::FESystem<3>>(dealii::FE_Q<3>(order), 3);
    mapping_ = std::make_unique<dealii::MappingQ1<3>>();
    in_cell_ = dealii::QGauss<3>(order + 1);
    on_face_ = dealii::QGauss<2>(order + 1);
  } else {
    element_ =
        std::make_unique<dealii::FESystem<3>>(dealii::FE_SimplexP<3>(order), 3);
    mapping_ =
        std::make_unique<dealii::MappingFE<3>>(dealii::FE_SimplexP<3>(1));
    in_cell_ = dealii::QGaussSimplex<3>(order + 1);
    on_face_ = dealii::QGaussSimplex<2>(order + 1);
  }
}

dealii::TrilinosWrappers::MPI::Vector BlockSpace::make_vector() const {
  return dealii::TrilinosWrappers::MPI::Vector(owned_, MPI_COMM_WORLD);
}

double BlockSpace::position_of(FaceGroup group, bool is_counter) const {
  switch (group) {
  case FaceGroup::right:
    return lengths_[0];
  case FaceGroup::back:
    return lengths_[1];
  case FaceGroup::far_boundary:
    return is_counter ? counter_depth_ : lengths_[2];
  default:
    return 0.0;
  }
}

std::vector<FaceNode> BlockSpace::face_nodes(FaceGroup group) const {
  const auto axis = static_cast<unsigned int>(axis_of(group));
  const auto& support = element_->get_unit_support_points();
  std::map<global_dof_index, FaceNode> nodes;
  std::vector<global_dof_index> unknowns(element_->n_dofs_per_cell());
  for (const auto& cell : dof_handler_.active_cell_iterators()) {
    if (cell->is_artificial() || !cell->at_boundary())
      continue;
    const auto faces = cell->face_iterators();
    if (std::none_of(faces.begin(), faces.end(), [&](const auto& face) {
          return face->at_boundary() &&
                 face->boundary_id() == boundary_of(group);
        }))
      continue;
    cell->get_dof_indices(unknowns);
    std::map<std::array<double, 3>, FaceNode> here;
    for (unsigned int i = 0; i < unknowns.size(); ++i) {
      const dealii::Point<3> unit = support[i];
      FaceNode& node = here[{unit[0], unit[1], unit[2]}];
      node.unknowns[element_->system_to_component_index(i).first] = unknowns[i];
      node.is_counter = cell->center()[2] < 0.0;
    }
    for (auto& [unit, node] : here) {
      node.place = mapping_->transform_unit_to_real_cell(
          cell, dealii::Point<3>(unit[0], unit[1], unit[2]));
      if (std::abs(std::abs(node.place[axis]) -
                   position_of(group, node.is_counter)) < tolerance_)
        nodes.emplace(node.unknowns[2], node);
    }
  }
  std::vector<FaceNode> list;
  list.reserve(nodes.size());
  for (const auto& entry : nodes)
    list.push_back(entry.second);
  return list;
}

std::vector<std::uint32_t> BlockSpace::cell_nodes() const {
  const auto& support = element_->get_unit_support_points();
  const unsigned int degree = element_->degree;
  std::vector<unsigned int> order(support.size() /
                                  3); // of the first components
  for (unsigned int i = 0; i < support.size(); ++i)
    if (element_->system_to_component_index(i).first == 0) {
      double place = 0.0;
      for (unsigned int axis = 3; axis-- > 0;)
        place = place * (degree + 1) + degree * support[i][axis];
      order.at(static_cast<std::size_t>(std::lround(place))) = i;
    }
  std::vector<std::uint32_t> nodes;
  std::vector<global_dof_index> unknowns(support.size());
  for (const auto& cell : dof_handler_.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(unknowns);
    for (const unsigned int i : order) {
      nodes.push_back(static_cast<std::uint32_t>(unknowns[i]));
      if (unknowns[i + 1] != unknowns[i] + 1 ||
          unknowns[i + 2] != unknowns[i] + 2)
        throw std::logic_error("the unknowns of a node are not consecutive");
    }
  }
  return nodes;
}

FaceRow BlockSpace::resolved(const FaceRow& row) const {
  std::map<global_dof_index, double> sum;
  for (const auto& [unknown, value] : row) {
    if (!constraints_.is_constrained(unknown)) {
      sum[unknown] += value;
      continue;
    }
    for (const auto& [root, share] :
         *constraints_.get_constraint_entries(unknown))
      sum[root] += value * share;
  }
  return {sum.begin(), sum.end()};
}

} // namespace asperity::fem
