#include "base/require.hpp"
#include "input/input_error.hpp"
#include "input/mapped_file.hpp"
#include "surfaces/formats/channel_choice.hpp"
#include "surfaces/formats/gwy_objects.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

double gwy_value(const GwyField& field, std::size_t index) {
  double value = 0.0;
  std::memcpy(&value, field.values.data() + index * sizeof(double),
              sizeof(double));
  return value;
}

constexpr const char* gwy_reader = "own reader of .gwy";

/// Points with a mask of at least 1/2 are missing: instruments' readers mark
/// points without a height in this way and interpolate them.
constexpr double least_masked = 0.5;

void require_mask_of(const Grid& grid, const GwyField& mask,
                     const std::string& name) {
  if (mask.points_x != grid.points_x || mask.points_y != grid.points_y)
    throw input::InputError(fmt::format(
        "{}: the mask has {} x {} points, but its channel has {} x {}", name,
        mask.points_x, mask.points_y, grid.points_x, grid.points_y));
}

/// The lengths and the unit of the heights of a channel, whose file may have no
/// units. The sides then have the ratio of those of the file, unless length_y
/// is given.
struct FieldScale {
  Grid grid;
  double height_unit = 1.0; ///< [m] per unit of the values
};

FieldScale scale_of(const GwyField& field, const std::string& name,
                    const MapScale& given) {
  require_sound_grid(name, field.points_x, field.points_y, sizeof(double),
                     field.values.size());
  const std::optional<double> lateral = length_unit(field.unit_xy);
  const std::optional<double> vertical = length_unit(field.unit_z);
  MapScale refused = given;
  if (!lateral)
    refused.length = refused.length_y = refused.length_unit = std::nullopt;
  if (!vertical)
    refused.height_unit = std::nullopt;
  refuse_scale(refused, name);
  if (!vertical && !given.height_unit)
    throw input::InputError(fmt::format(
        "surface.height_unit is missing: the values of {} have no unit", name));
  if (!lateral && !given.length && !given.length_unit)
    throw input::InputError(fmt::format(
        "surface.length is missing: the sides of {} have no unit; length_unit "
        "gives it, too",
        name));
  if (!lateral && given.length && given.length_unit)
    throw input::InputError(fmt::format(
        "surface.length and length_unit: give one of them for {}", name));
  const double metres = lateral             ? *lateral
                        : given.length_unit ? *given.length_unit
                                            : *given.length / field.length_x;
  FieldScale scale;
  scale.grid = {field.points_x, field.points_y, metres * field.length_x,
                given.length_y.value_or(metres * field.length_y)};
  require_sound_lengths(name, scale.grid);
  scale.height_unit = vertical.value_or(given.height_unit.value_or(1.0));
  require_positive("height_unit", scale.height_unit, "m");
  return scale;
}

Scan scan_of_channel(const GwyChannel& channel, const std::string& name,
                     const MapScale& given) {
  const GwyField& field = *channel.field;
  const FieldScale scale = scale_of(field, name, given);
  Scan scan;
  scan.map.grid = scale.grid;
  scan.map.heights.resize(scan.map.grid.size());
  const double unit = scale.height_unit;
  scan.numbers.unit = unit;
  for (std::size_t i = 0; i < scan.map.heights.size(); ++i)
    scan.map.heights[i] = unit * gwy_value(field, i);
  if (channel.mask) {
    require_mask_of(scan.map.grid, *channel.mask, name);
    for (std::size_t i = 0; i < scan.map.heights.size(); ++i)
      if (gwy_value(*channel.mask, i) >= least_masked)
        scan.map.heights[i] = std::numeric_limits<double>::quiet_NaN();
  }
  mark_missing(scan, name);
  scan.channel = channel.title;
  scan.reader = gwy_reader;
  return scan;
}

std::vector<ChannelCandidate>
candidates_of(const std::map<int, GwyChannel>& channels) {
  std::vector<ChannelCandidate> candidates;
  for (const auto& [number, channel] : channels) {
    const GwyField& field = *channel.field;
    candidates.push_back(
        {{channel.title, field.unit_z, field.points_x, field.points_y},
         is_height_unit(field.unit_z) && is_height_unit(field.unit_xy),
         (field.unit_z.empty() || is_height_unit(field.unit_z)) &&
             (field.unit_xy.empty() || is_height_unit(field.unit_xy))});
  }
  return candidates;
}

const GwyChannel& chosen_of(const std::map<int, GwyChannel>& channels,
                            const ScanRequest& request,
                            const std::string& name) {
  const std::size_t chosen =
      chosen_channel(candidates_of(channels), request.channel, name);
  return std::next(channels.begin(), static_cast<std::ptrdiff_t>(chosen))
      ->second;
}

/// The numbers of a field in its file, whose bytes are mapped.
StoredNumbers stored_in(const std::string& path, std::string_view bytes,
                        const GwyField& field, double height_unit) {
  return {path,
          static_cast<std::uint64_t>(field.values.data() - bytes.data()),
          sizeof(double),
          static_cast<std::size_t>(field.points_x),
          height_unit,
          [](std::string_view of_rows, std::span<double> taken) {
            std::memcpy(taken.data(), of_rows.data(), of_rows.size());
          }};
}

} // namespace

FileContent read_gwy_file(std::string_view bytes, const std::string& name,
                          const ScanRequest& request, Asked asked) {
  const std::map<int, GwyChannel> channels = read_gwy_channels(bytes, name);
  FileContent content;
  for (ChannelCandidate& candidate : candidates_of(channels))
    content.channels.push_back(std::move(candidate.info));
  if (asked == Asked::scan)
    content.scan = scan_of_channel(chosen_of(channels, request, name), name,
                                   request.scale);
  return content;
}

std::optional<RowFile> gwy_row_file(const std::string& path,
                                    const ScanRequest& request) {
  const input::MappedFile mapped(path);
  const std::map<int, GwyChannel> channels =
      read_gwy_channels(mapped.bytes(), path);
  const GwyChannel& channel = chosen_of(channels, request, path);
  const FieldScale scale = scale_of(*channel.field, path, request.scale);
  RowFile file{scale.grid, channel.title, gwy_reader, {}};
  const StoredNumbers heights =
      stored_in(path, mapped.bytes(), *channel.field, scale.height_unit);
  file.numbers.unit = heights.height_unit;
  if (!channel.mask) {
    file.rows = [heights](int first, int count) {
      return stored_rows(heights, first, count);
    };
    return file;
  }
  require_mask_of(file.grid, *channel.mask, path);
  file.rows = [heights, mask = stored_in(path, mapped.bytes(), *channel.mask,
                                         1.0)](int first, int count) {
    std::vector<double> rows = stored_rows(heights, first, count);
    const std::vector<double> masked = stored_rows(mask, first, count);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (masked[i] >= least_masked)
        rows[i] = std::numeric_limits<double>::quiet_NaN();
    return rows;
  };
  return file;
}

} // namespace asperity::surfaces
