#pragma once

// This file prepares the rows of a measured map that several ranks read from
// its file, so that no rank holds the whole map.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/measured_map.hpp"

#include <string>
#include <vector>

namespace asperity::surfaces {

/// Why one process must hold the whole map before its rows can be used, as the
/// beginning of a sentence: "surface.align_lines compares all lines"; empty if
/// ranks can read its rows. They can if the format permits it (row_file.hpp)
/// and levelling and edges are sums over rows: not with align_lines,
/// remove_spikes, level sphere or cylinder, or edges window. The
/// file is read once for missing points, by pieces of a few MB.
/// @throws input::InputError  as measured_map, apart from the flat map
std::string reason_for_whole_map(const mechanics::SurfaceSpec& surface);

/// The grid of the surface after its edge treatment, without its heights if the
/// format of the file permits it.
/// @throws input::InputError  as measured_map
Grid measured_grid(const mechanics::SurfaceSpec& surface);

/// As measured_map(), without the heights if ranks can read its rows.
/// @throws input::InputError  as measured_map
MeasuredMap described_map(const mechanics::SurfaceSpec& surface);

/// The rows of this process of the map after levelling and edge treatment, with
/// the bits of one process. Each rank reads its rows from the file. If points
/// are missing, each reads the whole file by pieces and solves the equations of
/// the missing points, whose memory is theirs alone. Collective.
/// @param surface  for which reason_for_whole_map() is empty
/// @param rows     on measured_grid()
/// @throws input::InputError  as measured_map
std::vector<double> measured_rows(const mechanics::SurfaceSpec& surface,
                                  const SharedRows& rows);

} // namespace asperity::surfaces
