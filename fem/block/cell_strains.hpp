#pragma once

// The strain of a displacement field at the quadrature points of cells.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace asperity::fem {

/// Maps the displacements of the nodes of an axis-aligned box to strains at its
/// quadrature points, or to the linear projection of these at its vertices.
class BoxStrain {
public:
  /// @param to_rows  from values at the quadrature points to those that are
  ///                 requested; the identity for the points themselves
  BoxStrain(const dealii::FESystem<3>& element,
            const dealii::Quadrature<3>& quadrature,
            const dealii::FullMatrix<double>& to_rows);

  /// @param values   of the unknowns of a cell, in deal.II's order [m]
  /// @param edges    of the cell [m]
  /// @param strains  set to one per requested value [1]
  void find(std::span<const double> values, const dealii::Tensor<1, 3>& edges,
            std::vector<dealii::SymmetricTensor<2, 3>>& strains);

private:
  std::size_t n_nodes_, n_rows_;
  std::vector<std::array<std::size_t, 3>> unknowns_; ///< of each node
  std::vector<double> gradients_; ///< [axis][node][row], of the unit cell
  std::vector<double> sums_;      ///< [component][axis][row]
};

/// The edges of a hexahedron that is an axis-aligned box, up to roundoff [m];
/// empty for any other.
std::optional<dealii::Tensor<1, 3>>
box_edges(const dealii::DoFHandler<3>::active_cell_iterator& cell);

/// The strain of one displacement field at a time, in cells that this rank owns
/// or borders on.
class CellStrains {
public:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;
  using Strain = dealii::SymmetricTensor<2, 3>;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param space  must outlive this object
  explicit CellStrains(const BlockSpace& space);

  /// @param displacement  u over the owned unknowns [m]; its entries at
  ///                      constrained unknowns are not read. Collective.
  void set(const Vector& displacement);

  /// The displacement u at all unknowns of these cells, including constrained
  /// ones [m].
  const Vector& displacement() const { return displacement_; }

  /// The strain at the quadrature points of a cell, until the next call.
  const std::vector<Strain>& at_points(const Cell& cell);

  /// The strains that `rows` maps the displacement to. Returns false if the
  /// cell is not a box.
  bool in_box(const Cell& cell, BoxStrain& rows, std::vector<Strain>& strains);

private:
  const BlockSpace& space_;
  Vector displacement_;
  dealii::FEValues<3> values_;
  const double* local_values_ = nullptr; ///< by unknown, if all are here
  std::vector<dealii::types::global_dof_index> unknowns_; ///< of a cell
  std::vector<double> in_cell_;                           ///< u there [m]
  std::vector<Strain> strains_;
  std::optional<BoxStrain> at_points_; ///< of hexahedra
};

} // namespace asperity::fem
