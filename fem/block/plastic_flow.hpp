#pragma once

// The plastic strain of a block and the force of its stress.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/block_system.hpp"
#include "fem/block/plastic_response.hpp"

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

/// The history of all quadrature points of a block of second-order hexahedra.
/// The stress at a displacement follows from the history at the end of the last
/// load step. Cells on other ranks that this rank borders on are followed, too,
/// so that no history is exchanged. Calls are collective, except
/// subtract_from().
class PlasticFlow {
public:
  using Cell = CellStrains::Cell;
  using Vector = CellStrains::Vector;

  /// @param system  must outlive this object
  PlasticFlow(const BlockSystem& system, const Plasticity& law);

  /// Finds the plastic strain at a displacement, and turns the force of an
  /// elastic block into that of the stress sigma there,
  ///
  ///     int grad phi : sigma dV
  ///         = K u - int grad phi : C : (plastic strain) dV.          (F.8)
  ///
  /// @param force  K u over the owned unknowns [N]
  void follow(const Vector& displacement, Vector& force);

  /// d(force)/d(displacement) at the last displacement: the cells of this rank
  /// in which a point flows.
  const std::vector<CellTangents>& tangents() const { return tangents_; }

  /// Keeps the plastic strain as it was at the end of the last load step.
  void freeze(bool is_frozen) { is_frozen_ = is_frozen; }

  /// Whether a point of any rank flows at the last displacement.
  bool is_flowing() const;

  /// Ends the load step at the last displacement.
  void end_step() { before_ = now_; }

  /// Appends the plastic strain at the end of the last load step, of all cells
  /// that this rank follows. Not collective.
  void save(std::vector<double>& numbers) const;

  /// Restores what save() of an equal block appended. Not collective.
  void restore(std::span<const double> numbers);

  /// Subtracts the plastic strain at the last displacement from the strain at
  /// the quadrature points of a cell.
  void subtract_from(std::vector<CellStrains::Strain>& strains,
                     const Cell& cell) const;

  /// The work of plastic flow up to the last displacement [J], and the largest
  /// equivalent plastic strain [1].
  double work() const;
  double largest_strain() const;

private:
  /// Of the quadrature points of a cell; empty if none has flowed.
  using CellHistory = std::vector<PointHistory>;

  void flow(const Cell& cell, std::size_t number);
  void subtract_force(const Cell& cell, const CellHistory& history,
                      Vector& force);

  const BlockSystem& system_;
  Plasticity law_;
  bool is_frozen_ = false;
  CellStrains strains_;
  dealii::FEValues<3> values_;
  std::vector<CellHistory> before_, now_; ///< by active cell index
  std::vector<CellTangents> tangents_;
};

} // namespace asperity::fem
