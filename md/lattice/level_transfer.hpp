#pragma once

// The transfer operators between two levels of the multiscale block: the
// interpolation of displacements to the fine plane of hanging nodes, and its
// transpose for the forces.

#include "md/lattice/slab_coupling.hpp"

namespace asperity::md {

/// Interpolates three planes bilinearly from a coarse periodic grid to the fine
/// grid with twice as many points per side; every second fine node coincides
/// with a coarse node. Overwrites `fine`.
void interpolate(const AtomPlane<const double>& coarse,
                 const AtomPlane<double>& fine);

/// Applies the transpose of the interpolation: adds the forces on the fine
/// nodes to the coarse nodes, with the interpolation weights.
void add_restricted(const AtomPlane<const double>& fine,
                    const AtomPlane<double>& coarse);

/// Returns the ratio of the amplitude of a fine mode with angles theta on the
/// fine grid to that of the coarse mode from which it is interpolated:
/// (1 + cos theta_x) (1 + cos theta_y) / 4.
double interpolated_share(double fine_angle_x, double fine_angle_y);

} // namespace asperity::md
