#pragma once

// Partial slip of each method under the normal load of [friction] of a case
// (mechanics/partial_slip.hpp).

#include "input/types/case.hpp"
#include "mechanics/partial_slip.hpp"
#include "reports/analysis/summary.hpp"
#include "results/types/result.hpp"

#include <vector>

namespace asperity::studies {

/// The state of one realisation at the tangential load mu (P - P') that belongs
/// to a lighter load P' of its curve.
struct SlipState {
  int step = 0;          ///< that of P'
  double pressure = 0.0; ///< P [Pa]
  double share = 0.0;    ///< Q/(mu P) [1]
  double contact = 0.0;  ///< A/A_0 at P [1]
  mechanics::PartialSlip slip;
  /// dQ/d(displacement) along x and y per nominal area: that of the contact at
  /// P', which sticks [Pa/m]. NaN if the result has none.
  mechanics::Directions stiffness = {not_a_number, not_a_number};
};

/// One curve per realisation, from small to large tangential loads; empty if
/// the method has no partial slip, or fewer than two loads.
std::vector<std::vector<SlipState>>
partial_slips(const results::Result& result, const cases::Case& contact_case,
              const results::MethodRecord& method);

/// A number over the realisations.
struct SlipSpread {
  double mean = not_a_number;
  double low = not_a_number;
  double high = not_a_number;
};

/// A number along x and along y.
struct SlipSpreads {
  SlipSpread x, y;
};

/// One load P' over the realisations.
struct SlipPoint {
  double share = 0.0;             ///< Q/(mu P), mean [1]
  double tangential_stress = 0.0; ///< mean [Pa]
  SlipSpreads displacement;       ///< [m]
  SlipSpread stick;               ///< area that sticks over A [1]
  SlipSpreads stiffness;          ///< [Pa/m]
  SlipSpreads loss;               ///< [J/m^2]
};

/// The points of partial_slips() by the load step, at which every realisation
/// has converged, from small to large tangential loads.
std::vector<SlipPoint>
slip_points(const std::vector<std::vector<SlipState>>& curves);

/// Adds for a sphere partial_slip_error: the largest error of the displacement,
/// over that at which the contact slides, and of the area that sticks, over
/// that of the contact, against Cattaneo and Mindlin.
void add_slip_quantities(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         reports::MethodSummary& summary);

} // namespace asperity::studies
