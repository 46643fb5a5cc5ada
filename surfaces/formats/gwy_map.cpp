#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/channel_choice.hpp"
#include "surfaces/formats/gwy_objects.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

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

/// Points with a mask of at least 1/2 are missing: instruments' readers mark
/// points without a height in this way and interpolate them.
constexpr double least_masked = 0.5;

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

OpenMap map_of_channel(const GwyChannel& channel, const std::string& name,
                       const MapScale& given) {
  const GwyField& field = *channel.field;
  const FieldScale scale = scale_of(field, name, given);
  const Grid& grid = scale.grid;
  std::vector<double> values(grid.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = gwy_value(field, i);
  if (const auto& mask = channel.mask) {
    if (mask->points_x != grid.points_x || mask->points_y != grid.points_y)
      throw input::InputError(fmt::format(
          "{}: the mask has {} x {} points, but its channel has {} x {}", name,
          mask->points_x, mask->points_y, grid.points_x, grid.points_y));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (gwy_value(*mask, i) >= least_masked)
        values[i] = std::numeric_limits<double>::quiet_NaN();
  }
  OpenMap map = map_in_memory(grid, std::move(values), "own reader of .gwy",
                              {.unit = scale.height_unit});
  map.channel = channel.title;
  return map;
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

} // namespace

OpenMap open_gwy(const MapBytes& bytes, const ScanRequest& request) {
  const std::string& name = bytes.name();
  const std::map<int, GwyChannel> channels =
      read_gwy_channels(bytes.all(), name);
  const std::size_t chosen =
      chosen_channel(candidates_of(channels), request.channel, name);
  return map_of_channel(
      std::next(channels.begin(), static_cast<std::ptrdiff_t>(chosen))->second,
      name, request.scale);
}

std::vector<ChannelInfo> gwy_channels(const MapBytes& bytes) {
  std::vector<ChannelInfo> channels;
  for (ChannelCandidate& candidate :
       candidates_of(read_gwy_channels(bytes.all(), bytes.name())))
    channels.push_back(std::move(candidate.info));
  return channels;
}

} // namespace asperity::surfaces
