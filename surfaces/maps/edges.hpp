#pragma once

// How a map that is not periodic becomes so. Owns the window, the mirror and
// the factor by which a window lessens the power.

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Makes the map periodic; the mean of the result is 0.
///
///     periodic  as it is, with whatever step there is at the seam
///     window    w(x) (h(x) - sum w h / sum w), the Hann window in 2-D,
///               w = sin^2(pi (ix + 1/2)/n_x) sin^2(pi (iy + 1/2)/n_y):
///               this, with its lower rim, is what the methods then press
///     mirror    the map and its reflections in a cell of twice the sides:
///               no step and no lost power, but a crease, and four copies of
///               every asperity
HeightMap with_edges(HeightMap map, cases::Edges edges);

/// <w^2> of that window, 9/64 from 3 points a side on [1]. For a surface whose
/// statistics are the same everywhere, windowing multiplies the expected power
/// of any wavelength far below the sides by this: divide <h^2>, <|grad h|^2> or
/// C(q) of a windowed map by it to speak of the surface that was measured. (The
/// shells of the windowed map itself, which the theory takes, are not divided:
/// they belong to what is pressed.)
double hann_power(const Grid& grid);

} // namespace asperity::surfaces
