#pragma once

// How pressure and gap are spread over the face, and the patches the contact
// falls into. Owns the normalisation: a density integrates to an area fraction.

#include "base/grid.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// A density in equal bins from 0 to `highest`.
struct Histogram {
  double highest = 0.0;        ///< upper end, the largest value > 0
  std::vector<double> density; ///< of bin i, in 1/unit

  double bin_width() const {
    return highest / static_cast<double>(density.size());
  }

  double bin_centre(std::size_t bin) const {
    return (static_cast<double>(bin) + 0.5) * bin_width();
  }
};

/// P(sigma) of the nodes in contact [1/Pa]: its integral is A/A_0, its first
/// moment the nominal pressure (to the width of a bin). Without contact: no
/// bins.
/// @param pressure  [Pa], contact where > 0
/// @param weights   relative nodal areas, empty if all are equal
/// @param bins      >= 1
/// @throws std::domain_error  an argument is outside its range
Histogram pressure_histogram(std::span<const double> pressure, int bins,
                             std::span<const double> weights = {});

/// P(u) of the nodes that are open [1/m]: its integral is the open area
/// fraction 1 - A/A_0, its first moment the mean over the face of the open gap.
/// An open node whose gap is <= 0 by rounding counts in the first bin. Without
/// any open gap > 0: no bins.
/// @param gap       [m]
/// @param pressure  [Pa], a node is open where it is <= 0
/// @throws std::domain_error  an argument is outside its range
Histogram gap_histogram(std::span<const double> gap,
                        std::span<const double> pressure, int bins,
                        std::span<const double> weights = {});

/// The connected parts of the contact. Nodes are connected to their four
/// neighbours, across the periodic border too.
struct ContactPatches {
  std::vector<int> patch_of_node; ///< 0.. in the order of `areas`; -1 open
  std::vector<double> areas;      ///< [m^2], largest first
};

/// @param pressure  grid.size() values [Pa], contact where > 0
/// @throws std::domain_error  a map is not of the grid's size
ContactPatches contact_patches(const Grid& grid,
                               std::span<const double> pressure,
                               std::span<const double> weights = {});

} // namespace asperity::results
