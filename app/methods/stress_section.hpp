#pragma once

// A section through a block's strongest point as a table: which places it
// shows, and the stress there by the continuum or by the block's own cells.

#include "contact/operators/stress_inside.hpp"
#include "fem/plugin.hpp"
#include "results/types/result.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// The places of a section: from the face to four times the strongest point's
/// depth, or half as deep again as the block's layers; and once and a half that
/// to either side, or the whole side.
struct SectionPlaces {
  std::vector<double> depth; ///< [m], that of the face first
  std::vector<int> offsets;  ///< along x from the strongest point, in spacings
};

/// @param block  its thickness and layers
SectionPlaces section_places(const Grid& grid,
                             const contact::ElasticBlock& block,
                             double peak_depth);

/// The von Mises stress of one map in the plane of x and depth through `peak`,
/// its strongest point, in that continuum: rows of depth, x fastest; x from the
/// point.
results::Table stress_section(const std::string& method,
                              const contact::ElasticBlock& block,
                              const results::Fields& map,
                              const contact::StressPeak& peak, int threads);

/// Whose section, and through which point.
struct OwnSection {
  std::string method;
  double nominal_pressure = 0.0; ///< of the block's last solution [Pa]
  fem::StressPeak peak;          ///< of the same
  bool is_periodic = true;       ///< its sides
};

/// The same table of a whole block's own stress, from its cells. A point less
/// than one spacing deep is shown with what a point one spacing deep would be.
/// @param continuum  for the places alone
results::Table stress_section(const OwnSection& section,
                              const fem::FullBlock& block,
                              const contact::ElasticBlock& continuum);

} // namespace asperity::app
