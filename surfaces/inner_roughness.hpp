#pragma once

// The roughness by which adhesion is judged, where it is not that of the
// periodic continuation of a surface.

#include "mechanics/contact_law.hpp"
#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"

#include <optional>

namespace asperity::surfaces {

/// Slope and curvature of the shape of an indenter inside its square, by its
/// formula. The edges at which its periodic images meet have no part in them:
/// the curvature of those grows without bound on finer grids, whatever the
/// shape is.
///
///     sphere         h' = sqrt((Lx^2 + Ly^2)/12)/R, kappa = 1/R
///     rounded_punch  integrals over the square
///     cone           its slope; kappa is NaN, as it has no bound at the tip
///     punch          NaN, as its side is a step
///
/// @param length_x, length_y  sides of the square [m] > 0
/// @return  nothing if the surface is no indenter
std::optional<mechanics::Roughness>
exact_roughness(const mechanics::SurfaceSpec& surface, double length_x,
                double length_y);

/// Whether the curvature of a surface is that inside its map, because edges of
/// its continuation are not pressed: a measured map that is pressed once, and
/// roughness on a paraboloid.
/// @param is_free  whether the method has free boundaries
bool is_judged_inside(const mechanics::SurfaceSpec& surface, bool is_free);

/// Rms of half the Laplacian by differences of neighbours inside a map [1/m];
/// NaN if a side has fewer than 3 points.
double inner_curvature(const HeightMap& map);

} // namespace asperity::surfaces
