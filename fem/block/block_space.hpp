#pragma once

// The finite-element space of a full 3-D block: mesh, shape functions,
// numbering of the unknowns over the ranks, and constraints. It is independent
// of stiffness and contact.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"

#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace asperity::fem {

/// The values of shape functions, by unconstrained unknown.
using FaceRow = std::vector<std::pair<dealii::types::global_dof_index, double>>;

/// A boundary node whose displacements are unknowns.
struct FaceNode {
  dealii::Point<3> place;                                    ///< [m]
  std::array<dealii::types::global_dof_index, 3> unknowns{}; ///< u_x, u_y, u_z
  bool is_counter = false; ///< whether it belongs to the second body
};

/// The space of displacements (u_x, u_y, u_z): FE_Q or FE_SimplexP of the
/// problem's degree.
///
/// The following unknowns are constrained: hanging nodes; on the far boundary
/// those that `far_boundary` prescribes; and with periodic sides those of every
/// node at x = length_x or y = length_y, by the root of the node, one period
/// back in x and y. To remove rigid-body motions, one node of the far boundary
/// is pinned laterally if the far boundary is sliding, and in all directions if
/// it is pressure-loaded; with a sliding far boundary and free sides a second
/// node is pinned against rotation. Under the loads of frictionless contact the
/// pins carry no force. Vectors hold zeros at constrained unknowns.
class BlockSpace {
public:
  /// @throws std::domain_error  under the conditions of make_full_block
  /// @param triangulation  of another space of the same problem; may be null
  explicit BlockSpace(const BlockProblem& problem,
                      std::shared_ptr<dealii::parallel::TriangulationBase<3>>
                          triangulation = {});

  const dealii::parallel::TriangulationBase<3>& triangulation() const {
    return *triangulation_;
  }

  const std::shared_ptr<dealii::parallel::TriangulationBase<3>>&
  shared_triangulation() const {
    return triangulation_;
  }

  const dealii::DoFHandler<3>& dof_handler() const { return dof_handler_; }

  const dealii::FESystem<3>& element() const { return *element_; }

  const dealii::Mapping<3>& mapping() const { return *mapping_; }

  const dealii::AffineConstraints<double>& constraints() const {
    return constraints_;
  }

  /// Unknowns owned by this rank.
  const dealii::IndexSet& owned() const { return owned_; }

  const dealii::IndexSet& relevant() const { return relevant_; }

  const dealii::Quadrature<3>& cell_quadrature() const { return in_cell_; }

  const dealii::Quadrature<2>& face_quadrature() const { return on_face_; }

  /// Creates a zero vector of the owned unknowns.
  dealii::TrilinosWrappers::MPI::Vector make_vector() const;

  /// Nodes on the faces of a group (not on the contact faces of a second body
  /// with a mesh of its own) that lie on cells this rank owns or borders
  /// on, each once, ordered by the number of u_z.
  std::vector<FaceNode> face_nodes(meshes::FaceGroup group) const;

  /// The first of the three consecutive unknowns of each node of each cell of
  /// this rank, of hexahedra with x fastest.
  std::vector<std::uint32_t> cell_nodes() const;

  /// Resolves the constraints in a row of shape values: the entries of the
  /// unconstrained unknowns, sorted, each unknown once.
  FaceRow resolved(const FaceRow& row) const;

  /// Coordinates that differ by less than this are considered equal [m].
  double coordinate_tolerance() const { return tolerance_; }

private:
  void choose_element(int degree);
  void constrain(const BlockProblem& problem);
  void hold_far_boundary(const BlockProblem& problem);
  void pin(const BlockProblem& problem, const std::vector<FaceNode>& nodes,
           bool is_counter);
  void identify_sides();
  double position_of(meshes::FaceGroup group, bool is_counter) const;

  std::array<double, 3> lengths_; ///< of the first body [m]
  double counter_depth_;          ///< of the second body [m]
  double tolerance_;
  std::shared_ptr<dealii::parallel::TriangulationBase<3>> triangulation_;
  std::unique_ptr<dealii::FESystem<3>> element_;
  std::unique_ptr<dealii::Mapping<3>> mapping_;
  dealii::Quadrature<3> in_cell_;
  dealii::Quadrature<2> on_face_;
  dealii::DoFHandler<3> dof_handler_;
  dealii::IndexSet owned_;
  dealii::IndexSet relevant_;
  dealii::AffineConstraints<double> constraints_;
};

} // namespace asperity::fem
