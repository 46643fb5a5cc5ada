// Reads any bytes as a height map of each format: the result is finite heights
// on a grid, or an InputError.
#include "input/input_error.hpp"
#include "surfaces/formats/text/map_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fuzz {
namespace {

void read_as(const std::string& bytes, mechanics::MapFormat format,
             const surfaces::MapScale& scale) {
  try {
    const surfaces::HeightMap map =
        surfaces::read_height_map_text(bytes, "map.txt", format, scale);
    require(map.heights.size() == map.grid.size(), "the grid is the map's");
    require(map.grid.length_x > 0.0 && map.grid.length_y > 0.0,
            "lengths are positive");
    require(std::all_of(map.heights.begin(), map.heights.end(),
                        [](double height) { return std::isfinite(height); }),
            "heights are finite");
  } catch (const input::InputError&) {
  }
}

} // namespace

void read_input(const std::string& bytes) {
  read_as(bytes, mechanics::MapFormat::automatic, {1e-6, 1e-9});
  read_as(bytes, mechanics::MapFormat::plain, {1e-6, 1e-9});
  read_as(bytes, mechanics::MapFormat::gwyddion, {});
}

} // namespace asperity::fuzz
