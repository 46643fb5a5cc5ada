#pragma once

// Stiffness matrices of cells computed with deal.II and cached for cells of
// equal shape.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"

#include <deal.II/base/table.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace asperity::fem {

/// Computes cell matrices of linear elasticity,
///
///     K_(a,i),(b,j) = C_ikjl int d_k phi_a d_l phi_b dV              (F.3)
///
/// for nodes a, b and directions i, j, with C from elastic_response. They are
/// linear in the moduli, so the cache holds for each shape the matrix of
/// lambda = 1 Pa and that of mu = 1 Pa.
class CellMatrices {
public:
  explicit CellMatrices(const BlockSpace& space);

  /// Uses other shape functions on the unknowns of the space's element.
  CellMatrices(const BlockSpace& space, const dealii::FiniteElement<3>& element,
               const dealii::Quadrature<3>& quadrature);

  /// The matrix of the cell. The reference is valid until the next call.
  const dealii::FullMatrix<double>&
  of(const dealii::DoFHandler<3>::active_cell_iterator& cell,
     const Moduli& moduli);

private:
  using Products = dealii::Table<2, dealii::Tensor<2, 3>>;

  struct Shape {
    std::vector<dealii::Tensor<1, 3>> edges; ///< from the first vertex [m]
    dealii::FullMatrix<double> of_lame, of_shear;
  };

  const Shape&
  shape_of(const dealii::DoFHandler<3>::active_cell_iterator& cell);
  Products integrate() const;
  dealii::FullMatrix<double> contract(const Products& products,
                                      const Moduli& moduli) const;

  dealii::FEValues<3> values_; ///< of a single component
  std::vector<std::pair<unsigned int, unsigned int>>
      component_and_node_; ///< of each unknown
  std::vector<Shape> shapes_;
  std::size_t oldest_ = 0;
  dealii::FullMatrix<double> matrix_;
};

} // namespace asperity::fem
