#include "fem/linear/hexahedron_block.hpp"

#include "fem/linear/assembled_block.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace asperity::fem {
namespace {

/// The share of the vertex v = 0..7 of a cell in the node = 0..26.
double weight_of(unsigned int v, std::size_t node) {
  double weight = 1.0;
  for (unsigned int axis = 0; axis < 3; ++axis, node /= 3) {
    const double place = 0.5 * static_cast<double>(node % 3);
    weight *= (v >> axis & 1U) == 1 ? place : 1.0 - place;
  }
  return weight;
}

BlockProblem first_order(const BlockProblem& problem) {
  BlockProblem coarse = problem;
  coarse.degree = 1;
  return coarse;
}

} // namespace

HexahedronMesh hexahedron_mesh(const BlockSystem& system,
                               const LocalUnknowns& unknowns) {
  HexahedronMesh mesh;
  mesh.unknowns = unknowns.layout();
  auto first = unknowns.cell_nodes().begin();
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    std::copy_n(first, nodes_in_hexahedron, mesh.nodes.emplace_back().begin());
    first += nodes_in_hexahedron;
    auto& vertices = mesh.vertices.emplace_back();
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int i = 0; i < 3; ++i)
        vertices.at(v).at(i) = cell->vertex(v)[i];
    const Moduli moduli = system.moduli_of(cell);
    mesh.moduli.push_back({moduli.lame_modulus, moduli.shear_modulus});
  }
  return mesh;
}

FirstOrderCorrection::FirstOrderCorrection(const BlockProblem& problem,
                                           const BlockSystem& fine,
                                           const LocalUnknowns& unknowns)
    : coarse_(first_order(problem), fine),
      numbers_(coarse_.space(), coarse_.space().owned()),
      force_(coarse_.space().make_vector()),
      displacement_(force_),
      values_(numbers_.size()) {
  find_parents(unknowns);
  find_points(fine, unknowns);
  coarse_.also_reserve(points_);
  find_rigid_modes();
  numbers_.forget_cells();
}

/// Finds the vertices from which each second-order node is interpolated.
void FirstOrderCorrection::find_parents(const LocalUnknowns& unknowns) {
  const std::vector<std::uint32_t>& vertices = numbers_.cell_nodes();
  const std::vector<std::uint32_t>& nodes = unknowns.cell_nodes();
  std::vector<bool> is_known(unknowns.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] >= unknowns.owned() || is_known[nodes[i]])
      continue;
    is_known[nodes[i]] = true;
    nodes_.push_back(nodes[i]);
    for (unsigned int v = 0; v < 8; ++v)
      if (const double weight = weight_of(v, i % nodes_in_hexahedron);
          weight > 0.0) {
        parents_.column.push_back(vertices[i / nodes_in_hexahedron * 8 + v]);
        parents_.weight.push_back(weight);
      }
    parents_.start.push_back(parents_.column.size());
  }
}

/// Writes the rows of contact nodes in first-order unknowns: those of the
/// vertices that a node of this rank is interpolated from.
void FirstOrderCorrection::find_points(const BlockSystem& fine,
                                       const LocalUnknowns& unknowns) {
  std::vector<std::size_t> row_of(unknowns.owned() / 3);
  for (std::size_t row = 0; row < nodes_.size(); ++row)
    row_of[nodes_[row] / 3] = row;
  const std::vector<Unknown> global = numbers_.global();
  for (std::size_t i = 0; i < fine.contact().size(); ++i) {
    const ContactPoint& point = fine.contact()[i];
    const std::size_t own = unknowns.of(point.row.front().first);
    const std::size_t row = row_of[own / 3];
    FaceRow coarse;
    for (std::size_t k = parents_.start[row]; k < parents_.start[row + 1]; ++k)
      coarse.emplace_back(global[parents_.column[k]] + own % 3,
                          parents_.weight[k]);
    add_point(point.place, coarse_.space().resolved(coarse));
    vertices_.emplace_back();
    if (coarse.size() != 1 ||
        coarse_.space().constraints().is_constrained(coarse.front().first))
      continue;
    vertices_.back() = coarse.front().first;
    if (!coarse_.space().owned().is_element(*vertices_.back()))
      throw std::logic_error("the owners of a node and its vertex differ");
  }
}

/// The faces of a second body carry first-order functions, too, whose values
/// are those that its second-order functions interpolate.
void FirstOrderCorrection::add_point(const dealii::Point<2>& place,
                                     FaceRow row) {
  static_cast<void>(coarse_.contact().add_counter(place, row));
  points_.push_back(std::move(row));
}

/// Computes the rigid motions of the block, the near null space of the matrix:
/// three translations and three rotations, one after the other.
void FirstOrderCorrection::find_rigid_modes() {
  const BlockSpace& space = coarse_.space();
  const std::size_t size = numbers_.owned();
  std::map<Unknown, dealii::Point<3>> places;
  dealii::DoFTools::map_dofs_to_support_points(space.mapping(),
                                               space.dof_handler(), places);
  const double unit = coarse_.grid().length_x;
  rigid_modes_.assign(6 * size, 0.0);
  for (const auto& [unknown, place] : places) {
    if (unknown % 3 != 0 || !space.owned().is_element(unknown))
      continue;
    const std::size_t node = numbers_.of(unknown);
    for (unsigned int c = 0; c < 3; ++c) {
      const unsigned int next = (c + 1) % 3;
      const unsigned int last = (c + 2) % 3;
      rigid_modes_[c * size + node + c] = 1.0;
      // Rotation about axis c.
      rigid_modes_[(3 + c) * size + node + last] = place[next] / unit - 0.5;
      rigid_modes_[(3 + c) * size + node + next] = 0.5 - place[last] / unit;
    }
  }
}

void FirstOrderCorrection::prepare(std::span<const double> springs,
                                   const std::vector<bool>& held,
                                   bool is_sticking,
                                   const MeshContact& /*contact*/) {
  // A hierarchy without stiff springs, or with springs where there are none, is
  // useless, whereas nodes can be held without it.
  const bool is_new = !std::ranges::equal(springs, springs_);
  springs_.assign(springs.begin(), springs.end());
  if (dealii::Utilities::MPI::max(is_new ? 1 : 0, MPI_COMM_WORLD) == 1)
    age_.expire();
  held_.clear();
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] && vertices_[i])
      append_held(*vertices_[i], is_sticking, held_);
  age_.change_contact();
}

void FirstOrderCorrection::refresh() {
  if (!age_.is_stale())
    return;
  multigrid_.clear();
  matrix_.copy_from(coarse_.stiffness());
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (springs_[k] != 0.0)
      for (const auto& [i, value_i] : points_[k])
        for (const auto& [j, value_j] : points_[k])
          matrix_.add(i, j, springs_[k] * value_i * value_j);
  matrix_.compress(dealii::VectorOperation::add);
  hold(matrix_, coarse_.space(), held_);
  Teuchos::ParameterList parameters;
  std::unique_ptr<Epetra_MultiVector> translations; // are in the modes as well
  multigrid_settings(coarse_.space(), false)
      .set_parameters(parameters, translations, matrix_.trilinos_matrix());
  parameters.set("null space: type", "pre-computed");
  parameters.set("null space: dimension", 6);
  parameters.set("null space: vectors", rigid_modes_.data());
  multigrid_.initialize(matrix_, parameters);
  age_.renew();
}

void FirstOrderCorrection::add(const std::vector<float>& residual,
                               std::vector<float>& displacement, double unit) {
  refresh();
  double* const values = values_.data();
  std::ranges::fill(values_, 0.0);
  for (std::size_t row = 0; row < nodes_.size(); ++row)
    for (std::size_t k = parents_.start[row]; k < parents_.start[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        values[parents_.column[k] + c] +=
            unit * parents_.weight[k] *
            static_cast<double>(residual[nodes_[row] + c]);
  numbers_.layout().constraints->condense(values);
  numbers_.layout().collect(values);
  for (const auto unknown : held_)
    values[numbers_.of(unknown)] = 0.0;
  std::copy_n(values, numbers_.owned(), force_.begin());
  multigrid_.vmult(displacement_, force_);
  std::copy_n(displacement_.begin(), numbers_.owned(), values);
  for (const auto unknown : held_)
    values[numbers_.of(unknown)] = 0.0;
  numbers_.layout().complete(values);
  for (std::size_t row = 0; row < nodes_.size(); ++row)
    for (std::size_t k = parents_.start[row]; k < parents_.start[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        displacement[nodes_[row] + c] += static_cast<float>(
            parents_.weight[k] * values[parents_.column[k] + c]);
}

std::size_t FirstOrderCorrection::bytes() const {
  return coarse_.stiffness().memory_consumption() +
         matrix_.memory_consumption() +
         (age_.setups() > 0 ? hierarchy_bytes(multigrid_) : 0) +
         parents_.bytes() + numbers_.bytes() +
         nodes_.size() * sizeof(std::size_t) +
         (rigid_modes_.size() + values_.size()) * sizeof(double);
}

HexahedronBlock::HexahedronBlock(const BlockProblem& problem,
                                 const BlockSystem& system)
    : HexahedronBlock(problem, system,
                      std::make_shared<LocalUnknowns>(
                          system.space(), system.contact().needed())) {}

HexahedronBlock::HexahedronBlock(const BlockProblem& problem,
                                 const BlockSystem& system,
                                 const std::shared_ptr<LocalUnknowns>& unknowns)
    : HexahedronBlock(
          system, unknowns, hexahedron_mesh(system, *unknowns),
          std::make_unique<FirstOrderCorrection>(problem, system, *unknowns)) {}

HexahedronBlock::HexahedronBlock(const BlockSystem& system,
                                 const std::shared_ptr<LocalUnknowns>& unknowns,
                                 const HexahedronMesh& mesh,
                                 std::unique_ptr<MeshCorrection> correction)
    : MeshBlock(system, unknowns,
                stiffness_of<HexahedronOperator>(mesh, units_of(mesh)),
                std::move(correction)) {}

void HexahedronBlock::set_tangents(std::span<const CellTangents> cells) {
  // The constructor has made it.
  static_cast<HexahedronOperator<double>&>(stiffness()).set_tangents(cells);
}

bool is_hexahedron_block(const BlockSystem& system) {
  const BlockSpace& space = system.space();
  return space.element().degree == 2 &&
         space.triangulation().all_reference_cells_are_hyper_cube() &&
         (!system.has_counter() || system.contact().has_counter_mesh());
}

} // namespace asperity::fem
