#pragma once

// Prepares the rows of a measured map that several ranks read from its file, so
// that no rank holds the whole map.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/measured_map.hpp"

#include <string>
#include <vector>

namespace asperity::surfaces {

/// Why one process must hold the whole map before its rows can be used, as the
/// beginning of a sentence; empty if ranks can read its rows, which depends on
/// the format (OpenMap::reads_rows). The file is then read once for missing
/// points, by pieces of a few MB.
/// @throws input::InputError  as measured_map, apart from the flat map and the
///                            spikes
std::string reason_for_whole_map(const mechanics::SurfaceSpec& surface);

/// The grid of the surface after its edge treatment, without its heights.
/// @throws input::InputError  as measured_map
Grid measured_grid(const mechanics::SurfaceSpec& surface);

/// As measured_map(), without the heights unless surface.remove_spikes is
/// given.
/// @throws input::InputError  as measured_map
MeasuredMap described_map(const mechanics::SurfaceSpec& surface);

/// The rows of this process of the map after levelling and edge treatment, with
/// the bits of one process. Each rank reads its rows from the file. If points
/// are missing, each solves the equations of all missing points, whose memory
/// is theirs alone. Collective.
/// @param surface  for which reason_for_whole_map() is empty
/// @param rows     on measured_grid()
/// @param facts    receives what was found, also the effect of edges = "window"
/// @throws input::InputError  as measured_map
std::vector<double> measured_rows(const mechanics::SurfaceSpec& surface,
                                  const SharedRows& rows,
                                  MapFacts* facts = nullptr);

} // namespace asperity::surfaces
