// Reads any bytes as a map file, recognised and by each format of the list: the
// result is heights on a grid, finite or missing, or an InputError. HDF5 and
// the program Gwyddion refuse bytes in memory.
#include "input/input_error.hpp"
#include "surfaces/formats/map_format.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fuzz {
namespace {

void read_as(const std::string& bytes, const std::string& format,
             const surfaces::MapScale& scale) {
  try {
    const surfaces::Scan scan =
        surfaces::read_scan_bytes(bytes, "map", {format, {}, scale});
    const surfaces::HeightMap& map = scan.map;
    require(map.grid.points_x >= 2 && map.grid.points_y >= 2,
            "there are two points per side");
    require(map.heights.size() == map.grid.size(), "the grid is the map's");
    require(map.grid.length_x > 0.0 && map.grid.length_y > 0.0,
            "lengths are positive");
    require(count_missing(scan) < map.heights.size(), "a point is measured");
    require(std::all_of(map.heights.begin(), map.heights.end(),
                        [](double height) { return !std::isinf(height); }),
            "heights are finite or missing");
  } catch (const input::InputError&) {
  }
}

} // namespace

void read_input(const std::string& bytes) {
  for (const char* const format : surfaces::map_format_names())
    for (const surfaces::MapScale& scale :
         {surfaces::MapScale{}, {1e-6, 1e-9, {}, {}}, {{}, 1e-9, {}, 1e-6}})
      read_as(bytes, format, scale);
}

} // namespace asperity::fuzz
