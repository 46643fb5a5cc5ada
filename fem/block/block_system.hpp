#pragma once

// The full 3-D block as a linear system: stiffness matrix, load on the far
// boundary and contact points. This file is independent of the contact law.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/contact_points.hpp"

#include <memory>
#include <string>

namespace asperity::fem {

/// The distributed linear system K u = f of the block. The moduli of a cell are
/// those at its centre.
class BlockSystem {
public:
  /// @throws std::domain_error  under the conditions of make_full_block
  explicit BlockSystem(const BlockProblem& problem);

  /// A block on the mesh of another one, which `problem` need not contain.
  BlockSystem(const BlockProblem& problem, const BlockSystem& same_mesh);

  /// A block on a mesh of the same box; null for the mesh of `problem`.
  BlockSystem(
      const BlockProblem& problem,
      std::shared_ptr<dealii::parallel::TriangulationBase<3>> triangulation);

  const Grid& grid() const { return grid_; }

  const BlockSpace& space() const { return space_; }

  const ContactPoints& contact() const { return contact_; }

  /// Reserves entries of the stiffness for springs on further rows. Must be
  /// called before the first call of stiffness().
  void also_reserve(std::vector<FaceRow> rows) {
    contact_.also_reserve(std::move(rows));
  }

  bool has_counter() const { return counter_.has_value(); }

  dealii::types::global_dof_index n_unknowns() const {
    return space_.dof_handler().n_dofs();
  }

  /// The stiffness matrix K, assembled by the first call, which is collective.
  const dealii::TrilinosWrappers::SparseMatrix& stiffness() const;

  /// Consistent force on the unknowns from a nominal pressure of 1 Pa that
  /// pulls the far boundaries away from the contact [m^2]. Its sum is the area
  /// of the contact surface. It is zero if the far boundaries are held.
  const dealii::TrilinosWrappers::MPI::Vector& far_load() const {
    return far_load_;
  }

  /// The moduli of a cell.
  Moduli moduli_of(const dealii::Triangulation<3>::cell_iterator& cell) const;

  /// Null if the block is linear elastic.
  const MaterialLaw* law() const { return law_.get(); }

  /// The largest shear modulus of the cells at the contact surface, of two
  /// bodies that of the softer one [Pa].
  double face_shear_modulus() const { return face_shear_modulus_; }

  /// Lines of text on cells, unknowns and ranks.
  std::string report() const;

private:
  void integrate_far_load();
  void find_face_modulus();

  Grid grid_;
  ModuliField field_;
  std::optional<Moduli> counter_;
  std::shared_ptr<const MaterialLaw> law_;
  mechanics::FarBoundary far_boundary_;
  std::string quality_;
  BlockSpace space_;
  ContactPoints contact_;
  mutable bool is_assembled_ = false;
  mutable dealii::TrilinosWrappers::SparseMatrix stiffness_;
  dealii::TrilinosWrappers::MPI::Vector far_load_;
  double face_shear_modulus_ = 0.0;
};

} // namespace asperity::fem
