#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// A channel as a candidate.
struct ChannelCandidate {
  ChannelInfo info;
  bool has_heights = false; ///< values and sides are lengths
  /// The same, but units may be absent, for the case to give.
  bool may_have_heights = false;
};

namespace {

bool contains_any(const std::string& title,
                  std::span<const std::string_view> words) {
  const std::string lower = lower_case(title);
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return lower.find(word) != std::string::npos;
  });
}

/// 2: the title names heights, 1: it names nothing known, 0: another signal.
int rank_of_title(const std::string& title) {
  static constexpr std::string_view others[] = {
      "deflection", "amplitude",  "phase",       "error",   "friction",
      "lateral",    "intensity",  "adhesion",    "current", "voltage",
      "mask",       "excitation", "dissipation", "quality"};
  static constexpr std::string_view heights[] = {
      "height", "topo",  "zsensor",     "z sensor", "z-axis",
      "z axis", "hoehe", "h\xC3\xB6he", "surface"};
  if (contains_any(title, others))
    return 0;
  return contains_any(title, heights) ? 2 : 1;
}

std::string list_of(std::span<const ChannelCandidate> channels) {
  std::string list;
  for (const ChannelCandidate& channel : channels)
    list += fmt::format("{}\"{}\" [{}]", list.empty() ? "" : ", ",
                        printable(channel.info.title),
                        printable(channel.info.unit));
  return list.empty() ? "none" : list;
}

std::optional<std::size_t> titled(std::span<const ChannelCandidate> channels,
                                  const std::string& wanted) {
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i].info.title == wanted)
      return i;
  std::vector<std::size_t> similar;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (lower_case(channels[i].info.title) == lower_case(wanted))
      similar.push_back(i);
  if (similar.size() == 1)
    return similar[0];
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (wanted == std::to_string(i + 1))
      return i;
  return std::nullopt;
}

} // namespace

/// Whether the unit is a length.
bool is_height_unit(const std::string& unit) {
  return length_unit(unit).has_value();
}

/// Returns the index of a channel.
///
/// With `wanted`, that is the channel of this title, or, if no title is equal,
/// the only one that is equal apart from the case of its letters, or the
/// channel with this number in the list, from 1. Otherwise it is, among the
/// channels of heights, or else among those without units, the first whose
/// title names heights (height, topography, z sensor, and the like), or else
/// the first whose title does not name another signal (deflection, amplitude,
/// phase, error, friction, ...).
/// @throws input::InputError  there is no such channel or none contains
///                            heights; the message lists the channels
std::size_t chosen_channel(std::span<const ChannelCandidate> channels,
                           const std::optional<std::string>& wanted,
                           const std::string& name) {
  if (wanted) {
    const std::optional<std::size_t> found = titled(channels, *wanted);
    if (!found)
      throw input::InputError(
          fmt::format("surface.channel = \"{}\": {} has no such channel; its "
                      "channels are {}",
                      printable(*wanted), name, list_of(channels)));
    if (!channels[*found].may_have_heights)
      throw input::InputError(fmt::format(
          "surface.channel = \"{}\": this channel of {} is in '{}', but must "
          "be a length over a length; its channels are {}",
          printable(*wanted), name, printable(channels[*found].info.unit),
          list_of(channels)));
    return *found;
  }
  std::optional<std::size_t> best;
  int best_rank = -1;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    constexpr int of_units = 3; // above those of titles
    const int rank = rank_of_title(channels[i].info.title) +
                     (channels[i].has_heights ? of_units : 0);
    if (channels[i].may_have_heights && rank > best_rank) {
      best = i;
      best_rank = rank;
    }
  }
  if (!best)
    throw input::InputError(
        fmt::format("{}: no channel contains heights; its channels are {}",
                    name, list_of(channels)));
  return *best;
}

/// A GwyDataField. Its values are not copied.
struct GwyField {
  int points_x = 0;
  int points_y = 0;
  double length_x = 0.0; ///< in unit_xy
  double length_y = 0.0;
  std::string unit_xy;     ///< may be empty
  std::string unit_z;      ///< may be empty
  std::string_view values; ///< points_x * points_y little-endian doubles
};

/// A channel "/n/data" with "/n/data/title" and "/n/mask".
struct GwyChannel {
  std::string title;
  std::optional<GwyField> field;
  std::optional<GwyField> mask;
};

namespace {

/// A named, typed component of an object. The bytes of the value exclude the
/// count of an array; those of an object are its whole serialised form.
struct GwyComponent {
  std::string_view name;
  char type = ' ';
  std::string_view value;
  std::size_t offset = 0; ///< of the value in the file
};

/// Size of one element of the types that have a fixed size, else 0.
std::size_t element_size(char type) {
  switch (type) {
  case 'b':
  case 'c':
  case 'C':
    return 1;
  case 'i':
  case 'I':
    return 4;
  case 'q':
  case 'd':
  case 'Q':
  case 'D':
    return 8;
  default:
    return 0;
  }
}

/// Skips a serialised object: its type, size and content.
void skip_object(ByteReader& bytes) {
  bytes.take_text();
  bytes.take_bytes(bytes.take<std::uint32_t>());
}

std::string_view take_array(ByteReader& bytes, char type) {
  const auto count = bytes.take<std::uint32_t>();
  if (const std::size_t size = element_size(type); size > 0)
    return bytes.take_bytes(count * size);
  for (std::uint32_t i = 0; i < count; ++i)
    if (type == 'S')
      bytes.take_text();
    else
      skip_object(bytes);
  return {};
}

/// The components of one object, in the order of the file.
class GwyComponents {
public:
  /// Reads the type and the size of the object.
  explicit GwyComponents(ByteReader bytes)
      : type_(bytes.take_text()), bytes_(content_of(bytes)) {}

  std::string_view type() const { return type_; }

  std::optional<GwyComponent> next() {
    if (bytes_.is_at_end())
      return std::nullopt;
    GwyComponent component;
    component.name = bytes_.take_text();
    component.type = bytes_.take<char>();
    component.offset = bytes_.offset();
    component.value = take_value(component.type);
    return component;
  }

  const ByteReader& bytes() const { return bytes_; }

private:
  static ByteReader content_of(ByteReader& bytes) {
    const auto size = bytes.take<std::uint32_t>();
    const std::size_t begin = bytes.offset();
    return ByteReader(bytes.take_bytes(size), bytes.name(), begin);
  }

  std::string_view take_value(char type) {
    if (type == 's')
      return bytes_.take_text();
    if (type == 'o') {
      ByteReader ahead = bytes_;
      skip_object(ahead);
      return bytes_.take_bytes(ahead.offset() - bytes_.offset());
    }
    if (std::string_view("CIQDSO").find(type) != std::string_view::npos)
      return take_array(bytes_, type);
    const std::size_t size = element_size(type);
    if (size == 0)
      bytes_.refuse(fmt::format("a component of the unknown type '{}'",
                                printable(std::string_view(&type, 1))));
    return bytes_.take_bytes(size);
  }

  std::string_view type_;
  ByteReader bytes_;
};

template <class Number>
Number number_in(const GwyComponent& component) {
  Number number{};
  std::memcpy(&number, component.value.data(), sizeof(Number));
  return number;
}

ByteReader reader_of(const GwyComponent& component, const std::string& name) {
  return ByteReader(component.value, name, component.offset);
}

std::string unit_in(const GwyComponent& component, const std::string& name) {
  GwyComponents unit(reader_of(component, name));
  while (const auto part = unit.next())
    if (part->name == "unitstr" && part->type == 's')
      return std::string(part->value);
  return "";
}

void take_field_part(GwyField& field, const GwyComponent& part,
                     const std::string& name) {
  if (part.name == "xres" && part.type == 'i')
    field.points_x = number_in<std::int32_t>(part);
  else if (part.name == "yres" && part.type == 'i')
    field.points_y = number_in<std::int32_t>(part);
  else if (part.name == "xreal" && part.type == 'd')
    field.length_x = number_in<double>(part);
  else if (part.name == "yreal" && part.type == 'd')
    field.length_y = number_in<double>(part);
  else if (part.name == "si_unit_xy" && part.type == 'o')
    field.unit_xy = unit_in(part, name);
  else if (part.name == "si_unit_z" && part.type == 'o')
    field.unit_z = unit_in(part, name);
  else if (part.name == "data" && part.type == 'D')
    field.values = part.value;
}

/// The field of a component; empty if it is another object.
std::optional<GwyField> field_in(const GwyComponent& component,
                                 const std::string& name) {
  GwyComponents parts(reader_of(component, name));
  if (parts.type() != "GwyDataField")
    return std::nullopt;
  GwyField field;
  while (const auto part = parts.next())
    take_field_part(field, *part, name);
  const std::size_t count = field.values.size() / sizeof(double);
  if (field.points_x < 1 || field.points_y < 1 ||
      static_cast<std::size_t>(field.points_x) *
              static_cast<std::size_t>(field.points_y) !=
          count)
    throw input::InputError(fmt::format(
        "{}: byte {}: the field {} has {} x {} points, but {} values", name,
        component.offset, printable(component.name), field.points_x,
        field.points_y, count));
  return field;
}

/// Splits "/12/data" into 12 and "data"; empty for other names.
std::optional<std::pair<int, std::string_view>>
channel_key(std::string_view name) {
  if (!name.starts_with('/'))
    return std::nullopt;
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + 1, end, number);
  if (error != std::errc() || stop == end || *stop != '/')
    return std::nullopt;
  return std::pair(number, std::string_view(stop + 1, end));
}

} // namespace

/// Reads a file that begins with GWYP.
/// @param bytes  must outlive the result
/// @return  the channels by their number n
/// @throws input::InputError  with name and byte: malformed objects, fields
///                            whose sizes do not agree with their values
std::map<int, GwyChannel> read_gwy_channels(std::string_view bytes,
                                            const std::string& name) {
  ByteReader reader(bytes, name);
  reader.take_bytes(4); // GWYP, which has been recognised
  GwyComponents container(reader);
  std::map<int, GwyChannel> channels;
  while (const auto component = container.next()) {
    const auto key = channel_key(component->name);
    if (!key)
      continue;
    const auto& [number, part] = *key;
    if (part == "data" && component->type == 'o')
      channels[number].field = field_in(*component, name);
    else if (part == "mask" && component->type == 'o')
      channels[number].mask = field_in(*component, name);
    else if (part == "data/title" && component->type == 's')
      channels[number].title = component->value;
  }
  std::erase_if(channels,
                [](const auto& entry) { return !entry.second.field; });
  return channels;
}

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

Scan scan_of_channel(const GwyChannel& channel, const std::string& name,
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
  Scan scan = scan_of_numbers(grid, std::move(values), "own reader of .gwy",
                              {.unit = scale.height_unit});
  scan.channel = channel.title;
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

} // namespace

Scan read_gwy(const MapBytes& bytes, const ScanRequest& request) {
  const std::string& name = bytes.name();
  const std::map<int, GwyChannel> channels =
      read_gwy_channels(bytes.all(), name);
  const std::size_t chosen =
      chosen_channel(candidates_of(channels), request.channel, name);
  return scan_of_channel(
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

MapFormat gwy_format() {
  return {"gwy",
          {"Gwyddion", "`GWYP`",
           "file; without a unit, `length` or `length_unit`, and "
           "`height_unit`",
           "mask of at least 1/2; NaN", "titles"},
          [](std::string_view bytes) { return bytes.starts_with("GWYP"); },
          read_gwy,
          gwy_channels};
}

} // namespace asperity::surfaces
