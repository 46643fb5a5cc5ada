#include "fem/cell_matrices.hpp"

#include "fem/elastic_response.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

/// As many shapes as a graded block has layers; a free mesh fills them once.
constexpr std::size_t most_shapes = 128;

/// Edges of congruent cells differ by the rounding of their places.
constexpr double same_edge = 1e-11;

} // namespace

CellMatrices::CellMatrices(const BlockSpace& space)
    : values_(space.mapping(), space.element(), space.cell_quadrature(),
              dealii::update_gradients | dealii::update_JxW_values),
      matrix_(space.element().n_dofs_per_cell()) {}

dealii::FullMatrix<double> CellMatrices::integrate(const Moduli& moduli) const {
  const dealii::FEValuesExtractors::Vector displacement(0);
  dealii::FullMatrix<double> matrix(values_.dofs_per_cell);
  std::vector<dealii::SymmetricTensor<2, 3>> strain(values_.dofs_per_cell);
  for (const unsigned int q : values_.quadrature_point_indices()) {
    const auto tangent = elastic_response({}, moduli).tangent;
    for (const unsigned int i : values_.dof_indices())
      strain[i] = values_[displacement].symmetric_gradient(i, q);
    for (const unsigned int i : values_.dof_indices()) {
      const auto stress = tangent * strain[i] * values_.JxW(q);
      for (const unsigned int j : values_.dof_indices())
        matrix(i, j) += stress * strain[j];
    }
  }
  return matrix;
}

const CellMatrices::Shape& CellMatrices::shape_of(
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  std::vector<dealii::Tensor<1, 3>> edges;
  for (const unsigned int v : cell->vertex_indices())
    edges.push_back(cell->vertex(v) - cell->vertex(0));
  const double tolerance = same_edge * cell->diameter();
  const auto is_same = [&](const Shape& shape) {
    return std::equal(edges.begin(), edges.end(), shape.edges.begin(),
                      [&](const auto& a, const auto& b) {
                        return (a - b).norm() <= tolerance;
                      });
  };
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), is_same);
  if (found != shapes_.end())
    return *found;
  values_.reinit(cell);
  Shape shape{std::move(edges), integrate({1.0, 0.0}), integrate({0.0, 1.0})};
  if (shapes_.size() < most_shapes) {
    shapes_.push_back(std::move(shape));
    return shapes_.back();
  }
  oldest_ = (oldest_ + 1) % most_shapes;
  return shapes_[oldest_] = std::move(shape);
}

const dealii::FullMatrix<double>&
CellMatrices::of(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                 const Moduli& moduli) {
  const Shape& shape = shape_of(cell);
  matrix_.equ(moduli.lame_modulus, shape.of_lame, moduli.shear_modulus,
              shape.of_shear);
  return matrix_;
}

} // namespace asperity::fem
