#pragma once

// A block on a grid of boxes as plain data, and the order of its nodes in
// vectors. This folder does not depend on deal.II.

#include "fem/multigrid/mesh_units.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace asperity::fem {

/// Lame's moduli of one cell.
struct CellModuli {
  double lame = 0.0;  ///< lambda [Pa] > -2 mu / 3
  double shear = 0.0; ///< mu [Pa] > 0

  friend bool operator==(const CellModuli&, const CellModuli&) = default;
};

/// Equal columns over the contact surface z = 0, divided into layers of any
/// thickness.
struct BoxGrid {
  int degree = 1; ///< of the shape functions, 1 or 2
  int cells_x = 1, cells_y = 1;
  double length_x = 0.0, length_y = 0.0; ///< [m] > 0
  std::vector<double> thickness; ///< from the contact surface on [m] > 0
  bool is_periodic = true;       ///< in x and y; otherwise the sides are free
  bool holds_lateral = true;     ///< u_x = u_y = 0 on the far boundary
  bool holds_normal = true;      ///< u_z = 0 on the far boundary
  /// One pair per layer, or one per cell: x fastest, then y, then the layers.
  std::vector<CellModuli> moduli;

  int layers() const { return static_cast<int>(thickness.size()); }

  double width_x() const { return length_x / cells_x; }

  double width_y() const { return length_y / cells_y; }

  bool is_layered() const { return moduli.size() == thickness.size(); }

  const CellModuli& moduli_of(int x, int y, int layer) const;

  std::array<double, 3> cell_size(int layer) const {
    return {width_x(), width_y(), thickness[static_cast<std::size_t>(layer)]};
  }
};

/// @throws std::domain_error  a number is outside its range or there are not as
///                            many moduli as layers or cells
void require_box_grid(const BoxGrid& box_grid);

MeshUnits units_of(const BoxGrid& box_grid);

/// The grid of boxes in these units.
BoxGrid scaled(const BoxGrid& box_grid, const MeshUnits& units);

/// The order of the nodes in vectors. With periodic sides the nodes at the far
/// ends of x and y are images of those at 0. They have places of their own, so
/// that cells are treated alike: a displacement has copies there, a force has
/// zeros. Along x, a row of vertices and (degree 2) a row of centres follow
/// each other, so that numbers of neighbouring cells are neighbours:
///
///     (((y planes + plane) 3 + component) degree + x % degree) stride
///       + x / degree
///
/// All nodes of equal y are a slice, and slices follow each other, so that
/// those of a process are consecutive (BoxGridSlab). It counts them from its
/// first; the last may be an image of the first of the next process, as it is
/// one of slice 0 where the sides are periodic. The end of a vector is padded
/// with zeros, which may be read with the last cells.
class NodeLayout {
public:
  /// All slices of the grid of boxes.
  explicit NodeLayout(const BoxGrid& box_grid);

  /// @param cells_y          number of rows of cells that this process holds
  /// @param has_image_slice  whether the last slice is an image of one of
  ///                         another process
  NodeLayout(const BoxGrid& box_grid, int cells_y, bool has_image_slice);

  std::size_t index(int x, int y, int plane, int component) const {
    return at(y) * slice_size() + at(plane) * row_size() +
           (at(component) * degree_ + at(x) % degree_) * stride_ +
           at(x) / degree_;
  }

  /// The node and its component at an index.
  struct Node {
    int x = 0, y = 0, plane = 0, component = 0;
  };

  Node node(std::size_t index) const;

  std::size_t degree() const { return degree_; }

  std::size_t stride() const { return stride_; } ///< of x / degree + 1

  /// From a component of a node to the next.
  std::size_t step() const { return degree_ * stride_; }

  std::size_t row_size() const { return 3 * step(); } ///< of a plane's slice

  std::size_t planes() const { return planes_; }

  std::size_t slice_size() const { return planes_ * row_size(); }

  std::size_t slices() const { return slices_; }

  std::size_t size() const { return slices_ * slice_size() + padding; }

  bool has_image_column() const { return has_image_column_; }

  bool has_image_slice() const { return has_image_slice_; }

  /// Number of nodes along x and y without images.
  int nodes_x() const;
  int nodes_y() const;

private:
  static constexpr std::size_t padding = 64;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::size_t degree_, stride_, slices_, planes_;
  bool has_image_column_, has_image_slice_;
};

} // namespace asperity::fem
