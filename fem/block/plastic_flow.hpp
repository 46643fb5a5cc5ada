#pragma once

// The plastic strain of a block and the force of its stress.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/cell_strains.hpp"
#include "fem/block/plastic_response.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

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
