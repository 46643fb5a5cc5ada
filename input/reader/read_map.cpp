#include "input/reader/read_parts.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <vector>

namespace asperity::cases {
namespace {

/// Requires an explicit confirmation for a windowed map, because its surface
/// differs from the measured one.
void check_window(TableReader& table, const mechanics::SurfaceSpec& spec) {
  const bool is_confirmed =
      table.has("press_windowed_map") && table.boolean("press_windowed_map");
  if (spec.edges == mechanics::Edges::window && !is_confirmed)
    table.refuse(
        table.said_by("edges"),
        "this needs press_windowed_map = true: a window is meant for spectra, "
        "and the windowed map has 9/64 of the measured power and about 3/8 of "
        "the rms height and slope; edges = \"mirror\" preserves both");
  if (spec.edges != mechanics::Edges::window && is_confirmed)
    table.refuse(table.said_by("press_windowed_map"),
                 "this key applies only to edges = \"window\"");
}

} // namespace

void check_map(TableReader& table, const mechanics::SurfaceSpec& spec) {
  check_window(table, spec);
  using surfaces::FileScales;
  const FileScales scales =
      spec.format == "auto" ? FileScales::some
                            : surfaces::map_format_called(spec.format).scales;
  if (scales == FileScales::none)
    for (const char* const key : {"length", "height_unit"})
      if (!table.has(key))
        table.complain_missing(
            key, fmt::format(", which a {} map does not contain", spec.format));
  std::vector<const char*> keys;
  if (scales == FileScales::lengths || scales == FileScales::all)
    keys = {"length", "length_y", "length_unit"};
  if (scales == FileScales::all)
    keys.push_back("height_unit");
  for (const char* const key : keys)
    if (table.has(key))
      table.refuse(table.said_by(key),
                   fmt::format("a {} map contains it: remove this key",
                               table.said_by("format").text));
}

} // namespace asperity::cases
