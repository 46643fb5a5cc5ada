#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::cases {
namespace {

// Relative tolerance for two numbers that are given with five digits.
constexpr double printed_rounding = 1e-4;

/// Reads [surface] in order, because a relative length needs values that were
/// read before.
struct SurfaceReader {
  TableReader table;
  mechanics::SurfaceSpec spec;
  bool is_built; ///< whether a method needs a realisation

  void complain_where_meaningless();
  void read_grid();
  double length_of(const std::string& key);
  double wavevector_of(const std::string& wavevector,
                       const std::string& wavelength);
  void read_random();
  void read_self_affine();
  void check_order(const std::string& low, double q_low,
                   const std::string& high, double q_high);
  void check_wavevectors();
  void read_edges();
  void read_wave();
  void read_punch();
  const Node& node_of(const std::string& wavevector,
                      const std::string& wavelength) const;
};

// Reports keys that belong to other kinds of surfaces, and why they do not
// apply here.
void SurfaceReader::complain_where_meaningless() {
  const std::string kind = table.node().find("kind")->text;
  std::string reason = reason_of_kind(kind);
  if (!reason.empty())
    reason = " (" + reason + ")";
  for (const NodeEntry& entry : table.node().entries)
    for (const Key& key : vocabulary_table("surface").keys)
      if (key.name == entry.key && !key.kinds.empty() &&
          std::find(key.kinds.begin(), key.kinds.end(), kind) ==
              key.kinds.end())
        table.complain(
            entry.node,
            fmt::format(
                "= {} does not apply to kind = \"{}\"{}; it belongs to {}",
                written(entry.node), kind, reason, fmt::join(key.kinds, ", ")));
}

void SurfaceReader::read_grid() {
  const bool is_map = spec.kind == mechanics::SurfaceKind::measured;
  if (table.has("length")) {
    if (const double length = table.number("length"); length > 0.0)
      spec.length = length;
  } else if (is_built && !is_map)
    table.complain_missing("length");
  if (is_map)
    return;
  if (table.has("points")) {
    const int points = table.integer("points");
    if (points % 2 != 0)
      table.refuse(*table.node().find("points"), "must be even");
    if (points > 0)
      spec.points = points;
  } else if (is_built) {
    table.complain_missing("points");
  }
}

// Returns a length in metres; the reference units "length" and "h" are
// converted here.
double SurfaceReader::length_of(const std::string& key) {
  const mechanics::Quantity quantity = table.quantity(key);
  if (quantity.reference == mechanics::ReferenceUnit::si)
    return quantity.value;
  const bool is_by_spacing =
      quantity.reference == mechanics::ReferenceUnit::spacing;
  if (!table.has("length") || (is_by_spacing && !table.has("points")))
    table.refuse(*table.node().find(key), is_by_spacing
                                              ? "h needs surface.length and "
                                                "surface.points"
                                              : "this needs surface.length");
  if (!spec.length || (is_by_spacing && !spec.points))
    return 0.0; // reported here or where the values were read
  return quantity.in_si(
      {.length = *spec.length,
       .spacing = is_by_spacing ? *spec.length / *spec.points : 0.0});
}

const Node& SurfaceReader::node_of(const std::string& wavevector,
                                   const std::string& wavelength) const {
  const Node* const direct = table.node().find(wavevector);
  return direct ? *direct : *table.node().find(wavelength);
}

/// Returns the wavevector q [rad/m] from either key, q = 2 pi / wavelength; 0
/// after reporting a mistake.
double SurfaceReader::wavevector_of(const std::string& wavevector,
                                    const std::string& wavelength) {
  if (table.has(wavevector) && table.has(wavelength))
    table.refuse_both(wavevector, wavelength);
  if (table.has(wavevector))
    return table.number(wavevector);
  if (!table.has(wavelength)) {
    table.complain_missing(wavevector, " (or " + wavelength + ")");
    return 0.0;
  }
  const double metres = length_of(wavelength);
  return metres > 0.0 ? 2.0 * std::numbers::pi / metres : 0.0;
}

void SurfaceReader::read_random() {
  read_edges();
  if (table.has("seed")) {
    const Node& seed = *table.node().find("seed");
    if (seed.type != NodeType::integer || seed.integer < 0)
      table.refuse(seed, "must be a whole number >= 0");
    spec.seed = static_cast<std::uint64_t>(seed.integer);
  } else if (is_built) {
    table.complain_missing("seed");
  }
  spec.realizations = table.integer("realizations");
  spec.amplitudes = table.choice("amplitudes", spec.amplitudes);
  spec.rescale = table.boolean("rescale");
}

void SurfaceReader::read_self_affine() {
  if (table.has("rms_height") && table.has("rms_slope"))
    table.refuse_both("rms_height", "rms_slope");
  if (table.has("rms_slope"))
    spec.rms_slope = table.number("rms_slope");
  else if (table.has("rms_height"))
    spec.rms_height = length_of("rms_height");
  else
    table.complain_missing("rms_height", " (or rms_slope)");
  spec.hurst = table.number("hurst");
  spec.wavevector_low = wavevector_of("wavevector_low", "wavelength_long");
  spec.wavevector_roll_off =
      wavevector_of("wavevector_roll_off", "wavelength_roll_off");
  spec.wavevector_high = wavevector_of("wavevector_high", "wavelength_short");
  check_wavevectors();
}

void SurfaceReader::check_order(const std::string& low, double q_low,
                                const std::string& high, double q_high) {
  if (q_low <= q_high * (1.0 + printed_rounding))
    return;
  table.complain(
      table.node(),
      fmt::format("has its wavevectors in the wrong order: {} = {:.6g} 1/m, "
                  "but must not exceed {} = {:.6g} 1/m",
                  low, q_low, high, q_high));
}

void SurfaceReader::check_wavevectors() {
  const double low = spec.wavevector_low;
  const double roll_off = spec.wavevector_roll_off;
  const double high = spec.wavevector_high;
  if (low <= 0.0 || roll_off <= 0.0 || high <= 0.0)
    return;
  check_order("q_L", low, "q_0", roll_off);
  check_order("q_0", roll_off, "q_1", high);
  if (!spec.length)
    return;
  const double longest = 2.0 * std::numbers::pi / *spec.length;
  if (low < longest * (1.0 - printed_rounding))
    table.refuse(
        node_of("wavevector_low", "wavelength_long"),
        fmt::format(
            "the longest wavelength that fits is \"1 length\", {:.7g} 1/m",
            longest));
  if (!spec.points)
    return;
  const double nyquist = std::numbers::pi * *spec.points / *spec.length;
  if (high > nyquist * (1.0 + printed_rounding))
    table.refuse(
        node_of("wavevector_high", "wavelength_short"),
        fmt::format(
            "the shortest wavelength of the grid is \"2 h\", {:.7g} 1/m",
            nyquist));
}

/// Reads the edges of a surface that is periodic by itself.
void SurfaceReader::read_edges() {
  if (!table.has("edges"))
    return;
  spec.edges = table.choice("edges", spec.edges);
  if (spec.edges == mechanics::Edges::window ||
      spec.edges == mechanics::Edges::mirror)
    table.refuse(*table.node().find("edges"),
                 "only a measured map is continued in this way; allowed here: "
                 "\"periodic\", \"free\"");
}

void SurfaceReader::read_wave() {
  spec.amplitude = length_of("amplitude");
  spec.wavelength = length_of("wavelength");
  if (!spec.length || spec.wavelength <= 0.0)
    return;
  const double waves = *spec.length / spec.wavelength;
  if (std::abs(waves - std::round(waves)) > printed_rounding * waves)
    table.refuse(*table.node().find("wavelength"),
                 fmt::format("surface.length must be a whole multiple of it, "
                             "but is {:.7g} times it",
                             waves));
  else if (spec.points && 2.0 * std::round(waves) >= *spec.points)
    table.refuse(*table.node().find("wavelength"),
                 fmt::format("must be more than \"2 h\", {:.7g} m: the grid "
                             "does not resolve it",
                             2.0 * *spec.length / *spec.points));
}

void SurfaceReader::read_punch() {
  spec.radius = length_of("radius");
  spec.recess = length_of("recess");
  spec.tilt = table.number("tilt");
  const Node* const radius = table.node().find("radius");
  if (radius != nullptr && spec.length && 2.0 * spec.radius >= *spec.length)
    table.refuse(*radius, "must be less than half of length");
  const Node* const tilt = table.node().find("tilt");
  if (tilt != nullptr && std::abs(spec.tilt) * spec.radius >= spec.recess)
    table.refuse(*tilt, "must be less than recess over radius");
}

} // namespace

mechanics::SurfaceSpec read_surface(const Node& node, const std::string& folder,
                                    bool is_surface_built, Mistakes& mistakes) {
  SurfaceReader reader{
      {node, vocabulary_table("surface"), mistakes}, {}, is_surface_built};
  reader.table.refuse_unknown();
  const std::optional<int> kind = reader.table.word("kind");
  if (!kind)
    return {}; // the meaning of the other keys is unknown
  reader.spec.kind = static_cast<mechanics::SurfaceKind>(*kind);
  reader.complain_where_meaningless();
  reader.read_grid();
  switch (reader.spec.kind) {
  case mechanics::SurfaceKind::self_affine:
    reader.read_random();
    reader.read_self_affine();
    break;
  case mechanics::SurfaceKind::spectrum:
    reader.read_random();
    break;
  case mechanics::SurfaceKind::measured:
    read_map(reader.table, reader.spec);
    break;
  case mechanics::SurfaceKind::sphere:
    reader.read_edges();
    reader.spec.radius = reader.length_of("radius");
    break;
  case mechanics::SurfaceKind::punch:
    reader.read_punch();
    break;
  case mechanics::SurfaceKind::wave_1d:
  case mechanics::SurfaceKind::wave_2d:
    reader.read_wave();
    break;
  }
  if (reader.table.has("form_radius"))
    reader.spec.form_radius = reader.length_of("form_radius");
  if (reader.spec.kind == mechanics::SurfaceKind::measured ||
      reader.spec.kind == mechanics::SurfaceKind::spectrum)
    reader.spec.file = reader.table.path("file", folder);
  return reader.spec;
}

} // namespace asperity::cases
