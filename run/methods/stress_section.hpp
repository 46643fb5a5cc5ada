#pragma once

// Tables of the von Mises stress in a section through the strongest point of a
// block: chooses the sample points, and takes the stress from the continuum
// solution or from the finite-element cells.

#include "contact/operators/stress_inside.hpp"
#include "fem/plugin.hpp"
#include "results/types/result.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::methods {

/// The largest von Mises stress under a map, and the largest shear stress at
/// its place [Pa].
struct StressPoint {
  contact::StressPeak peak;
  double largest_shear = 0.0;
};

/// Finds the stress inside a block under pressure maps.
class StressUnderMaps {
public:
  /// @param block    of the maps, as in contact::StressInside
  /// @param threads  >= 1
  explicit StressUnderMaps(mechanics::ElasticBlock block, int threads = 1)
      : block_(std::move(block)), threads_(threads) {}

  const mechanics::ElasticBlock& block() const { return block_; }

  StressPoint strongest(const results::Fields& map) const;

  /// Von Mises stress [Pa] in one row of nodes at each depth.
  /// @param depths  [m], 0..thickness of the block
  std::vector<std::vector<double>>
  von_mises_rows(const results::Fields& map, std::span<const double> depths,
                 int row) const;

private:
  contact::StressInside inside(const results::Fields& map) const;

  mechanics::ElasticBlock block_;
  int threads_;
};

/// The sample points of a section. It extends from the contact surface to four
/// times the depth of the strongest point, or to one and a half times the layer
/// thickness if that is deeper. Its half-width is one and a half times that
/// depth, but the section spans at most one period.
struct SectionPlaces {
  std::vector<double> depth; ///< [m], beginning at the contact surface
  std::vector<int> offsets;  ///< along x from the strongest point, in grid
                             ///< spacings
};

/// @param block  provides thickness and layers
SectionPlaces section_places(const Grid& grid,
                             const mechanics::ElasticBlock& block,
                             double peak_depth);

/// Computes the von Mises stress that a pressure map causes in a continuum
/// block, in the plane of x and depth through the strongest point. The rows of
/// the table are ordered by depth with x fastest; x is relative to the
/// strongest point.
///
/// @param map   saved fields with the pressure
/// @param peak  strongest point of the block under this pressure
results::Table stress_section(const std::string& method,
                              const StressUnderMaps& stress,
                              const results::Fields& map,
                              const contact::StressPeak& peak);

/// Computes the stress in the plane of stress_section() of the map with the
/// highest load under each of several maps on one grid, for the same places.
///
/// @param maps  at most 12 of them are used, evenly spaced, among them the
/// first
///              and the last
/// @param peak  strongest point under the map with the highest load
/// @return      table "stress-sections-<method>"; the rows of a map follow each
///              other
results::Table stress_sections(const std::string& method,
                               const StressUnderMaps& stress,
                               std::span<const results::Fields> maps,
                               const contact::StressPeak& peak);

/// Identifies the section of a full block.
struct OwnSection {
  std::string method;
  double nominal_pressure = 0.0; ///< of the last solution [Pa]
  fem::StressPeak peak;          ///< strongest point of the last solution
  bool is_periodic = true;       ///< whether the sides are periodic
  bool has_counter = false;      ///< whether a second body is meshed
};

/// Computes the same table from the finite-element stress of a full block. With
/// a second meshed body the section extends as far into it, at negative depths;
/// the stress is NaN beside the bodies. If
/// the strongest point is less than one grid spacing deep, the section has the
/// size for a point one spacing deep.
///
/// @param continuum  used only to choose the sample points
results::Table stress_section(const OwnSection& section,
                              const fem::FullBlock& block,
                              const mechanics::ElasticBlock& continuum);

} // namespace asperity::methods
