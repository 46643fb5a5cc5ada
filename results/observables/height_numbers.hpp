#pragma once

// Computes the numbers of a surface that follow from its heights, by which the
// record of any program can be verified or completed.

#include "results/types/result.hpp"

namespace asperity::results {

/// The least and the largest value that a number can have.
struct NumberBounds {
  double low = 0.0, high = 0.0;
};

/// How heights are continued beyond their map: as they are, or by their mirror
/// images, as those of a map with free edges.
enum class Continuation { periodic, mirrored };

/// The numbers of a SurfaceRecord by its heights. Slope and curvature are those
/// of the trigonometric interpolation; of a map that was left in its file, the
/// curvature is NaN, and the slope lies between those of the differences of
/// neighbours and pi/2 times as much: |sin(q h/2)| <= |q h/2| <= (pi/2) |sin(q
/// h/2)| for each wavevector q of the grid.
struct HeightNumbers {
  double rms_height = not_given;    ///< [m]
  double skewness = not_given;      ///< [1]
  double kurtosis = not_given;      ///< [1]
  double highest = not_given;       ///< above the mean [m]
  double largest = not_given;       ///< size of a height above the mean [m]
  double roundoff = not_given;      ///< of rms_height, for a flat surface [m]
  NumberBounds rms_slope;           ///< [1]
  double rms_curvature = not_given; ///< half the Laplacian [1/m]
};

/// @param surface  has_heights(), finite ones, and lengths > 0
HeightNumbers
height_numbers(const SurfaceRecord& surface,
               Continuation continuation = Continuation::periodic);

} // namespace asperity::results
