#include "tests/fem/plain_block.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

using dealii::ComponentMask;
using dealii::FE_Q;
using dealii::FullMatrix;
using dealii::Point;
using dealii::QGauss;
using dealii::types::boundary_id;
using dealii::types::global_dof_index;

// GridGenerator's boundary indicators of a box.
constexpr boundary_id left_face = 0, right_face = 1;
constexpr boundary_id front_face = 2, back_face = 3;
constexpr boundary_id contact_face = 4, top_face = 5;

/// deal.II's cell matrix for Lame's moduli and the current cell of `values`.
FullMatrix<double> cell_matrix(const dealii::FEValues<3>& values,
                               const ElasticLayer& layer) {
  const dealii::FEValuesExtractors::Vector displacement(0);
  FullMatrix<double> matrix(values.dofs_per_cell);
  for (const unsigned int q : values.quadrature_point_indices())
    for (const unsigned int i : values.dof_indices()) {
      const auto strain = values[displacement].symmetric_gradient(i, q);
      const double dilatation = values[displacement].divergence(i, q);
      for (const unsigned int j : values.dof_indices())
        matrix(i, j) +=
            (2.0 * layer.shear_modulus *
                 (strain * values[displacement].symmetric_gradient(j, q)) +
             layer.lame_modulus * dilatation *
                 values[displacement].divergence(j, q)) *
            values.JxW(q);
    }
  return matrix;
}

} // namespace

PlainBlock::PlainBlock(const Grid& grid, int degree, const LayeredBlock& block)
    : grid_(grid),
      degree_(static_cast<unsigned int>(degree)),
      element_(FE_Q<3>(degree_), 3),
      dof_handler_(triangulation_) {
  require_cells(grid, degree);
  require_block(block);
  make_mesh(block);
  dof_handler_.distribute_dofs(element_);
  constrain(block.far_boundary);
  assemble(block);
  find_contact_face();
  integrate_loads(block.far_boundary);
}

void PlainBlock::make_mesh(const LayeredBlock& block) {
  const auto cells_x = static_cast<std::size_t>(grid_.points_x) / degree_;
  const auto cells_y = static_cast<std::size_t>(grid_.points_y) / degree_;
  std::vector<double> thickness;
  double depth = 0.0;
  for (const ElasticLayer& layer : block.layers) {
    thickness.push_back(layer.thickness);
    depth += layer.thickness;
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation_,
      {std::vector<double>(cells_x,
                           grid_.length_x / static_cast<double>(cells_x)),
       std::vector<double>(cells_y,
                           grid_.length_y / static_cast<double>(cells_y)),
       thickness},
      Point<3>(), Point<3>(grid_.length_x, grid_.length_y, depth), true);
}

void PlainBlock::constrain(mechanics::FarBoundary far_boundary) {
  const ComponentMask lateral({true, true, false});
  const ComponentMask vertical({false, false, true});
  if (far_boundary == mechanics::FarBoundary::clamped)
    dealii::DoFTools::make_zero_boundary_constraints(dof_handler_, top_face,
                                                     constraints_);
  if (far_boundary == mechanics::FarBoundary::sliding) {
    dealii::DoFTools::make_zero_boundary_constraints(dof_handler_, top_face,
                                                     constraints_, vertical);
    pin_one_top_node(lateral);
  }
  if (far_boundary == mechanics::FarBoundary::pressure)
    pin_one_top_node(ComponentMask({true, true, true}));
  dealii::DoFTools::make_periodicity_constraints(dof_handler_, left_face,
                                                 right_face, 0, constraints_);
  dealii::DoFTools::make_periodicity_constraints(dof_handler_, front_face,
                                                 back_face, 1, constraints_);
  constraints_.close();
}

// The node nearest to the middle of the far boundary, which is not a periodic
// image.
void PlainBlock::pin_one_top_node(const ComponentMask& components) {
  const Point<2> middle(grid_.length_x / 2.0, grid_.length_y / 2.0);
  double nearest = grid_.length_x + grid_.length_y;
  std::vector<global_dof_index> pinned;
  for (const auto& cell : dof_handler_.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() != top_face)
        continue;
      for (const unsigned int v : face->vertex_indices()) {
        const Point<3> place = face->vertex(v);
        const double distance = Point<2>(place[0], place[1]).distance(middle);
        if (distance >= nearest)
          continue;
        nearest = distance;
        pinned.clear();
        for (unsigned int c = 0; c < 3; ++c)
          if (components[c])
            pinned.push_back(face->vertex_dof_index(v, c));
      }
    }
  for (const global_dof_index unknown : pinned)
    constraints_.add_line(unknown);
}

void PlainBlock::assemble(const LayeredBlock& block) {
  dealii::DynamicSparsityPattern pattern(dof_handler_.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dof_handler_, pattern, constraints_,
                                          false);
  sparsity_.copy_from(pattern);
  stiffness_.reinit(sparsity_);

  dealii::FEValues<3> values(element_, QGauss<3>(degree_ + 1),
                             dealii::update_gradients |
                                 dealii::update_JxW_values);
  std::vector<double> upper_side;
  for (const ElasticLayer& layer : block.layers)
    upper_side.push_back((upper_side.empty() ? 0.0 : upper_side.back()) +
                         layer.thickness);
  std::vector<FullMatrix<double>> matrix_of_layer(block.layers.size());
  std::vector<global_dof_index> unknowns(element_.n_dofs_per_cell());
  for (const auto& cell : dof_handler_.active_cell_iterators()) {
    const auto above = std::upper_bound(upper_side.begin(), upper_side.end(),
                                        cell->center()[2]);
    const auto layer = static_cast<std::size_t>(above - upper_side.begin());
    FullMatrix<double>& matrix = matrix_of_layer[layer];
    if (matrix.empty()) { // all cells of a layer are congruent
      values.reinit(cell);
      matrix = cell_matrix(values, block.layers[layer]);
    }
    cell->get_dof_indices(unknowns);
    constraints_.distribute_local_to_global(matrix, unknowns, stiffness_);
  }
}

std::size_t PlainBlock::grid_node(const Point<3>& place) const {
  const long ix = std::lround(place[0] / grid_.spacing_x());
  const long iy = std::lround(place[1] / grid_.spacing_y());
  return grid_.index(static_cast<int>(ix) % grid_.points_x,
                     static_cast<int>(iy) % grid_.points_y);
}

void PlainBlock::find_contact_face() {
  std::map<global_dof_index, Point<3>> places;
  dealii::DoFTools::map_dofs_to_support_points(
      dealii::MappingQ1<3>(), dof_handler_, places,
      ComponentMask({false, false, true}));
  const double above = 1e-6 * grid_.spacing_x();
  face_unknowns_.assign(grid_.size(), dealii::numbers::invalid_dof_index);
  for (const auto& [unknown, place] : places)
    if (place[2] < above && !constraints_.is_constrained(unknown))
      face_unknowns_[grid_node(place)] = unknown;
}

void PlainBlock::integrate_loads(mechanics::FarBoundary far_boundary) {
  dealii::Vector<double> face_load(dof_handler_.n_dofs());
  far_load_.reinit(dof_handler_.n_dofs());
  dealii::FEFaceValues<3> values(element_, QGauss<2>(degree_ + 1),
                                 dealii::update_values |
                                     dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Scalar vertical(2);
  dealii::Vector<double> cell_load(element_.n_dofs_per_cell());
  std::vector<global_dof_index> unknowns(element_.n_dofs_per_cell());
  for (const auto& cell : dof_handler_.active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const boundary_id face = cell->face(f)->boundary_id();
      if (face != contact_face &&
          (face != top_face ||
           far_boundary != mechanics::FarBoundary::pressure))
        continue;
      values.reinit(cell, f);
      cell_load = 0.0;
      for (const unsigned int q : values.quadrature_point_indices())
        for (const unsigned int i : values.dof_indices())
          cell_load(i) += values[vertical].value(i, q) * values.JxW(q);
      cell->get_dof_indices(unknowns);
      constraints_.distribute_local_to_global(
          cell_load, unknowns, face == top_face ? far_load_ : face_load);
    }
  nodal_areas_.resize(grid_.size());
  for (std::size_t i = 0; i < grid_.size(); ++i)
    nodal_areas_[i] = face_load(face_unknowns_[i]);
}

} // namespace asperity::fem
