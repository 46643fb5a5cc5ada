#include "fem/block/cell_strains.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/identity_matrix.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {

std::optional<dealii::Tensor<1, 3>> box_edges(const CellStrains::Cell& cell) {
  constexpr double rounding = 1e-12;
  const dealii::Point<3>& first = cell->vertex(0);
  const dealii::Tensor<1, 3> edges = cell->vertex(7) - first;
  const double allowed = rounding * edges.norm();
  for (unsigned int v = 1; v < 7; ++v) {
    const dealii::Tensor<1, 3> apart = cell->vertex(v) - first;
    for (unsigned int axis = 0; axis < 3; ++axis)
      if (std::abs(apart[axis] - ((v >> axis) % 2 == 1 ? edges[axis] : 0.0)) >
          allowed)
        return {};
  }
  return edges;
}

BoxStrain::BoxStrain(const dealii::FESystem<3>& element,
                     const dealii::Quadrature<3>& quadrature,
                     const dealii::FullMatrix<double>& to_rows)
    : n_nodes_(element.n_dofs_per_cell() / 3),
      n_rows_(to_rows.m()),
      unknowns_(n_nodes_),
      gradients_(3 * n_nodes_ * n_rows_, 0.0),
      sums_(9 * n_rows_) {
  for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i) {
    const auto [component, node] = element.system_to_component_index(i);
    unknowns_[node][component] = i;
  }
  const dealii::FiniteElement<3>& scalar = element.base_element(0);
  for (unsigned int node = 0; node < n_nodes_; ++node)
    for (unsigned int q = 0; q < quadrature.size(); ++q) {
      const dealii::Tensor<1, 3> gradient =
          scalar.shape_grad(node, quadrature.point(q));
      for (unsigned int axis = 0; axis < 3; ++axis)
        for (unsigned int row = 0; row < n_rows_; ++row)
          gradients_[(axis * n_nodes_ + node) * n_rows_ + row] +=
              to_rows(row, q) * gradient[axis];
    }
}

void BoxStrain::find(std::span<const double> values,
                     const dealii::Tensor<1, 3>& edges,
                     std::vector<dealii::SymmetricTensor<2, 3>>& strains) {
  std::fill(sums_.begin(), sums_.end(), 0.0);
  for (unsigned int axis = 0; axis < 3; ++axis)
    for (std::size_t node = 0; node < n_nodes_; ++node) {
      const double* gradient =
          gradients_.data() + (axis * n_nodes_ + node) * n_rows_;
      for (std::size_t component = 0; component < 3; ++component) {
        const double value = values[unknowns_[node][component]] / edges[axis];
        double* sum = sums_.data() + (3 * component + axis) * n_rows_;
        for (std::size_t row = 0; row < n_rows_; ++row)
          sum[row] += value * gradient[row];
      }
    }
  strains.resize(n_rows_);
  for (std::size_t row = 0; row < n_rows_; ++row)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        strains[row][i][j] = 0.5 * (sums_[(3 * i + j) * n_rows_ + row] +
                                    sums_[(3 * j + i) * n_rows_ + row]);
}

CellStrains::CellStrains(const BlockSpace& space)
    : space_(space),
      displacement_(space.owned(), space.relevant(), MPI_COMM_WORLD),
      values_(space.mapping(), space.element(), space.cell_quadrature(),
              dealii::update_gradients),
      unknowns_(space.element().n_dofs_per_cell()),
      in_cell_(unknowns_.size()) {
  if (space.triangulation().all_reference_cells_are_hyper_cube()) {
    const dealii::Quadrature<3>& points = space.cell_quadrature();
    const dealii::FullMatrix<double> same =
        dealii::IdentityMatrix(points.size());
    at_points_.emplace(space.element(), points, same);
  }
}

void CellStrains::set(const Vector& displacement) {
  Vector whole = space_.make_vector();
  whole = displacement;
  space_.constraints().distribute(whole);
  displacement_ = whole;
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    local_values_ = displacement_.begin();
}

const std::vector<CellStrains::Strain>&
CellStrains::at_points(const Cell& cell) {
  if (at_points_ && in_box(cell, *at_points_, strains_))
    return strains_;
  values_.reinit(cell);
  strains_.resize(values_.n_quadrature_points);
  values_[dealii::FEValuesExtractors::Vector(0)]
      .get_function_symmetric_gradients(displacement_, strains_);
  return strains_;
}

bool CellStrains::in_box(const Cell& cell, BoxStrain& rows,
                         std::vector<Strain>& strains) {
  const std::optional<dealii::Tensor<1, 3>> edges = box_edges(cell);
  if (!edges)
    return false;
  cell->get_dof_indices(unknowns_);
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    in_cell_[i] = local_values_ != nullptr ? local_values_[unknowns_[i]]
                                           : displacement_(unknowns_[i]);
  rows.find(in_cell_, *edges, strains);
  return true;
}

} // namespace asperity::fem
