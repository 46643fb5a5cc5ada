#pragma once

// This file prepares a measured map for the contact problem: levelling,
// rejection of flat maps, and the effect of the edge treatment
// ([surface] edges).

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// The map of the case after levelling. A map that was a perfect plane is
/// considered flat: levelling leaves only the roundoff of its heights, a few
/// eps of the largest.
/// @throws cases::CaseError  the file is not a map, or the map is flat
HeightMap levelled_map(const cases::SurfaceSpec& surface);

/// Roughness of a map that need not be periodic: the slope is computed from
/// differences of neighbours inside the map, in both directions.
struct MapRoughness {
  double rms_height = 0.0; ///< [m]
  double rms_slope = 0.0;  ///< [1]
};

/// Effect of [surface] edges on a measured map.
struct EdgeEffect {
  MapRoughness measured; ///< levelled map, before the edge treatment
  MapRoughness pressed;  ///< map used in the contact problem, after it
};

/// Computes the roughness before and after the edge treatment.
/// @throws cases::CaseError  as levelled_map
EdgeEffect edge_effect(const cases::SurfaceSpec& surface);

} // namespace asperity::surfaces
