#include "fem/block/cell_matrices.hpp"

#include "fem/block/elastic_response.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

using dealii::Tensor;

/// Capacity of the cache: at least the number of layers of a graded block. An
/// unstructured mesh fills the cache once.
constexpr std::size_t most_shapes = 128;

/// Relative tolerance for equal edges: those of congruent cells differ by the
/// roundoff of their coordinates.
constexpr double same_edge = 1e-11;

} // namespace

CellMatrices::CellMatrices(const BlockSpace& space)
    : CellMatrices(space, space.element(), space.cell_quadrature()) {}

CellMatrices::CellMatrices(const BlockSpace& space,
                           const dealii::FiniteElement<3>& element,
                           const dealii::Quadrature<3>& quadrature)
    : values_(space.mapping(), element.base_element(0), quadrature,
              dealii::update_gradients | dealii::update_JxW_values),
      matrix_(element.n_dofs_per_cell()) {
  for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
    component_and_node_.push_back(element.system_to_component_index(i));
}

/// Integrals of d_k phi_a d_l phi_b [m]. Functions that vanish in a part of the
/// cell are skipped there.
CellMatrices::Products CellMatrices::integrate() const {
  Products products(values_.dofs_per_cell, values_.dofs_per_cell);
  std::vector<unsigned int> there;
  for (const unsigned int q : values_.quadrature_point_indices()) {
    there.clear();
    for (const unsigned int a : values_.dof_indices())
      if (values_.shape_grad(a, q).norm_square() > 0.0)
        there.push_back(a);
    for (const unsigned int a : there) {
      const Tensor<1, 3> weighted = values_.shape_grad(a, q) * values_.JxW(q);
      for (const unsigned int b : there)
        products(a, b) += outer_product(weighted, values_.shape_grad(b, q));
    }
  }
  return products;
}

dealii::FullMatrix<double> CellMatrices::contract(const Products& products,
                                                  const Moduli& moduli) const {
  const auto symmetric = elastic_response({}, moduli).tangent;
  Tensor<4, 3> tangent; // C_ikjl at i, j, k, l
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          tangent[i][j][k][l] = symmetric[i][k][j][l];
  dealii::FullMatrix<double> matrix(component_and_node_.size());
  for (unsigned int row = 0; row < matrix.m(); ++row) {
    const auto [i, a] = component_and_node_[row];
    for (unsigned int column = 0; column < matrix.n(); ++column) {
      const auto [j, b] = component_and_node_[column];
      matrix(row, column) = scalar_product(tangent[i][j], products(a, b));
    }
  }
  return matrix;
}

const CellMatrices::Shape& CellMatrices::shape_of(
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  std::vector<Tensor<1, 3>> edges;
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
  // The cell is passed as a cell of the triangulation, because the DoFHandler's
  // element has three components.
  values_.reinit(dealii::Triangulation<3>::active_cell_iterator(cell));
  const Products products = integrate();
  Shape shape{std::move(edges), contract(products, {1.0, 0.0}),
              contract(products, {0.0, 1.0})};
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
