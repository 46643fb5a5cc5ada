// The rows of [surface] for measured maps.
#include "input/reader/bound_key.hpp"
#include "surfaces/formats/map_format.hpp"

namespace asperity::cases {
namespace {

using mechanics::MapWindow;
using Surface = mechanics::SurfaceSpec;

std::vector<Key> file_keys() {
  return {
      key<&Surface::file>(
          "file", ValueType::path,
          "File of the map, or of the spectrum with the columns q [1/m], C "
          "[m^4]; the path is relative to the case file's folder.",
          needed("map.txt"))
          .of({"measured", "spectrum"}),
      key<&Surface::format>(
          "format", surfaces::map_format_names(),
          "Format of the map file: recognised by its content, or one of "
          "docs/reference/map-files.md; plain and gwyddion are text, and "
          "convert is any format that the program Gwyddion reads."),
      key<&Surface::channel>(
          "channel", ValueType::text,
          "Title of the channel in the file (its path in an HDF5 file), or its "
          "number from 1; default: the first channel that contains heights.",
          eg("Height")),
      key<&Surface::level>("level",
                           {"none", "plane", "bow", "sphere", "cylinder"},
                           "Form removed from the map: none, the plane (tilt), "
                           "the second-order form (bow, which includes the "
                           "tilt), or a sphere or cylinder of any radius.",
                           needed("plane")),
      key<&Surface::edges>(
          "edges", {"periodic", "window", "mirror", "free"},
          "How the surface continues beyond its border: periodically, "
          "multiplied by a window (maps only, for spectra), by its mirror "
          "images (maps only), or not at all. With free, half-spaces have free "
          "boundaries; methods that need a periodic surface use the mirror "
          "images of a map, and the periodic continuation of other kinds.",
          eg("mirror", "default: mirror for measured maps, else periodic"))
          .of({"measured", "self-affine", "spectrum", "sphere"}),
      key("press_windowed_map", ValueType::boolean,
          "Confirms edges = \"window\": the surface that is pressed then has "
          "9/64 of the measured power.",
          or_else("false", "true")),
  };
}

std::vector<Key> scale_keys() {
  return {
      key<&Surface::height_unit>(
          "height_unit", Dimension::length,
          "Height that corresponds to the number 1 in the file.",
          needed("1 nm",
                 "for files without a unit of height: plain, xyz, npy, hdf5")),
      key<&Surface::length_y>("length_y", Dimension::length,
                              "Side length in y of a map whose file does not "
                              "state it; default: pixels are square.",
                              eg("5 um")),
      key<&Surface::length_unit>(
          "length_unit", Dimension::length,
          "Length that corresponds to the number 1 in the columns x and y of a "
          "list or in the cellsize of an ESRI grid.",
          needed("1 um", "for a list x y z or an ESRI grid")),
      key<&Surface::missing_value>(
          "missing_value", any_number(),
          "Number that the file contains where a point was not measured; in "
          "metres for files that state their units. Without this key, a file "
          "with such a number is refused.",
          eg("-9999")),
  };
}

/// A side or a distance of the part of a map that is used.
template <auto member>
Key crop_key(std::string name, Range range, std::string description,
             Given given) {
  return read_by<Surface>(
      [](TableReader& table, const Key& key, Surface& spec) {
        if (!spec.crop)
          spec.crop.emplace();
        (*spec.crop).*member = table.number(key.name);
      },
      key(std::move(name), {Dimension::length, range}, std::move(description),
          std::move(given)));
}

Key cut_off_key() {
  Key cut_off = read_by<Surface>(
      [](TableReader& table, const Key& key, Surface& spec) {
        const bool is_word =
            table.node().find(key.name)->text == key.words.front();
        spec.cut_off = is_word ? 0.0 : table.number(key.name);
      },
      key("cut_off", Dimension::length,
          "Removes all waves of the levelled map that are shorter than this "
          "wavelength: the noise of the instrument, or roughness that is too "
          "small to matter; \"reliable\": those in the noise floor of its "
          "spectrum, if it has one; default: none are removed.",
          eg("600 nm")));
  cut_off.words = {"reliable"};
  return cut_off;
}

/// Corrections of artefacts, in the order in which they are made.
std::vector<Key> correction_keys() {
  return {
      crop_key<&MapWindow::x>(
          "crop_x", at_least(0),
          "Distance of the part that is used from the first column; default 0.",
          eg("2 um")),
      crop_key<&MapWindow::y>(
          "crop_y", at_least(0),
          "Distance of the part that is used from the first row; default 0.",
          eg("2 um")),
      crop_key<&MapWindow::length_x>(
          "crop_length_x", positive(),
          "Side in x of the part that is used; default: up to the last column.",
          eg("10 um")),
      crop_key<&MapWindow::length_y>(
          "crop_length_y", positive(),
          "Side in y of the part that is used; default: up to the last row.",
          eg("10 um")),
      key<&Surface::align_lines>(
          "align_lines", {"none", "median"},
          "Removes offsets between scan lines (rows) by the median of the "
          "differences of neighbouring lines.",
          eg("median")),
      key<&Surface::spikes>(
          "remove_spikes", at_least(3),
          "Treats points as missing that deviate from the median of their "
          "neighbours by more than this number of robust standard deviations; "
          "default: no spikes are removed.",
          eg("6")),
      key<&Surface::fill>("fill", {"harmonic", "none"},
                          "Fills missing points by the solution of the Laplace "
                          "equation, or refuses a map that has any."),
      key<&Surface::max_missing>("max_missing", Range{0.0, 1.0, true, false},
                                 "Largest fraction of missing points that is "
                                 "filled; a map with more is refused."),
      cut_off_key(),
  };
}

} // namespace

std::vector<Key> map_keys() {
  std::vector<Key> keys = file_keys();
  append_keys(keys, scale_keys());
  append_keys(keys, correction_keys());
  return keys;
}

} // namespace asperity::cases
