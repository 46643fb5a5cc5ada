#pragma once

// Computes the height and hybrid parameters of ISO 25178-2 of a map by sums
// over its nodes, as instruments and other programs print them.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Heights are measured from their mean; the map is levelled by the caller.
struct HeightParameters {
  double sa = 0.0;  ///< mean of |h| [m]
  double sq = 0.0;  ///< root mean square of h [m]
  double ssk = 0.0; ///< skewness <h^3>/Sq^3 [1], NaN for a flat map
  double sku = 0.0; ///< kurtosis <h^4>/Sq^4 [1], NaN for a flat map
  double sp = 0.0;  ///< highest peak [m] >= 0
  double sv = 0.0;  ///< depth of the deepest valley [m] >= 0
  double sz = 0.0;  ///< Sp + Sv [m]
  double sdq = 0.0; ///< root mean square of |grad h| [1]
  double sdr = 0.0; ///< developed interfacial area ratio: area of the surface
                    ///< over that of its projection, minus 1 [1]
};

/// Sdq is computed from forward differences between neighbours
/// (local_differences.hpp). Sdr is the area of the four triangles into which
/// each cell of four nodes is divided by its centre, whose height is the mean
/// of the four.
/// @param is_periodic  whether differences and cells continue across the edges
/// @throws std::domain_error  a side has fewer than 3 points
HeightParameters height_parameters(const HeightMap& map, bool is_periodic);

} // namespace asperity::surfaces
