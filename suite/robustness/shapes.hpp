#pragma once

// Irregular shapes that a case can only give by a map. Internal to the module.

#include "suite/robustness/draft.hpp"

#include <string>

namespace asperity::robustness {

/// spike: a single protruding node; step: two plateaus; sawtooth: ramps and
/// vertical steps; terraces: roughness with four heights; checkerboard:
/// alternating heights, with a period of two points in both directions.
/// @param rms_slope  to which the shape is scaled, as surfaces::statistics
///                   determines it, which counts the waves of the checkerboard
///                   at the Nyquist wavevector
surfaces::HeightMap map_of_shape(const std::string& shape, int points,
                                 double length, double rms_slope,
                                 const Draft& draft);

} // namespace asperity::robustness
