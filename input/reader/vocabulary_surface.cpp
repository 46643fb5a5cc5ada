// The rows of [surface].
#include "input/reader/bound_key.hpp"

#include <numbers>

namespace asperity::cases {
namespace {

using Surface = mechanics::SurfaceSpec;

/// Returns a length in metres; the reference units "length" and "h" are
/// converted here. 0 if these were not read.
double metres_of(TableReader& table, const Key& key, const Surface& spec) {
  const mechanics::Quantity quantity = table.quantity(key.name);
  if (quantity.reference == mechanics::ReferenceUnit::si)
    return quantity.value;
  const bool is_by_spacing =
      quantity.reference == mechanics::ReferenceUnit::spacing;
  if (!table.has("length") || (is_by_spacing && !table.has("points")))
    table.refuse(*table.node().find(key.name),
                 is_by_spacing ? "h needs surface.length and surface.points"
                               : "this needs surface.length");
  const double length = spec.length.value_or(0.0);
  const double points = is_by_spacing ? spec.points.value_or(0) : 1.0;
  if (length <= 0.0 || points <= 0.0)
    return 0.0; // reported here or where the values were read
  return quantity.in_si(
      {.length = length, .spacing = is_by_spacing ? length / points : 0.0});
}

/// A length that is a member in metres.
template <auto member>
Key metres(std::string name, std::string description, Given given) {
  return read_by<Surface>(
      [](TableReader& table, const Key& key, Surface& spec) {
        spec.*member = metres_of(table, key, spec);
      },
      key<member>(std::move(name), by_the_grid(), std::move(description),
                  std::move(given)));
}

/// Two keys for a wavevector q [rad/m], the second one of which is the
/// wavelength 2 pi/q.
/// @param description  begins with the symbol: "q_L, where ..."
template <auto member>
std::vector<Key> cut_off_keys(const std::string& wavevector,
                              const std::string& wavelength,
                              const std::string& description,
                              const std::string& wavevector_example,
                              const std::string& wavelength_example) {
  const auto read_wavelength = [](TableReader& table, const Key& key,
                                  Surface& spec) {
    if (spec.*member != 0.0)
      return; // given by its wavevector
    const double length = metres_of(table, key, spec);
    spec.*member = length > 0.0 ? 2.0 * std::numbers::pi / length : 0.0;
  };
  return {key<member>(wavevector, Dimension::wavevector, description + ".",
                      needed(wavevector_example, "this or " + wavelength)),
          read_by<Surface>(
              read_wavelength,
              key<member>(wavelength, by_the_grid(),
                          description + ", as a wavelength 2 pi / q.",
                          needed(wavelength_example, "this or " + wavevector)))
              .shown()};
}

void read_seed(TableReader& table, const Key& key, Surface& spec) {
  const Node& seed = *table.node().find(key.name);
  if (seed.type != NodeType::integer || seed.integer < 0)
    table.refuse(seed, "must be a whole number >= 0");
  spec.seed = static_cast<std::uint64_t>(seed.integer);
}

std::vector<Key> kind_and_grid_keys() {
  return {
      key<&Surface::kind>("kind",
                          {"self-affine", "spectrum", "measured", "sphere",
                           "wave-1d", "wave-2d", "punch", "cone",
                           "rounded-punch"},
                          "Type of surface.", needed("self-affine"))
          .shown(),
      key<&Surface::length>(
          "length", Dimension::length, "Side length of the periodic square.",
          needed("10 um", "always, except for measured maps whose file states "
                          "it and for a theory from a formula alone"))
          .shown(),
      key<&Surface::points>(
          "points", between(4, 65536),
          "Nodes per side, even; the node spacing is h = length / points.",
          needed("256", "always, except for measured maps and for a theory "
                        "from a formula alone"))
          .of({"self-affine", "spectrum", "sphere", "wave-1d", "wave-2d",
               "punch", "cone", "rounded-punch"})
          .shown(),
  };
}

std::vector<Key> random_keys() {
  return {
      read_by<Surface>(
          read_seed,
          key<&Surface::seed>(
              "seed", at_least(0),
              "Seed of the random phases: the same seed gives the same surface "
              "on any grid.",
              needed("7", "always, except for a theory from a formula alone")))

          .shown(),
      key<&Surface::realizations>("realizations", between(1, 1000),
                                  "Number of realisations of the surface, each "
                                  "from its own random stream of the seed.")

          .shown(),
      key<&Surface::amplitudes>(
          "amplitudes", {"spectrum", "gaussian"},
          "Fourier amplitudes: exactly those of the spectrum, or Gaussian with "
          "the spectrum as their mean square."),
      key<&Surface::rescale>(
          "rescale", ValueType::boolean,
          "Scale each realisation so that its rms height (or rms slope, where "
          "that is given) equals the spectrum's exactly."),
  };
}

std::vector<Key> self_affine_keys() {
  return {
      metres<&Surface::rms_height>(
          "rms_height", "Root-mean-square height of the whole spectrum.",
          needed("34 nm", "this or rms_slope"))

          .shown(),
      key<&Surface::rms_slope>("rms_slope", positive(),
                               "Root-mean-square slope: root of <|grad "
                               "height|^2>, both directions included.",
                               needed("0.1", "this or rms_height")),
      key<&Surface::hurst>(
          "hurst", Range{0.0, 1.0, false, true},
          "Hurst exponent H: C(q) falls as q^(-2-2H) beyond the roll-off.",
          needed("0.8"))

          .shown(),
  };
}

std::vector<Key> all_cut_off_keys() {
  std::vector<Key> keys = cut_off_keys<&Surface::wavevector_low>(
      "wavevector_low", "wavelength_long",
      "q_L, low cut-off wavevector of the spectrum", "1.2566e6 1/m",
      "1 length");
  append_keys(keys,
              cut_off_keys<&Surface::wavevector_roll_off>(
                  "wavevector_roll_off", "wavelength_roll_off",
                  "q_0, roll-off wavevector, below which the spectrum is flat",
                  "2.8274e6 1/m", "0.25 length"));
  append_keys(keys, cut_off_keys<&Surface::wavevector_high>(
                        "wavevector_high", "wavelength_short",
                        "q_1, high cut-off wavevector of the spectrum",
                        "8.0425e7 1/m", "8 h"));
  return keys;
}

std::vector<Key> round_shape_keys() {
  return {
      metres<&Surface::radius>(
          "radius", "Radius of the sphere, or of the flat end of the punch.",
          needed("1 mm"))
          .of({"sphere", "punch", "rounded-punch"}),
      key<&Surface::slope>("slope", positive(),
                           "Slope of the flank of the cone: its height is "
                           "-slope r.",
                           needed("0.1"))
          .of({"cone"}),
      metres<&Surface::edge_radius>(
          "edge_radius",
          "R of the rounded edge: at the distance r from the middle, beyond "
          "the flat end, the height is -(r - radius)^2/(2 R).",
          needed("1 mm"))
          .of({"rounded-punch"}),
      metres<&Surface::form_radius>(
          "form_radius",
          "The rough surface lies on a sphere of this radius R, the paraboloid "
          "-r^2/(2 R) around the centre of the map: a rough ball. All numbers "
          "of the surface, such as its rms height, are those of the sum; "
          "[theory] is refused, because it assumes a nominally flat surface.",
          eg("5 length", "default: none, nominally flat"))
          .of({"self-affine", "spectrum", "measured"}),
      metres<&Surface::recess>(
          "recess",
          "Depth of the surface around the flat end of the punch, which must "
          "be larger than its approach.",
          needed("0.01 length"))
          .of({"punch"}),
      key<&Surface::tilt>("tilt", between(-0.1, 0.1),
                          "Slope of the flat end along x: an eccentric load.",
                          eg("0.001"))
          .of({"punch"}),
  };
}

std::vector<Key> wave_keys() {
  return {
      metres<&Surface::amplitude>(
          "amplitude",
          "Amplitude D of the wave D cos(2 pi x / wavelength), in two "
          "dimensions times cos(2 pi y / wavelength).",
          needed("10 nm")),
      metres<&Surface::wavelength>(
          "wavelength",
          "Wavelength of the wave; length must be a whole multiple of it.",
          needed("1 length")),
  };
}

} // namespace

Table surface_table() {
  Table table{.name = "surface",
              .when = "Always needed.",
              .description = "The rough, rigid surface.",
              .keys = kind_and_grid_keys()};
  append_keys(table.keys, of({"self-affine", "spectrum"}, random_keys()));
  append_keys(table.keys, of({"self-affine"}, self_affine_keys()));
  append_keys(table.keys, of({"self-affine"}, hidden(all_cut_off_keys())));
  append_keys(table.keys, of({"measured"}, hidden(map_keys())));
  append_keys(table.keys, hidden(round_shape_keys()));
  append_keys(table.keys, of({"wave-1d", "wave-2d"}, hidden(wave_keys())));
  return table;
}

std::string reason_of_kind(const std::string& kind) {
  if (kind == "measured")
    return "the file determines the points, and nothing in it is random";
  if (kind == "sphere" || kind == "wave-1d" || kind == "wave-2d" ||
      kind == "punch" || kind == "cone" || kind == "rounded-punch")
    return "the shape is exact and nothing in it is random";
  return "";
}

} // namespace asperity::cases
