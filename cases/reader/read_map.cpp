#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace asperity::cases {
namespace {

/// Requires an explicit confirmation for a windowed map, because its surface
/// differs from the measured one.
void read_window(TableReader& table, const mechanics::SurfaceSpec& spec) {
  const bool is_confirmed = table.boolean("press_windowed_map");
  const Node* const edges = table.node().find("edges");
  if (spec.edges == mechanics::Edges::window && !is_confirmed)
    table.refuse(
        *edges,
        "this needs press_windowed_map = true: a window is meant for spectra, "
        "and the windowed map has 9/64 of the measured power and about 3/8 of "
        "the rms height and slope; edges = \"mirror\" preserves both");
  if (spec.edges != mechanics::Edges::window && is_confirmed)
    table.refuse(*table.node().find("press_windowed_map"),
                 "this key applies only to edges = \"window\"");
}

/// Reads the part of the map that is used; a side that is not given reaches to
/// the end of the map.
void read_crop(TableReader& table, mechanics::SurfaceSpec& spec) {
  mechanics::MapWindow window;
  bool is_cropped = false;
  for (const auto& [key, value] :
       {std::pair("crop_x", &window.x), std::pair("crop_y", &window.y),
        std::pair("crop_length_x", &window.length_x),
        std::pair("crop_length_y", &window.length_y)})
    if (table.has(key)) {
      *value = table.number(key);
      is_cropped = true;
    }
  if (is_cropped)
    spec.crop = window;
}

void read_corrections(TableReader& table, mechanics::SurfaceSpec& spec) {
  read_crop(table, spec);
  spec.align_lines = table.choice("align_lines", spec.align_lines);
  if (table.has("remove_spikes"))
    spec.spikes = table.number("remove_spikes");
  spec.fill = table.choice("fill", spec.fill);
  if (table.has("max_missing"))
    spec.max_missing = table.number("max_missing");
}

} // namespace

void read_map(TableReader& table, mechanics::SurfaceSpec& spec) {
  spec.format = table.choice("format", spec.format);
  spec.level = table.choice("level", spec.level);
  spec.edges = mechanics::Edges::mirror;
  if (table.has("edges"))
    spec.edges = table.choice("edges", spec.edges);
  read_window(table, spec);
  if (table.has("channel"))
    spec.channel = table.text("channel");
  for (const auto& [key, value] :
       {std::pair("height_unit", &spec.height_unit),
        std::pair("length_y", &spec.length_y),
        std::pair("length_unit", &spec.length_unit),
        std::pair("missing_value", &spec.missing_value)})
    if (table.has(key))
      *value = table.number(key);
  read_corrections(table, spec);
  if (spec.format == mechanics::MapFormat::plain) {
    if (!spec.length)
      table.complain_missing("length", ", which a plain map does not contain");
    if (!spec.height_unit)
      table.complain_missing("height_unit",
                             ", which a plain map does not contain");
  }
  using enum mechanics::MapFormat;
  const bool has_units = spec.format == sdf || spec.format == x3p ||
                         spec.format == sur || spec.format == wsxm;
  if (!has_units && spec.format != gwyddion)
    return; // whose files need not have them; the readers know
  std::vector<const char*> keys{"length", "length_y", "length_unit"};
  if (has_units)
    keys.push_back("height_unit");
  for (const char* const key : keys)
    if (table.has(key))
      table.refuse(*table.node().find(key),
                   fmt::format("a {} map contains it: remove this key",
                               table.node().find("format")->text));
}

} // namespace asperity::cases
