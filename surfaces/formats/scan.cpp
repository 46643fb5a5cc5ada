#include "surfaces/formats/scan.hpp"

#include "input/input_error.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::surfaces {
namespace {

/// Makes those points missing that have the number of the case or the one that
/// the header of the file names, to six digits, because files round it.
void mark_missing_values(Scan& scan,
                         const std::optional<double>& missing_value) {
  constexpr double rounding = 1.5e-6;
  for (const std::optional<double>& number :
       {missing_value, scan.numbers.missing})
    if (number && std::isfinite(*number)) {
      const double marked = *number * scan.numbers.unit;
      for (double& height : scan.map.heights)
        if (std::abs(height - marked) <= rounding * std::abs(marked))
          height = std::nan("");
    }
}

/// Only NaN is a point without a height: an infinite one is a mistake of the
/// file, or its unit makes it overflow.
void refuse_infinite(const HeightMap& map, const std::string& name) {
  const auto found = std::ranges::find_if(
      map.heights, [](double height) { return std::isinf(height); });
  if (found == map.heights.end())
    return;
  const auto at = found - map.heights.begin();
  throw input::InputError(fmt::format(
      "{}: the height in row {}, column {} is infinite, but must be a finite "
      "number; write NaN at a point without a height",
      name, at / map.grid.points_x + 1, at % map.grid.points_x + 1));
}

Scan scan_of(const MapBytes& bytes, const ScanRequest& request) {
  const MapFormat& format = format_of_map(bytes, request.format);
  if (format.scales == FileScales::all)
    refuse_scale(request.scale, bytes.name());
  if (format.channels == nullptr)
    refuse_channel(request, "", bytes.name());
  Scan scan = format.heights(bytes, request);
  mark_missing_values(scan, request.missing_value);
  refuse_infinite(scan.map, bytes.name());
  if (count_missing(scan) == scan.map.heights.size())
    throw input::InputError(bytes.name() + ": all points are missing");
  return scan;
}

} // namespace

std::size_t count_missing(const Scan& scan) {
  return static_cast<std::size_t>(std::ranges::count_if(
      scan.map.heights, [](double height) { return std::isnan(height); }));
}

Scan read_scan_bytes(std::string_view bytes, const std::string& name,
                     const ScanRequest& request) {
  return scan_of({bytes, name}, request);
}

Scan read_scan(const std::string& path, const ScanRequest& request) {
  return scan_of(MapBytes::of_file(path), request);
}

std::vector<ChannelInfo> list_channels(const std::string& path) {
  const MapBytes bytes = MapBytes::of_file(path);
  const MapFormat& format = format_of_map(bytes, "auto");
  if (format.channels != nullptr)
    return format.channels(bytes);
  const Scan scan = format.heights(bytes, {});
  return {{scan.channel, "m", scan.map.grid.points_x, scan.map.grid.points_y}};
}

} // namespace asperity::surfaces
