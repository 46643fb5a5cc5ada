// Reads any bytes as a map file of each format that is read from memory: the
// result is heights on a grid, finite or missing, or an InputError.
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fuzz {
namespace {

void read_as(const std::string& bytes, mechanics::MapFormat format,
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
  read_as(bytes, mechanics::MapFormat::automatic, {});
  read_as(bytes, mechanics::MapFormat::automatic, {1e-6, 1e-9, {}, {}});
  read_as(bytes, mechanics::MapFormat::xyz, {{}, 1e-9, {}, 1e-6});
}

} // namespace asperity::fuzz
