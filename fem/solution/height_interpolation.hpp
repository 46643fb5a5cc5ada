#pragma once

// The surface between the points of a height map, which meshes with contact
// points between the nodes of the grid need.

#include "base/grid.hpp"
#include "mechanics/fem_settings.hpp"

#include <array>
#include <span>
#include <vector>

namespace asperity::fem {

/// A place in the plane of the contact surface [m].
using SurfacePlace = std::array<double, 2>;

/// Evaluates a periodic field between the nodes of its grid. At a node each
/// interpolation returns the value there.
///
///     bicubic       cubic convolution (R. G. Keys, IEEE Trans. Acoust. Speech
///                   Signal Process. 29, 1153 (1981), a = -1/2) of 4 x 4 nodes:
///                   exact for quadratic functions, of third order elsewhere
///     band-limited  the trigonometric polynomial through all nodes,
///
///                       h(x, y) = sum_ij D(x - x_i) D(y - y_j) h_ij,   (F.3)
///                       D(t) = sin(N pi t/L) / (N tan(pi t/L)), N even,
///                       D(t) = sin(N pi t/L) / (N sin(pi t/L)), N odd:
///
///                   exact for waves longer than two spacings
///     bilinear      of 2 x 2 nodes: exact for bilinear functions, of second
///                   order elsewhere, and never outside of the values there
///
/// The band-limited field takes N_y sums of N_x products for each x, and N_y
/// products for each place.
/// @param field   grid.size() values
/// @param places  may lie outside of the rectangle of the grid
/// @return        one value per place
std::vector<double> interpolated(const Grid& grid,
                                 std::span<const double> field,
                                 mechanics::HeightInterpolation between,
                                 std::span<const SurfacePlace> places);

} // namespace asperity::fem
