#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

const std::vector<mechanics::ReferenceUnit> by_the_grid = {
    mechanics::ReferenceUnit::length, mechanics::ReferenceUnit::spacing};
const std::vector<std::string> random_kinds = {"self-affine", "spectrum"};
const std::vector<std::string> wave_kinds = {"wave-1d", "wave-2d"};

std::vector<Key> kind_and_grid_keys() {
  return {
      {.name = "kind",
       .type = ValueType::word,
       .words = {"self-affine", "spectrum", "measured", "sphere", "wave-1d",
                 "wave-2d", "punch"},
       .need = Need::always,
       .example = "\"self-affine\"",
       .show = Show::yes,
       .description = "Type of surface."},
      {.name = "length",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::conditional,
       .when = "always, except for measured maps whose file states it and for "
               "a theory from a formula alone",
       .example = "\"10 um\"",
       .show = Show::yes,
       .description = "Side length of the periodic square."},
      {.name = "points",
       .type = ValueType::integer,
       .range = between(4, 65536),
       .need = Need::conditional,
       .when = "always, except for measured maps and for a theory from a "
               "formula alone",
       .kinds = {"self-affine", "spectrum", "sphere", "wave-1d", "wave-2d",
                 "punch"},
       .example = "256",
       .show = Show::yes,
       .description =
           "Nodes per side, even; the node spacing is h = length / points."},
  };
}

std::vector<Key> random_keys() {
  return {
      {.name = "seed",
       .type = ValueType::integer,
       .range = at_least(0),
       .need = Need::conditional,
       .when = "always, except for a theory from a formula alone",
       .kinds = random_kinds,
       .example = "7",
       .show = Show::yes,
       .description = "Seed of the random phases: the same seed gives the same "
                      "surface on any grid."},
      {.name = "realizations",
       .type = ValueType::integer,
       .range = between(1, 1000),
       .kinds = random_kinds,
       .fallback = "1",
       .example = "1",
       .show = Show::yes,
       .description = "Number of realisations of the surface, each from its "
                      "own random stream of the seed."},
      {.name = "amplitudes",
       .type = ValueType::word,
       .words = {"spectrum", "gaussian"},
       .kinds = random_kinds,
       .fallback = "\"spectrum\"",
       .example = "\"spectrum\"",
       .description = "Fourier amplitudes: exactly those of the spectrum, or "
                      "Gaussian with the spectrum as their mean square."},
      {.name = "rescale",
       .type = ValueType::boolean,
       .kinds = random_kinds,
       .fallback = "false",
       .example = "false",
       .description =
           "Scale each realisation so that its rms height (or rms slope, where "
           "that is given) equals the spectrum's exactly."},
  };
}

std::vector<Key> self_affine_keys() {
  const std::vector<std::string> kind = {"self-affine"};
  return {
      {.name = "rms_height",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::conditional,
       .when = "this or rms_slope",
       .kinds = kind,
       .example = "\"34 nm\"",
       .show = Show::yes,
       .description = "Root-mean-square height of the whole spectrum."},
      {.name = "rms_slope",
       .range = positive(),
       .need = Need::conditional,
       .when = "this or rms_height",
       .kinds = kind,
       .example = "0.1",
       .description = "Root-mean-square slope: root of <|grad height|^2>, both "
                      "directions included."},
      {.name = "hurst",
       .range = {0.0, 1.0, false, true},
       .need = Need::always,
       .kinds = kind,
       .example = "0.8",
       .show = Show::yes,
       .description =
           "Hurst exponent H: C(q) falls as q^(-2-2H) beyond the roll-off."},
  };
}

struct CutOff {
  std::string wavevector;
  std::string wavelength;
  std::string wavevector_example;
  std::string wavelength_example;
  std::string description; ///< begins with the symbol: "q_L, where ..."
};

void add_cut_off(std::vector<Key>& keys, const CutOff& cut_off) {
  keys.push_back({.name = cut_off.wavevector,
                  .dimension = Dimension::wavevector,
                  .range = positive(),
                  .need = Need::conditional,
                  .when = "this or " + cut_off.wavelength,
                  .kinds = {"self-affine"},
                  .example = cut_off.wavevector_example,
                  .show = Show::no,
                  .description = cut_off.description + "."});
  keys.push_back(
      {.name = cut_off.wavelength,
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::conditional,
       .when = "this or " + cut_off.wavevector,
       .kinds = {"self-affine"},
       .example = cut_off.wavelength_example,
       .show = Show::yes,
       .description = cut_off.description + ", as a wavelength 2 pi / q."});
}

std::vector<Key> round_shape_keys() {
  return {
      {.name = "radius",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::always,
       .kinds = {"sphere", "punch"},
       .example = "\"1 mm\"",
       .show = Show::no,
       .description = "Radius of the sphere, or of the flat end of the punch."},
      {.name = "form_radius",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .when = "default: none, nominally flat",
       .kinds = {"self-affine", "spectrum", "measured"},
       .example = "\"5 length\"",
       .show = Show::no,
       .description =
           "The rough surface lies on a sphere of this radius R, the "
           "paraboloid "
           "-r^2/(2 R) around the centre of the map: a rough ball. All numbers "
           "of the surface, such as its rms height, are those of the sum; "
           "[theory] is refused, because it assumes a nominally flat surface."},
      {.name = "recess",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::always,
       .kinds = {"punch"},
       .example = "\"0.01 length\"",
       .show = Show::no,
       .description = "Depth of the surface around the flat end of the punch, "
                      "which must be larger than its approach."},
      {.name = "tilt",
       .range = between(-0.1, 0.1),
       .kinds = {"punch"},
       .fallback = "0.0",
       .example = "0.001",
       .show = Show::no,
       .description = "Slope of the flat end along x: an eccentric load."},
  };
}

std::vector<Key> wave_keys() {
  return {
      {.name = "amplitude",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::always,
       .kinds = wave_kinds,
       .example = "\"10 nm\"",
       .show = Show::no,
       .description = "Amplitude D of the wave D cos(2 pi x / wavelength), in "
                      "two dimensions times cos(2 pi y / wavelength)."},
      {.name = "wavelength",
       .dimension = Dimension::length,
       .range = positive(),
       .references = by_the_grid,
       .need = Need::always,
       .kinds = wave_kinds,
       .example = "\"1 length\"",
       .show = Show::no,
       .description =
           "Wavelength of the wave; length must be a whole multiple of it."},
  };
}

} // namespace

Table surface_table() {
  Table table{.name = "surface",
              .when = "Always needed.",
              .description = "The rough, rigid surface.",
              .keys = kind_and_grid_keys()};
  append_keys(table.keys, random_keys());
  append_keys(table.keys, self_affine_keys());
  add_cut_off(table.keys,
              {"wavevector_low", "wavelength_long", "\"1.2566e6 1/m\"",
               "\"1 length\"", "q_L, low cut-off wavevector of the spectrum"});
  add_cut_off(table.keys,
              {"wavevector_roll_off", "wavelength_roll_off", "\"2.8274e6 1/m\"",
               "\"0.25 length\"",
               "q_0, roll-off wavevector, below which the spectrum is flat"});
  add_cut_off(table.keys,
              {"wavevector_high", "wavelength_short", "\"8.0425e7 1/m\"",
               "\"8 h\"", "q_1, high cut-off wavevector of the spectrum"});
  append_keys(table.keys, map_keys());
  append_keys(table.keys, round_shape_keys());
  append_keys(table.keys, wave_keys());
  return table;
}

std::string reason_of_kind(const std::string& kind) {
  if (kind == "measured")
    return "the file determines the points, and nothing in it is random";
  if (kind == "sphere" || kind == "wave-1d" || kind == "wave-2d" ||
      kind == "punch")
    return "the shape is exact and nothing in it is random";
  return "";
}

} // namespace asperity::cases
