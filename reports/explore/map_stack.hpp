#pragma once

// Prepares maps for the browser: one or more quantities at one or more loads,
// between which a slider moves.

#include "base/grid.hpp"
#include "mechanics/contact_nodes.hpp"
#include "reports/explore/chart.hpp"
#include "reports/explore/packed.hpp"
#include "results/types/map_view.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// What a map shows, and in which colours.
struct MapQuantity {
  std::string label;  ///< with its unit: "pressure / (E* h')"
  std::string colors; ///< "pressure", "gap", "height", "contact"
  double span = 0.0;  ///< colours reach from -span to span; 0: all values
  std::optional<OtherUnits> other = {};
};

/// Maps at one load, in the order of the quantities.
struct MapFrame {
  std::string title; ///< "p / E* = 0.01"
  std::vector<PackedMap> maps;
};

/// All maps of a stack have one grid.
struct MapStack {
  std::vector<MapQuantity> quantities;
  std::vector<MapFrame> frames;
  int columns = 0, rows = 0;
  double left = 0.0, right = 0.0;  ///< edges [um]
  double lower = 0.0, upper = 0.0; ///< edges of the first and last row [um]
  std::string x_label = "x [µm]", y_label = "y [µm]";
};

/// A map averaged over square blocks of points. Points beyond the last whole
/// block are left out.
struct ReducedMap {
  int columns = 0, rows = 0;
  int block_x = 1, block_y = 1; ///< points of a block per side
  std::vector<double> values;
};

/// Averages over blocks so that no side has more than `most` points.
/// @param map  grid.size() values
ReducedMap reduced(const Grid& grid, const results::MapView& map, int most);

/// Returns the share of nodes in contact of each block.
ReducedMap reduced_contact(const Grid& grid, const results::MapView& pressure,
                           const results::MapView& gap,
                           const mechanics::ContactCriterion& criterion,
                           int most);

/// Averages the difference of two maps in the same way.
ReducedMap reduced_difference(const Grid& grid, const results::MapView& map,
                              const results::MapView& other, int most);

/// Returns the largest side of the maps of a stack, such that n_frames of them
/// have at most 2^20 points together: 512 for up to four loads, then 256.
int stack_side(std::size_t n_frames);

/// Returns indices of at most 12 of `count` loads, evenly spaced, with the
/// first and the last.
std::vector<std::size_t> stack_frames(std::size_t count);

} // namespace asperity::reports
