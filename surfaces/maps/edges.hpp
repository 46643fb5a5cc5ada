#pragma once

// Makes a map periodic that is not. It contains the window, the mirror and the
// factor by which a window reduces the power.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"

#include <vector>

namespace asperity::surfaces {

/// Makes the map periodic; the mean of the result is 0. `free` is the mirror,
/// as for all methods that need a periodic surface.
///
///     periodic  unchanged, with any step at the periodic boundary
///     window    w(x) (h(x) - sum w h / sum w), the Hann window in 2-D,
///               w = sin^2(pi (ix + 1/2)/n_x) sin^2(pi (iy + 1/2)/n_y):
///               the contact problem is solved for this map, with its lower
///               border
///     mirror    the map and its reflections in a cell of twice the side
///               lengths: no step and no lost power, but a discontinuous slope
///               at the seam, and four copies of every asperity
HeightMap with_edges(HeightMap map, mechanics::Edges edges);

/// The grid of the result.
Grid grid_with_edges(const Grid& grid, mechanics::Edges edges);

/// <w^2> of that window, 9/64 for at least 3 points per side [1]. For a
/// statistically homogeneous surface, windowing multiplies the expected power
/// of any wavelength far below the side lengths by this factor: divide <h^2>,
/// <|grad h|^2> or C(q) of a windowed map by it to obtain the value of the
/// measured surface. (The spectral shells of the windowed map itself, which the
/// theory uses, are not divided, because the contact problem is solved for that
/// map.)
double hann_power(const Grid& grid);

} // namespace asperity::surfaces
