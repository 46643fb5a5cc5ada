#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

std::vector<Key> file_keys() {
  const std::vector<std::string> kind = {"measured"};
  return {
      {.name = "file",
       .type = ValueType::path,
       .need = Need::always,
       .kinds = {"measured", "spectrum"},
       .example = "\"map.txt\"",
       .show = Show::no,
       .description =
           "File of the map, or of the spectrum with the columns q [1/m], C "
           "[m^4]; the path is relative to the case file's folder."},
      {.name = "format",
       .type = ValueType::word,
       .words = {"auto", "plain", "gwyddion", "xyz", "sdf", "x3p", "npy",
                 "hdf5", "gwy", "sur", "wsxm", "convert"},
       .kinds = kind,
       .fallback = "\"auto\"",
       .example = "\"auto\"",
       .show = Show::no,
       .description = "Format of the map file: recognised by its content, or "
                      "one of docs/reference/map-files.md; plain and gwyddion "
                      "are text, and convert is any format that the program "
                      "Gwyddion reads."},
      {.name = "channel",
       .type = ValueType::text,
       .kinds = kind,
       .example = "\"Height\"",
       .show = Show::no,
       .description = "Title of the channel in the file (its path in an HDF5 "
                      "file), or its number from 1; default: the first channel "
                      "that contains heights."},
      {.name = "level",
       .type = ValueType::word,
       .words = {"none", "plane", "bow", "sphere", "cylinder"},
       .need = Need::always,
       .kinds = kind,
       .example = "\"plane\"",
       .show = Show::no,
       .description = "Form removed from the map: none, the plane (tilt), the "
                      "second-order form (bow, which includes the tilt), or a "
                      "sphere or cylinder of any radius."},
  };
}

std::vector<Key> edge_keys() {
  const std::vector<std::string> kind = {"measured"};
  return {
      {.name = "edges",
       .type = ValueType::word,
       .words = {"periodic", "window", "mirror", "free"},
       .when = "default: mirror for measured maps, else periodic",
       .kinds = {"measured", "self-affine", "spectrum", "sphere"},
       .example = "\"mirror\"",
       .show = Show::no,
       .description =
           "How the surface continues beyond its border: periodically, "
           "multiplied by a window (maps only, for spectra), by its mirror "
           "images (maps only), or not at all. With free, half-spaces have "
           "free "
           "boundaries; methods that need a periodic surface use the mirror "
           "images of a map, and the periodic continuation of other kinds."},
      {.name = "press_windowed_map",
       .type = ValueType::boolean,
       .kinds = kind,
       .fallback = "false",
       .example = "true",
       .show = Show::no,
       .description = "Confirms edges = \"window\": the surface that is "
                      "pressed then has 9/64 of the measured power."},
  };
}

std::vector<Key> scale_keys() {
  const std::vector<std::string> kind = {"measured"};
  return {
      {.name = "height_unit",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::conditional,
       .when = "for files without a unit of height: plain, xyz, npy, hdf5",
       .kinds = kind,
       .example = "\"1 nm\"",
       .show = Show::no,
       .description = "Height that corresponds to the number 1 in the file."},
      {.name = "length_y",
       .dimension = Dimension::length,
       .range = positive(),
       .kinds = kind,
       .example = "\"5 um\"",
       .show = Show::no,
       .description = "Side length in y of a map whose file does not state it; "
                      "default: pixels are square."},
      {.name = "length_unit",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::conditional,
       .when = "for a list x y z or an ESRI grid",
       .kinds = kind,
       .example = "\"1 um\"",
       .show = Show::no,
       .description = "Length that corresponds to the number 1 in the columns "
                      "x and y of a list or in the cellsize of an ESRI grid."},
      {.name = "missing_value",
       .kinds = kind,
       .example = "-9999",
       .show = Show::no,
       .description =
           "Number that the file contains where a point was not measured; in "
           "metres for files that state their units. Without this key, a file "
           "with such a number is refused."},
  };
}

/// Corrections of artefacts, in the order in which they are made.
std::vector<Key> correction_keys() {
  const std::vector<std::string> kind = {"measured"};
  const auto crop_key = [&](const char* name, const char* example, Range range,
                            const char* description) {
    return Key{.name = name,
               .dimension = Dimension::length,
               .range = range,
               .kinds = kind,
               .example = example,
               .show = Show::no,
               .description = description};
  };
  return {
      crop_key("crop_x", "\"2 um\"", at_least(0),
               "Distance of the part that is used from the first column; "
               "default 0."),
      crop_key("crop_y", "\"2 um\"", at_least(0),
               "Distance of the part that is used from the first row; default "
               "0."),
      crop_key("crop_length_x", "\"10 um\"", positive(),
               "Side in x of the part that is used; default: up to the last "
               "column."),
      crop_key("crop_length_y", "\"10 um\"", positive(),
               "Side in y of the part that is used; default: up to the last "
               "row."),
      {.name = "align_lines",
       .type = ValueType::word,
       .words = {"none", "median"},
       .kinds = kind,
       .fallback = "\"none\"",
       .example = "\"median\"",
       .show = Show::no,
       .description = "Removes offsets between scan lines (rows) by the median "
                      "of the differences of neighbouring lines."},
      {.name = "remove_spikes",
       .range = at_least(3),
       .kinds = kind,
       .example = "6",
       .show = Show::no,
       .description = "Treats points as missing that deviate from the median "
                      "of their neighbours by more than this number of robust "
                      "standard deviations; default: no spikes are removed."},
      {.name = "fill",
       .type = ValueType::word,
       .words = {"harmonic", "none"},
       .kinds = kind,
       .fallback = "\"harmonic\"",
       .example = "\"harmonic\"",
       .show = Show::no,
       .description = "Fills missing points by the solution of the Laplace "
                      "equation, or refuses a map that has any."},
      {.name = "max_missing",
       .range = {0.0, 1.0, true, false},
       .kinds = kind,
       .fallback = "0.05",
       .example = "0.05",
       .show = Show::no,
       .description = "Largest fraction of missing points that is filled; a "
                      "map with more is refused."},
  };
}

} // namespace

std::vector<Key> map_keys() {
  std::vector<Key> keys = file_keys();
  append_keys(keys, edge_keys());
  append_keys(keys, scale_keys());
  append_keys(keys, correction_keys());
  return keys;
}

} // namespace asperity::cases
