#pragma once

// The points at which the contact law is evaluated, and the effect of a
// pressure there on the unknowns. Nodes and Gauss points are treated alike;
// this file is independent of the contact law.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/block/counter_faces.hpp"

#include <deal.II/fe/fe_values.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace asperity::fem {

/// Calls `visit(cell, face number)` for each face on the contact surface of the
/// locally owned cells of the first body.
template <typename Visitor>
void for_contact_faces(const BlockSpace& space, const Visitor& visit) {
  for (const auto& cell : space.dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->center()[2] < 0.0)
      continue;
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          cell->face(f)->boundary_id() ==
              boundary_of(meshes::FaceGroup::contact))
        visit(cell, f);
  }
}

/// Calls `visit(face values, number of the point, row of u_z)` for each point
/// of the quadrature on these faces, face by face. The values are those of u_z
/// with places and weights; the row is resolved in the constraints of the
/// space.
void for_gauss_points(
    const BlockSpace& space, const dealii::Quadrature<2>& quadrature,
    const std::function<void(const dealii::FEFaceValues<3>&, unsigned int,
                             const FaceRow&)>& visit);

/// One point of the contact surface.
struct ContactPoint {
  dealii::Point<2> place; ///< [m]
  double area = 0.0;      ///< a_c [m^2] > 0
  /// The row B_c: w_c is the sum over the row of value times unknown. With two
  /// bodies the displacement of the second body at the same place is
  /// subtracted.
  FaceRow row;
  int grid_node = -1; ///< node of the problem's grid at this point, if there is
                      ///< one
  /// Whether there is a counter-surface at this place: false beside a second
  /// body of finite size, where the point never comes into contact.
  bool is_opposed = true;
};

/// The contact points of this rank: node-wise those of its own unknowns,
/// otherwise the Gauss points on the faces of its own cells, face by face in
/// the order of for_contact_faces. Sums over points extend over all ranks.
///
///     w = B u [m],    f = B^T (a p) [N],    a = area of each point    (F.2)
///
/// For node-wise contact a is the row sum of the mass matrix of the contact
/// surface and B selects u_z.
///
/// A second body that is the mirror image of the first has a node opposite to
/// each node. If it has a mesh of its own, its displacement at a point is that
/// of the face there, and the points of the first body alone are tested: it is
/// the slave surface, the second body the master. As B contains the shape
/// functions of both faces, a force on a point acts with equal sums on both
/// bodies.
class ContactPoints {
public:
  /// @throws std::domain_error  there is no contact surface, or its nodes have
  ///                            no area (second-order tetrahedra), or no
  ///                            point faces the second body
  ContactPoints(const BlockSpace& space, const BlockProblem& problem);

  std::size_t size() const { return points_.size(); }

  const ContactPoint& operator[](std::size_t i) const { return points_[i]; }

  bool is_nodal() const { return is_nodal_; }

  /// Whether contact is node-wise and the nodes are exactly those of the grid.
  bool is_grid() const { return is_grid_; }

  /// Whether the second body has a mesh of its own.
  bool has_counter_mesh() const { return counter_.has_value(); }

  double area() const { return area_; } ///< of the points of all ranks [m^2]

  const dealii::IndexSet& needed() const { return needed_; }

  /// Computes w of each point [m].
  void take_displacement(const dealii::TrilinosWrappers::MPI::Vector& unknowns,
                         std::vector<double>& at_points) const;

  /// Adds B^T q to the unknowns for forces q [N] on the points.
  void add_force(std::span<const double> forces,
                 dealii::TrilinosWrappers::MPI::Vector& unknowns) const;

  /// Adds B^T diag(s) B to the matrix for springs s [N/m] on the points.
  void add_springs(std::span<const double> springs,
                   dealii::TrilinosWrappers::SparseMatrix& matrix) const;

  /// Reserves the entries of further rows, too. Collective.
  void also_reserve(std::vector<FaceRow> rows);

  /// Reserves the entries for arbitrary springs.
  void reserve(dealii::TrilinosWrappers::SparsityPattern& pattern) const;

  /// The row of u_z at a place on the face of a cell, minus that of the second
  /// body.
  FaceRow row_at(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                 const dealii::Point<3>& unit) const;

  /// Subtracts the displacement of the second body, if there is one, from the
  /// row of a place on the first. Returns false if there is no counter-surface
  /// at this place.
  bool add_counter(const dealii::Point<2>& place, FaceRow& row) const;

  /// The Gauss point nearest to a place among those of one face.
  /// @param first  index of the first point of the face
  std::size_t nearest_on_face(std::size_t first,
                              const dealii::Point<2>& place) const;

private:
  void find_counter();
  void find_needed();
  void add_point(const Grid& grid, const dealii::Point<2>& place, double area,
                 FaceRow row);
  void take_nodes(const Grid& grid);
  void take_gauss_points(const Grid& grid);
  void finish(const Grid& grid);

  const BlockSpace& space_;
  bool is_nodal_;
  bool has_counter_;
  bool is_grid_ = false;
  std::vector<ContactPoint> points_;
  /// With two bodies: maps u_z of the first body to u_z of the second at the
  /// same place.
  std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
      opposite_;
  std::optional<CounterFaces> counter_; ///< of a second mesh
  double area_ = 0.0;
  std::vector<FaceRow> others_; ///< rows whose entries are reserved as well
  dealii::IndexSet needed_;
  mutable dealii::TrilinosWrappers::MPI::Vector ghosted_;
};

/// The node of the grid at a place in its closed rectangle, or -1.
int grid_node_at(const Grid& grid, double x, double y);

} // namespace asperity::fem
