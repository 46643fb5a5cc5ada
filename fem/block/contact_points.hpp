#pragma once

// Where the law of contact is asked for, and what a pressure there does to the
// unknowns. Owns nodes and Gauss points alike; knows no law.
// Include from .cpp files of fem/ only.

#include "fem/block/block_space.hpp"

#include <span>
#include <utility>
#include <vector>

namespace asperity::fem {

/// A shape function's value for each unconstrained u_z it needs.
using FaceRow = std::vector<std::pair<dealii::types::global_dof_index, double>>;

/// One point of the contact face.
struct ContactPoint {
  dealii::Point<2> place; ///< [m]
  double area = 0.0;      ///< a_c [m^2] > 0
  /// B_c: w_c = sum of row value times unknown; with two bodies less the
  /// counter body's at the same place.
  FaceRow row;
  int grid_node = -1; ///< of the problem's grid if the point lies on it
};

/// The points of this rank: node-wise those of its own unknowns, else the
/// Gauss points of its own cells' faces. Sums over points are over all ranks.
///
///     w = B u [m],    f = B^T (a p) [N],    a = area of each point    (F.2)
///
/// Node-wise a is the row sum of the face's mass matrix and B picks u_z.
class ContactPoints {
public:
  /// @throws std::domain_error  no contact face, or one whose nodes have no
  ///                            area (second-order tetrahedra)
  ContactPoints(const BlockSpace& space, const BlockProblem& problem);

  std::size_t size() const { return points_.size(); }

  const ContactPoint& operator[](std::size_t i) const { return points_[i]; }

  bool is_nodal() const { return is_nodal_; }

  /// Node-wise, and the nodes are exactly those of the grid.
  bool is_grid() const { return is_grid_; }

  double area() const { return area_; } ///< of all ranks' points [m^2]

  const dealii::IndexSet& needed() const { return needed_; }

  /// w [m] of each point.
  void take_displacement(const dealii::TrilinosWrappers::MPI::Vector& unknowns,
                         std::vector<double>& at_points) const;

  /// f += B^T q for forces q [N] on the points.
  void add_force(std::span<const double> forces,
                 dealii::TrilinosWrappers::MPI::Vector& unknowns) const;

  /// B^T diag(s) B for springs s [N/m] on the points is added.
  void add_springs(std::span<const double> springs,
                   dealii::TrilinosWrappers::SparseMatrix& matrix) const;

  /// Room for any springs.
  void reserve(dealii::TrilinosWrappers::SparsityPattern& pattern) const;

  /// The row of u_z (less the counter body's) at a place of a cell's face.
  FaceRow row_at(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                 const dealii::Point<3>& unit) const;

private:
  void find_counter();
  FaceRow with_counter(FaceRow row) const;
  void take_nodes(const Grid& grid);
  void take_gauss_points(const Grid& grid);
  void finish(const Grid& grid);

  const BlockSpace& space_;
  bool is_nodal_;
  bool has_counter_;
  bool is_grid_ = false;
  std::vector<ContactPoint> points_;
  /// With two bodies: u_z of the first, that of the second opposite.
  std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
      opposite_;
  double area_ = 0.0;
  dealii::IndexSet needed_;
  mutable dealii::TrilinosWrappers::MPI::Vector ghosted_;
};

/// The node of the grid at a place of its closed rectangle, or -1.
int grid_node_at(const Grid& grid, double x, double y);

} // namespace asperity::fem
