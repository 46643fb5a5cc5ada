#pragma once

// An estimate of the error that the mesh makes in the mean gap.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

namespace asperity::fem {

/// A displacement field and the contact force that causes it.
struct LoadedResponse {
  const dealii::TrilinosWrappers::MPI::Vector& displacement; ///< [m] or [1]
  double force; ///< [N], or [N/m] for the response to a unit of approach
};

/// The estimated error of the mean gap under a prescribed load, the smaller of
///
///     sum_K | int_K (sigma^* - sigma) : C^-1 : (tau^* - tau) dV | / k   (F.4)
///     int (sigma^* - sigma) : C^-1 : (sigma^* - sigma) dV / F           [m],
///
/// with the stress sigma of the displacement under the load F, and the stress
/// tau of the response to an approach of the surface with fixed points in
/// contact, which takes the force k. The rigid approach is the derivative of
/// the energy by the load, so that its error is that of the error of the
/// energy, which is half the square of the error of sigma in the energy norm.
/// The first line is this derivative without the cancellation between cells, as
/// the sign of an estimated error is not reliable. It vanishes in full contact.
/// The second one takes the square for proportional to F^2; a multitude of
/// growing contacts has F, and a sphere whose error is that at the edge, too.
///
/// Errors are estimated as by Zienkiewicz and Zhu (stress_indicator.hpp): sigma
/// is the linear projection in each cell, sigma^* is interpolated from the
/// averages at vertices. It is an estimate and no bound: averages are not the
/// exact stress, and the error of which nodes are in contact is not in it. The
/// call is collective.
///
/// @param by_load   u over the owned unknowns [m], and the load F > 0
/// @param response  to an approach, and the force k > 0
/// @param ratio     of the moduli up to which averages extend [1] >= 1
double gap_error(const BlockSystem& system, const LoadedResponse& by_load,
                 const LoadedResponse& response, double ratio);

} // namespace asperity::fem
