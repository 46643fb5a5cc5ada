#pragma once

// The rigid substrate as used by the SIMD kernel: the periodically padded array
// of heights and the search for the neighbours of a point.

#include "base/grid.hpp"
#include "md/interface/interface_kernel.hpp"

#include <span>
#include <vector>

namespace asperity::md {

/// A point in the plane of the substrate in units of its lattice spacing, with
/// 0 <= column < points_x and 0 <= row < points_y. Node (i, j) lies at column i
/// and row j.
struct LatticePoint {
  double column = 0.0;
  double row = 0.0;
};

/// The heights of the rigid lattice, padded with enough periodic images that no
/// window extends beyond the array. All lengths are in the unit that is passed
/// to the constructor (r_0).
class Substrate {
public:
  /// @param heights  heights at the nodes of `grid` [m]
  /// @param reach    largest distance at which neighbours are searched [m]
  /// @param unit     unit of all lengths in this class [m]
  Substrate(const Grid& grid, std::span<const double> heights, double reach,
            double unit);

  /// Returns a superset of the substrate atoms that are closer than `reach` to
  /// an atom at the given point and height. The window has no tiles if the
  /// atom is farther than `reach` above all of them.
  Window window(const LatticePoint& point, double z) const;

  /// Returns the height at the point by bilinear interpolation.
  double height_at(const LatticePoint& point) const;

  double spacing() const { return spacing_; }

private:
  void pad(const Grid& grid, std::span<const double> heights, double unit);
  void find_highest(int points);
  void list_tiles();

  double reach_ = 0.0;
  double spacing_ = 0.0;
  double per_spacing_ = 0.0;  ///< 1 / spacing
  double reach_square_ = 0.0; ///< in spacings^2
  int margin_ = 0;            ///< periodic images on each side
  std::int64_t stride_ = 0;   ///< columns of a padded row

  /// For each padded node (column by column, row by row) its height and that of
  /// the node above it in the next row, so that a tile is contiguous.
  std::vector<double> paired_;

  int blocks_ = 0;              ///< number of blocks per side
  std::vector<double> highest_; ///< maximum within reach of a block

  /// Tiles around a point in each part of a cell, for each radius. The lists
  /// are stored contiguously; list i ends where list i + 1 begins.
  std::vector<Tile> tiles_;
  std::vector<std::size_t> list_begins_;
};

} // namespace asperity::md
