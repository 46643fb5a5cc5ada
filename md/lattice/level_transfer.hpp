#pragma once

// Between two levels of the multiscale block: the fine plane that hangs on a
// coarse one, and the forces back. Owns the hanging nodes.

#include "md/lattice/slab_coupling.hpp"

namespace asperity::md {

/// Bilinear interpolation of three planes from a coarse periodic grid to the
/// one of twice the points a side whose every second node it is. Overwrites
/// `fine`.
void interpolate(const AtomPlane<const double>& coarse,
                 const AtomPlane<double>& fine);

/// The transpose: adds to the coarse nodes the forces on the fine ones, each in
/// the shares by which it hangs on them.
void add_restricted(const AtomPlane<const double>& fine,
                    const AtomPlane<double>& coarse);

/// Amplitude of the fine wave of angles theta on the fine grid over that of the
/// coarse wave it comes from: (1 + cos theta_x) (1 + cos theta_y) / 4.
double interpolated_share(double fine_angle_x, double fine_angle_y);

} // namespace asperity::md
