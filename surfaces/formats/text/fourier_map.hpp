#pragma once

// Reads the Fourier coefficients of a periodic map.

#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <optional>

namespace asperity::surfaces {

/// Fourier coefficients qX qY Re Im of a periodic square map, which has some
/// pair of complex conjugates for q and -q (docs/reference/map-files.md).
/// @return  nothing if the table is something else: there are other columns, an
///          index is no whole number or occurs twice, or no coefficient has a
///          conjugate or one is not that of its opposite
/// @throws input::InputError  a key of the case is missing or superfluous, or
///                            there are too many waves
std::optional<Scan> fourier_scan(const NumberTable& table,
                                 const MapScale& scale);
/// Number of points along a side of such a map; 0: it is none.
int fourier_points(const NumberTable& table);

} // namespace asperity::surfaces
