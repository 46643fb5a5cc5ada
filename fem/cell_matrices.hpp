#pragma once

// deal.II's stiffness of a cell, remembered for cells of one shape.
// Include from .cpp files of fem/ only.

#include "fem/block_space.hpp"

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace asperity::fem {

/// Cell matrices of linear elasticity. They are linear in the moduli, so what
/// is kept for a shape is the matrix of lambda = 1 Pa and that of mu = 1 Pa.
class CellMatrices {
public:
  explicit CellMatrices(const BlockSpace& space);

  /// The matrix of the cell, valid until the next call.
  const dealii::FullMatrix<double>&
  of(const dealii::DoFHandler<3>::active_cell_iterator& cell,
     const Moduli& moduli);

private:
  struct Shape {
    std::vector<dealii::Tensor<1, 3>> edges; ///< from the first vertex [m]
    dealii::FullMatrix<double> of_lame, of_shear;
  };

  const Shape&
  shape_of(const dealii::DoFHandler<3>::active_cell_iterator& cell);
  dealii::FullMatrix<double> integrate(const Moduli& moduli) const;

  dealii::FEValues<3> values_;
  std::vector<Shape> shapes_;
  std::size_t oldest_ = 0;
  dealii::FullMatrix<double> matrix_;
};

} // namespace asperity::fem
