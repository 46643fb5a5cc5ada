#pragma once

// The rigid atoms as the kernel finds them. Owns the padded array of heights
// and the window of partners about a point.

#include "base/grid.hpp"
#include "md/interface/interface_kernel.hpp"

#include <span>
#include <vector>

namespace asperity::md {

/// A point over the substrate in its lattice spacings, 0 <= column < points_x
/// and 0 <= row < points_y: node (i, j) lies at column i, row j.
struct LatticePoint {
  double column = 0.0;
  double row = 0.0;
};

/// The heights of the rigid lattice with enough of its periodic images about
/// it that no window ever leaves the array. Lengths are those of the unit it
/// was made with (r_0).
class Substrate {
public:
  /// @param heights  of the nodes of `grid` [m]
  /// @param reach    the longest distance asked for [m]
  /// @param unit     of all lengths from here on [m]
  Substrate(const Grid& grid, std::span<const double> heights, double reach,
            double unit);

  /// All substrate atoms that are nearer than `reach` to an atom at this point
  /// and height, and some that are not. No strips if the atom is that much
  /// higher than any of them.
  Window window(const LatticePoint& point, double z) const;

  /// Bilinear between the four nodes about the point.
  double height_at(const LatticePoint& point) const;

  double spacing() const { return spacing_; }

private:
  void pad(const Grid& grid, std::span<const double> heights, double unit);
  void find_highest(int points);
  void list_strips();
  void list_strips(double column, double row, double radius_square);

  double reach_ = 0.0;
  double spacing_ = 0.0;
  double reach_square_ = 0.0; ///< in spacings^2
  int margin_ = 0;            ///< rows and columns of images on each side
  std::int64_t stride_ = 0;
  std::vector<double> padded_;

  int blocks_ = 0;              ///< along a side
  std::vector<double> highest_; ///< within reach of any point of a block

  /// The strips about a point of each part of a cell, for each radius, one
  /// list after the other; list i ends where list i + 1 begins.
  std::vector<Strip> strips_;
  std::vector<std::size_t> list_begins_;
};

} // namespace asperity::md
