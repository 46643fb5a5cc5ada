#pragma once

// The rigid atoms as the kernel finds them. Owns the padded array of heights
// and the window of partners about a point.

#include "base/grid.hpp"
#include "md/interface_kernel.hpp"

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

  /// The strips of all substrate atoms that are nearer than `reach` to an atom
  /// at this point and height, and of some that are not. Empty if it is that
  /// much higher than any of them.
  /// @param strips  overwritten
  void find_strips(const LatticePoint& point, double z,
                   std::vector<Strip>& strips) const;

  /// Bilinear between the four nodes about the point.
  double height_at(const LatticePoint& point) const;

  double spacing() const { return spacing_; }

  const double* heights() const { return padded_.data(); }

private:
  void pad(const Grid& grid, std::span<const double> heights, double unit);
  void find_highest(int points);

  double reach_ = 0.0;
  double spacing_ = 0.0;
  int margin_ = 0; ///< rows and columns of images on each side
  std::int64_t stride_ = 0;
  std::vector<double> padded_;

  int blocks_ = 0;              ///< along a side
  std::vector<double> highest_; ///< within reach of any point of a block

  /// Half of the chord at a distance from the centre, in spacings, by the
  /// square of what is left of the radius in steps of 1/chord_steps; rounded
  /// up.
  std::vector<double> half_chords_;
};

} // namespace asperity::md
