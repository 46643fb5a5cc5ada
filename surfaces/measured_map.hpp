#pragma once

// Prepares a measured map for the contact problem: levelling, rejection of flat
// maps, and the effect of the edge treatment ([surface] edges).

#include "mechanics/surface_spec.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/corrections.hpp"
#include "surfaces/maps/height_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// What is left in a prepared map although it is probably not roughness.
struct MapFaults {
  std::size_t points = 0;  ///< of the map
  std::size_t missing = 0; ///< points that were not measured
  FoundSpikes spikes;      ///< see spike_threshold
  /// Share of the variance about the mean plane that the least-squares
  /// second-order surface explains [1] 0..1; 0 if a form was removed.
  double form_share = 0.0;
};

/// Robust standard deviations above which a point is a spike, if it also
/// deviates by the rms height about the least-squares second-order surface or
/// more. Of 1e9 points of a Gaussian surface, one is expected above 6.1.
inline constexpr double spike_threshold = 8.0;

/// Share of the variance above which form is reported. Self-affine maps whose
/// waves are all shorter than the map stay below 0.2, those with longer waves
/// below 0.9 (tests/surfaces/map_faults_test.cpp).
inline constexpr double largest_form_share = 0.9;

/// Returns a line of at most 20 words for each fault, with its remedy.
std::vector<std::string> warnings_of(const MapFaults& faults);

/// A map of a case before its edge treatment, and how it was obtained.
struct MeasuredMap {
  HeightMap map;
  std::string channel;     ///< title; may be empty
  std::string reader;      ///< which reader answered (Scan::reader)
  std::size_t missing = 0; ///< points without a height in the file
  std::size_t spikes = 0;  ///< points that were removed as spikes
  double cut_off = 0.0;    ///< shorter waves were removed [m]; 0: none
  MapFaults faults = {};
};

/// How a measured map is continued beyond its border.
mechanics::Edges continuation_of(const mechanics::SurfaceSpec& surface);

/// Reads the map of the case and prepares it, in this order: cropping,
/// alignment of scan lines, removal of spikes, filling of missing points,
/// levelling, and removal of short waves ([surface] crop_x ..., align_lines,
/// remove_spikes, fill, level, cut_off). Short waves are modes of the map if
/// its edges are periodic, else of the map with its mirror images. A cut_off of
/// 0 stands for the end of the reliable range (analysis/reliable_range.hpp) if
/// that is a noise floor.
/// @throws input::InputError  the file is not a map, the window is not inside
///                            it, more points are missing than max_missing, a
///                            number marks missing points,
///                            or the map is flat
MeasuredMap measured_map(const mechanics::SurfaceSpec& surface);

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

MapRoughness roughness_of(const HeightMap& map);

/// The grid of the surface after its edge treatment, without its heights.
/// @throws input::InputError  as measured_map
Grid measured_grid(const mechanics::SurfaceSpec& surface);

/// Describes how a map was obtained: "channel "Height", own reader of X3P; 12
/// missing point(s) (0.04 %) filled".
std::string description_of(const MeasuredMap& measured);

/// The map of the case after levelling. A map that was a perfect plane is
/// considered flat: levelling leaves only the roundoff of its heights, a few
/// eps of the largest.
/// @throws input::InputError  as measured_map
HeightMap levelled_map(const mechanics::SurfaceSpec& surface);

/// Computes the roughness before and after the edge treatment.
/// @throws input::InputError  as levelled_map
EdgeEffect edge_effect(const mechanics::SurfaceSpec& surface);

} // namespace asperity::surfaces
