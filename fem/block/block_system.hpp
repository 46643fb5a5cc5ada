#pragma once

// The whole block as a linear system: stiffness, the load of a pressed top and
// the points of contact. Owns no law of contact.
// Include from .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/contact_points.hpp"

#include <memory>
#include <string>

namespace asperity::fem {

/// K u = f of the block, distributed. Moduli are those at a cell's centre.
class BlockSystem {
public:
  /// @throws std::domain_error  as make_full_block
  explicit BlockSystem(const BlockProblem& problem);

  const Grid& grid() const { return grid_; }

  const BlockSpace& space() const { return space_; }

  const ContactPoints& contact() const { return contact_; }

  bool has_counter() const { return counter_.has_value(); }

  dealii::types::global_dof_index n_unknowns() const {
    return space_.dof_handler().n_dofs();
  }

  const dealii::TrilinosWrappers::SparseMatrix& stiffness() const {
    return stiffness_;
  }

  /// Force on the unknowns of a nominal pressure of 1 Pa that pulls the far
  /// faces away from the contact [m^2]: consistent, of the size of the contact
  /// face, and zero where the far faces are held.
  const dealii::TrilinosWrappers::MPI::Vector& top_load() const {
    return top_load_;
  }

  /// What a cell is made of.
  Moduli moduli_of(const dealii::Triangulation<3>::cell_iterator& cell) const;

  /// The largest shear modulus of a cell under the contact face [Pa].
  double face_shear_modulus() const { return face_shear_modulus_; }

  /// Lines on cells, unknowns and ranks.
  std::string report() const;

private:
  void integrate_top_load();
  void find_face_modulus();

  Grid grid_;
  ModuliField field_;
  std::optional<Moduli> counter_;
  cases::TopFace top_;
  std::string quality_;
  BlockSpace space_;
  ContactPoints contact_;
  dealii::TrilinosWrappers::SparseMatrix stiffness_;
  dealii::TrilinosWrappers::MPI::Vector top_load_;
  double face_shear_modulus_ = 0.0;
};

} // namespace asperity::fem
