#pragma once

// Computes the distributions of pressure and gap over the contact surface. Each
// density is normalised so that its integral is an area fraction.

#include "mechanics/contact_nodes.hpp"
#include "results/types/map_view.hpp"

#include <vector>

namespace asperity::results {

/// A density in equal bins from 0 to `highest`.
struct Histogram {
  double highest = 0.0;        ///< upper end, the largest value > 0
  std::vector<double> density; ///< per bin, in 1/unit

  double bin_width() const {
    return highest / static_cast<double>(density.size());
  }

  double bin_centre(std::size_t bin) const {
    return (static_cast<double>(bin) + 0.5) * bin_width();
  }
};

/// Returns the pressure distribution P(sigma) of the nodes in contact [1/Pa].
/// Its integral is A/A_0, and its first moment is the nominal pressure up to
/// the bin width. Without contact there are no bins.
/// @param pressure  [Pa], contact where > 0
/// @param bins      >= 1
/// @throws std::domain_error  an argument is outside its range
Histogram pressure_histogram(const MapView& pressure, int bins);

/// Returns the gap distribution P(u) of the open nodes [1/m]. Its integral is
/// the open area fraction 1 - A/A_0, and its first moment is the integral of
/// the open gap divided by the nominal area. An open node whose gap is <= 0 due
/// to roundoff counts in the first bin. Without any open gap > 0 there are no
/// bins.
/// @param gap       [m]
/// @param pressure   [Pa]
/// @param criterion  which nodes are in contact; all others are open
/// @throws std::domain_error  an argument is outside its range
Histogram gap_histogram(const MapView& gap, const MapView& pressure, int bins,
                        const mechanics::ContactCriterion& criterion = {});

} // namespace asperity::results
