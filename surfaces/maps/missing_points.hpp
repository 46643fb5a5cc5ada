#pragma once

// This file fills missing points of a measured map by harmonic interpolation.

#include "surfaces/maps/height_map.hpp"

#include <cstddef>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// A point that had no height.
struct FilledPoint {
  std::size_t index = 0; ///< on the grid
  double height = 0.0;   ///< [m]
};

/// The missing points of a map that is read row by row, and the measured
/// heights beside them, which is all that is kept of the map.
class MissingPoints {
public:
  explicit MissingPoints(const Grid& grid) : grid_(grid) {}

  /// Takes the next row.
  /// @param heights     points_x values, also at missing points
  /// @param is_missing  is called with places 0..points_x-1 of the row
  template <class IsMissing>
  void take_row(std::span<const double> heights, const IsMissing& is_missing) {
    std::vector<char> flags(heights.size());
    for (std::size_t x = 0; x < flags.size(); ++x)
      flags[x] = is_missing(x) ? 1 : 0;
    take_flagged(heights, std::move(flags));
  }

  std::size_t count() const { return missing_.size(); }

  /// Heights of fill_missing() for the missing points, in their order.
  /// @throws std::domain_error  no point is measured
  std::vector<FilledPoint> filled() const;

private:
  void take_flagged(std::span<const double> heights, std::vector<char> flags);

  Grid grid_;
  std::size_t rows_ = 0; ///< that were taken
  std::vector<std::size_t> missing_;
  std::unordered_map<std::size_t, double> beside_; ///< measured heights [m]
  std::vector<double> last_heights_;               ///< of the row before
  std::vector<char> last_flags_;
};

/// Replaces the heights of missing points by the solution of the discrete
/// Laplace equation with the measured heights as boundary values,
///
///     sum over the neighbours n of i inside the map: w_n (h_n - h_i) = 0
///     w_n = 1/spacing_x^2 along x and 1/spacing_y^2 along y
///
/// so that the map is not periodic, no normal derivative at its edges is
/// prescribed but zero, and filled heights lie between the measured ones at the
/// border of their hole. The equations are solved directly, by a sparse
/// Cholesky factorisation.
/// @param is_missing  1 for missing points, else 0; empty: there are none
/// @throws std::domain_error  another number of flags, or no point is measured
void fill_missing(HeightMap& map, const std::vector<char>& is_missing);

} // namespace asperity::surfaces
