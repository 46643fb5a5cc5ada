#include "surfaces/formats/scan.hpp"

#include "input/input_error.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::surfaces {
namespace {

/// Only NaN is a point without a height: an infinite one is a mistake of the
/// file, or its unit makes it overflow.
/// @param first  row of the first height
void refuse_infinite(const std::vector<double>& heights, int first, int width,
                     const std::string& name) {
  const auto found = std::ranges::find_if(
      heights, [](double height) { return std::isinf(height); });
  if (found == heights.end())
    return;
  const auto at = found - heights.begin();
  throw input::InputError(fmt::format(
      "{}: the height in row {}, column {} is infinite, but must be a finite "
      "number; write NaN at a point without a height",
      name, first + at / width + 1, at % width + 1));
}

OpenMap opened(const MapBytes& bytes, const ScanRequest& request) {
  OpenMap map = reader_of_map(bytes, request.format).open(bytes, request);
  map.rows = [rows = std::move(map.rows), numbers = map.numbers,
              value = request.missing_value, width = map.grid.points_x,
              name = bytes.name()](int first, int count) {
    std::vector<double> heights = rows(first, count);
    if (value || numbers.missing)
      mark_missing_value(heights, numbers, value);
    refuse_infinite(heights, first, width, name);
    return heights;
  };
  return map;
}

} // namespace

std::size_t count_missing(const Scan& scan) {
  return static_cast<std::size_t>(std::ranges::count_if(
      scan.map.heights, [](double height) { return std::isnan(height); }));
}

Scan scan_of_map(const OpenMap& map, const std::string& name) {
  Scan scan{{map.grid, map.rows(0, map.grid.points_y)},
            map.channel,
            map.reader,
            map.numbers};
  if (count_missing(scan) == scan.map.heights.size())
    throw input::InputError(name + ": all points are missing");
  return scan;
}

OpenMap open_map(const std::string& path, const ScanRequest& request) {
  return opened(MapBytes::of_file(path), request);
}

Scan read_scan_bytes(std::string_view bytes, const std::string& name,
                     const ScanRequest& request) {
  return scan_of_map(opened({bytes, name}, request), name);
}

Scan read_scan(const std::string& path, const ScanRequest& request) {
  return scan_of_map(open_map(path, request), path);
}

std::vector<ChannelInfo> list_channels(const std::string& path) {
  const MapBytes bytes = MapBytes::of_file(path);
  const MapReader& reader =
      reader_of_map(bytes, mechanics::MapFormat::automatic);
  if (reader.channels != nullptr)
    return reader.channels(bytes);
  const OpenMap map = reader.open(bytes, {});
  return {{map.channel, "m", map.grid.points_x, map.grid.points_y}};
}

} // namespace asperity::surfaces
