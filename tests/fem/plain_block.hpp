#pragma once

// The uniform periodic block as a deal.II user would write it for one process:
// the plain version, which is the reference of the distributed one and of the
// lattice solver. For tests.

#include "fem/waves/elastic_layers.hpp"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity::fem {

/// K u = f of the block above the contact surface z = 0, on one process.
///
/// Vectors hold zeros at constrained unknowns (periodic images, the clamped far
/// boundary and the pins); the images follow from AffineConstraints where
/// needed. A sliding far boundary is pinned laterally at one of its nodes, a
/// pressure-loaded one in all directions: under balanced loads the pin carries
/// nothing.
class PlainBlock {
public:
  /// @param grid   nodes of the surface; cells are `degree` spacings wide
  /// @param degree 1 or 2: FE_Q(degree) with QGauss(degree + 1)
  /// @throws std::domain_error  the grid or the block is outside its range
  PlainBlock(const Grid& grid, int degree, const LayeredBlock& block);

  const Grid& grid() const { return grid_; }

  dealii::types::global_dof_index n_unknowns() const {
    return dof_handler_.n_dofs();
  }

  const dealii::DoFHandler<3>& dof_handler() const { return dof_handler_; }

  const dealii::SparsityPattern& sparsity() const { return sparsity_; }

  const dealii::SparseMatrix<double>& stiffness() const { return stiffness_; }

  /// The unknown u_z of each grid node, in the order of the grid.
  const std::vector<dealii::types::global_dof_index>& face_unknowns() const {
    return face_unknowns_;
  }

  /// Row sums of the mass matrix of the contact surface [m^2].
  const std::vector<double>& nodal_areas() const { return nodal_areas_; }

  /// Force on the unknowns under a unit tension on the far boundary [m^2]:
  /// consistent, and zero where it is clamped.
  const dealii::Vector<double>& far_load() const { return far_load_; }

private:
  void make_mesh(const LayeredBlock& block);
  void constrain(mechanics::FarBoundary far_boundary);
  void pin_one_top_node(const dealii::ComponentMask& components);
  void assemble(const LayeredBlock& block);
  void find_contact_face();
  void integrate_loads(mechanics::FarBoundary far_boundary);
  std::size_t grid_node(const dealii::Point<3>& place) const;

  Grid grid_;
  unsigned int degree_;
  dealii::Triangulation<3> triangulation_;
  dealii::FESystem<3> element_;
  dealii::DoFHandler<3> dof_handler_;
  dealii::AffineConstraints<double> constraints_;
  dealii::SparsityPattern sparsity_;
  dealii::SparseMatrix<double> stiffness_;
  std::vector<dealii::types::global_dof_index> face_unknowns_;
  std::vector<double> nodal_areas_;
  dealii::Vector<double> far_load_;
};

} // namespace asperity::fem
