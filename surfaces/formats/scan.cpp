#include "surfaces/formats/scan.hpp"

#include "cases/text/input_file.hpp"
#include "surfaces/formats/map_file.hpp"

#include <algorithm>

namespace asperity::surfaces {

std::size_t count_missing(const Scan& scan) {
  return static_cast<std::size_t>(
      std::count(scan.is_missing.begin(), scan.is_missing.end(), char{1}));
}

Scan read_scan_bytes(std::string_view bytes, const std::string& name,
                     const ScanRequest& request) {
  Scan scan;
  scan.map = read_height_map_text(bytes, name, request.format, request.scale);
  scan.reader = "own reader of text";
  return scan;
}

Scan read_scan(const std::string& path, const ScanRequest& request) {
  return read_scan_bytes(
      cases::read_input_file(path, cases::largest_number_file), path, request);
}

std::vector<ChannelInfo> list_channels(const std::string& path) {
  // A text file has one channel; its scales do not matter here.
  const Scan scan = read_scan(path, {cases::MapFormat::plain, {}, {1.0, 1.0}});
  return {{scan.channel, "", scan.map.grid.points_x, scan.map.grid.points_y}};
}

} // namespace asperity::surfaces
