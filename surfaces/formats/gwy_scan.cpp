#include "input/input_error.hpp"
#include "surfaces/formats/channel_choice.hpp"
#include "surfaces/formats/gwy_objects.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"

#include <fmt/format.h>

#include <cstring>

namespace asperity::surfaces {
namespace {

double gwy_value(const GwyField& field, std::size_t index) {
  double value = 0.0;
  std::memcpy(&value, field.values.data() + index * sizeof(double),
              sizeof(double));
  return value;
}

/// Points with a mask of at least 1/2 are missing: instruments' readers mark
/// points without a height in this way and interpolate them.
void apply_mask(Scan& scan, const GwyField& mask, const std::string& name) {
  const Grid& grid = scan.map.grid;
  if (mask.points_x != grid.points_x || mask.points_y != grid.points_y)
    throw input::InputError(fmt::format(
        "{}: the mask has {} x {} points, but its channel has {} x {}", name,
        mask.points_x, mask.points_y, grid.points_x, grid.points_y));
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (gwy_value(mask, i) >= 0.5)
      scan.map.heights[i] = std::numeric_limits<double>::quiet_NaN();
}

Scan scan_of_channel(const GwyChannel& channel, const std::string& name) {
  const GwyField& field = *channel.field;
  require_sound_grid(name, field.points_x, field.points_y, sizeof(double),
                     field.values.size());
  const double metres = *length_unit(field.unit_xy);
  Scan scan;
  scan.map.grid = {field.points_x, field.points_y, metres * field.length_x,
                   metres * field.length_y};
  require_sound_lengths(name, scan.map.grid);
  scan.map.heights.resize(scan.map.grid.size());
  const double unit = *length_unit(field.unit_z);
  for (std::size_t i = 0; i < scan.map.heights.size(); ++i)
    scan.map.heights[i] = unit * gwy_value(field, i);
  if (channel.mask)
    apply_mask(scan, *channel.mask, name);
  mark_missing(scan, name);
  scan.channel = channel.title;
  scan.reader = "own reader of .gwy";
  return scan;
}

} // namespace

FileContent read_gwy_file(std::string_view bytes, const std::string& name,
                          const ScanRequest& request, Asked asked) {
  const std::map<int, GwyChannel> found = read_gwy_channels(bytes, name);
  std::vector<const GwyChannel*> channels;
  std::vector<ChannelCandidate> candidates;
  FileContent content;
  for (const auto& [number, channel] : found) {
    const GwyField& field = *channel.field;
    channels.push_back(&channel);
    candidates.push_back(
        {{channel.title, field.unit_z, field.points_x, field.points_y},
         is_height_unit(field.unit_z) && is_height_unit(field.unit_xy)});
    content.channels.push_back(candidates.back().info);
  }
  if (asked == Asked::channels)
    return content;
  refuse_scale(request.scale, name);
  content.scan = scan_of_channel(
      *channels[chosen_channel(candidates, request.channel, name)], name);
  return content;
}

} // namespace asperity::surfaces
