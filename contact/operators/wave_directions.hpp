#pragma once

// The directions of the waves of a pressure, on which its tangential
// displacements depend.

#include "base/grid.hpp"

#include <span>

namespace asperity::contact {

/// The share f of the elastic energy <p, C p> of a pressure on a half-space
/// that waves along x have, each its cos^2 of the angle of its wavevector with
/// x:
///
///     f = <p, T p>/<p, C p>,  T(k) = (2/(E* |k|)) k_x^2/|k|^2
///
/// A traction p along x has the energy of (kappa + B/2 - B f) C, and one along
/// y that of (kappa - B/2 + B f) C, with the ratios of
/// mechanics/partial_slip.hpp: the tangential compliance of a half-space is
/// (2/(E*(1 - nu)|k|)) [I - nu k k^T/|k|^2].
///
/// @param is_periodic  otherwise the half-space is pressed inside the grid
/// only,
///                     as by free_halfspace(), where T is y^2/(pi E* r^3)
/// @return  0..1; NaN for a uniform pressure on a periodic grid
double energy_along_x(const Grid& grid, std::span<const double> pressure,
                      bool is_periodic, int threads = 1);

} // namespace asperity::contact
