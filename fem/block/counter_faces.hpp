#pragma once

// The end of a counter-body that has a mesh of its own: which of its faces lies
// at a place of the contact surface, and the displacement of that face there.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"

#include <array>
#include <optional>
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

} // namespace asperity::fem
