#pragma once

// The image of a map in a figure: its data file and its panel. The map
// is averaged over blocks, so that no side has more than 256 points.

#include "base/grid.hpp"
#include "reports/explore/chart.hpp"
#include "reports/explore/map_stack.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

struct MapImage {
  double length_x = 0.0;      ///< of the map [um]
  double length_y = 0.0;      ///< [um]
  int columns = 0;            ///< of blocks
  int rows = 0;               ///< of blocks
  double pitch_x = 0.0;       ///< side of a block [um]
  double pitch_y = 0.0;       ///< [um]
  std::vector<double> values; ///< means of the blocks, x fastest [unit]
  double least = 0.0;         ///< of the values [unit]
  double largest = 0.0;       ///< [unit]
};

/// @param map   one value per node of the grid
/// @param unit  unit of the values of the image; not 0
MapImage map_image(const Grid& grid, const results::MapView& map, double unit);

/// Largest number of points of a side of an image.
inline constexpr int most_image_points = 256;

/// The image of a map that is already reduced to most_image_points.
MapImage image_of(const Grid& grid, ReducedMap small, double unit);

/// Returns the matrix as text: the first row holds the number of columns and
/// the x of their centres [um], each other row the y of its centre [um] and its
/// values. gnuplot reads it several times faster than a matrix of values alone
/// whose coordinates are expressions.
///
/// @param unit  unit of the numbers in the text, in the unit of the image
std::string map_csv(const MapImage& image, double unit = 1.0);

/// Returns the panel of an image with true proportions. The distance of the
/// ticks is chosen for the longer side, so that the numbers below a narrow map
/// do not run into each other.
///
/// @param map     suffix of the file of map_csv
/// @param colors  "pressure", "gap" or "height"
ChartPanel map_panel(const MapImage& image, const std::string& map,
                     const std::string& colors);

/// Returns the end of the colours of heights about their mean: the largest, or
/// a third more than 99 % of them if that is less, so that a few spikes, pits
/// or scan lines do not take all colours. [unit]
double height_span(const MapImage& image);

/// " Colours end beyond 99 % of the heights.", or "" if they cover all.
std::string span_note(const MapImage& image);

/// Sets the ends of the colours, with few enough ticks that their numbers fit
/// beside the next map.
void set_colors(ChartPanel& panel, double low, double high);

} // namespace asperity::reports
