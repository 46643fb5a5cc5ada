#pragma once

// The nodes at which the contact law is evaluated, and the effect of a pressure
// there on the unknowns. This file is independent of the contact law.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/block_triangulation.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace asperity::fem {

/// The faces of the second body in the group contact, those of all ranks on
/// every rank. A place belongs to the body if it lies in the projection of one
/// of these faces along z.
class CounterFaces {
public:
  /// This call is collective.
  explicit CounterFaces(const BlockSpace& space);

  /// The row of u_z of the end at a place of the contact surface, interpolated
  /// by the shape functions of the face there; empty beside the body.
  std::optional<FaceRow> row_at(const dealii::Point<2>& place) const;

private:
  /// A face in its own coordinates (xi, eta) in the unit square.
  struct Face {
    std::array<dealii::Point<2>, 4> corners; ///< (0,0), (1,0), (0,1), (1,1)
    /// u_z of the nodes, xi fastest; nobody where it is held at zero.
    std::vector<dealii::types::global_dof_index> unknowns;
  };

  static constexpr dealii::types::global_dof_index nobody =
      dealii::numbers::invalid_dof_index;

  static void
  append_face(const BlockSpace& space,
              const dealii::DoFHandler<3>::active_cell_iterator& cell,
              unsigned int f, std::vector<double>& numbers);
  void gather(const BlockSpace& space);
  void sort_into_boxes();
  std::array<int, 2> box_of(const dealii::Point<2>& place) const;

  std::size_t number_of(const std::array<int, 2>& box) const {
    return static_cast<std::size_t>(box[0]) +
           static_cast<std::size_t>(n_boxes_[0]) *
               static_cast<std::size_t>(box[1]);
  }

  static std::optional<dealii::Point<2>>
  coordinates_in(const Face& face, const dealii::Point<2>& place);

  unsigned int degree_;
  std::vector<Face> faces_;
  // Equal boxes of the plane, each with the faces that reach into it.
  dealii::Point<2> corner_;
  double box_ = 1.0; ///< side of a box [m]
  std::array<int, 2> n_boxes_{1, 1};
  std::vector<std::vector<std::size_t>> in_box_;
};

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

/// The contact points of this rank: the nodes of its own unknowns on the
/// contact surface. Sums over points extend over all ranks.
///
///     w = B u [m],    f = B^T (a p) [N],    a = area of each point    (F.2)
///
/// a is the row sum of the mass matrix of the contact surface and B selects
/// u_z.
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

  /// Whether the points are exactly the nodes of the grid.
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

private:
  void find_counter();
  void find_needed();
  void add_point(const Grid& grid, const dealii::Point<2>& place, double area,
                 FaceRow row);
  void take_nodes(const Grid& grid);
  void finish(const Grid& grid);

  const BlockSpace& space_;
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
