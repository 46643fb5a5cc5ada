#pragma once

// A measured map between its file and the surface that is pressed. Owns its
// refusal where nothing is left of it, and what [surface] edges does to it.

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// The map of the case, levelled. What levelling leaves of a perfect plane is
/// the rounding of its heights, some eps of the largest, and no roughness.
/// @throws cases::CaseError  the file is not a map, or the map is flat
HeightMap levelled_map(const cases::SurfaceSpec& surface);

/// Of a map that need not be periodic: the slope is that of differences of
/// neighbours inside it, in both directions.
struct MapRoughness {
  double rms_height = 0.0; ///< [m]
  double rms_slope = 0.0;  ///< [1]
};

/// What [surface] edges makes of a measured map.
struct EdgeEffect {
  MapRoughness measured; ///< levelled, before
  MapRoughness pressed;  ///< after
};

/// @throws cases::CaseError  as levelled_map
EdgeEffect edge_effect(const cases::SurfaceSpec& surface);

} // namespace asperity::surfaces
