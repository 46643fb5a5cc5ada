#pragma once

// The quadrature points of a block whose material law is not linear.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/cell_strains.hpp"
#include "fem/material/material_law.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The states of all quadrature points of a block of hexahedra under a material
/// law. The stress at a displacement follows from the states
/// at the end of the last load step. Cells on other ranks that this rank
/// borders on are followed, too, so that no state is exchanged. Calls are
/// collective, except subtract_from().
class MaterialPoints {
public:
  using Cell = CellStrains::Cell;
  using Vector = CellStrains::Vector;

  /// @param system  must outlive this object, and have a law
  explicit MaterialPoints(const BlockSystem& system);

  /// Finds the states at a displacement, and turns the force of an elastic
  /// block into that of the stress sigma there,
  ///
  ///     int grad phi : sigma dV
  ///         = K u - int grad phi : C : (inelastic strain) dV.        (F.8)
  ///
  /// @param force  K u over the owned unknowns [N]
  void follow(const Vector& displacement, Vector& force);

  /// d(force)/d(displacement) at the last displacement: the cells of this rank
  /// in which a point is not elastic.
  const std::vector<CellTangents>& tangents() const { return tangents_; }

  /// Keeps the inelastic strain as it was at the end of the last load step.
  void freeze(bool is_frozen) { is_frozen_ = is_frozen; }

  /// Whether no point of any rank has a tangent of its own at the last
  /// displacement.
  bool is_elastic() const;

  /// Ends the load step at the last displacement.
  void end_step() { before_ = now_; }

  /// Appends the states at the end of the last load step, of all cells that
  /// this rank follows. Not collective.
  void save(std::vector<double>& numbers) const;

  /// Restores what save() of an equal block appended. Not collective.
  void restore(std::span<const double> numbers);

  /// Subtracts the inelastic strain at the last displacement from the strain at
  /// the quadrature points of a cell.
  void subtract_from(std::vector<CellStrains::Strain>& strains,
                     const Cell& cell) const;

  /// The quantities of the law at the last displacement, by name.
  std::map<std::string, double> quantities() const;

private:
  /// Of the quadrature points of a cell: six components of the inelastic strain
  /// and the history of each. Empty if none was ever inelastic.
  using CellStates = std::vector<double>;

  CellStrains::Strain inelastic_strain(const CellStates& cell,
                                       std::size_t point) const;
  void respond(const Cell& cell, std::size_t number);
  void subtract_force(const Cell& cell, const CellStates& states,
                      Vector& force);
  double value_of(const MaterialQuantity& quantity) const;

  const BlockSystem& system_;
  const MaterialLaw& law_;
  std::size_t in_point_; ///< numbers
  bool is_frozen_ = false;
  CellStrains strains_;
  dealii::FEValues<3> values_;
  std::vector<CellStates> before_, now_; ///< by active cell index
  CellStates next_;
  std::vector<CellTangents> tangents_;
};

} // namespace asperity::fem
