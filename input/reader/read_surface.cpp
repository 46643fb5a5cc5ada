// Reads [surface] and checks what its keys need of each other.
#include "input/reader/read_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

namespace asperity::cases {
namespace {

// Relative tolerance for two numbers that are given with five digits.
constexpr double printed_rounding = 1e-4;

/// The keys of a wavevector and of the wavelength that can replace it.
struct CutOffKeys {
  const char* wavevector;
  const char* wavelength;
};

constexpr CutOffKeys low_keys{"wavevector_low", "wavelength_long"};
constexpr CutOffKeys roll_off_keys{"wavevector_roll_off",
                                   "wavelength_roll_off"};
constexpr CutOffKeys high_keys{"wavevector_high", "wavelength_short"};

// Reports keys that belong to other kinds of surfaces, and why they do not
// apply here.
void complain_where_meaningless(TableReader& table) {
  const std::string kind = table.node().find("kind")->text;
  std::string reason = reason_of_kind(kind);
  if (!reason.empty())
    reason = " (" + reason + ")";
  for (const NodeEntry& entry : table.node().entries)
    for (const Key& key : vocabulary_table("surface").keys)
      if (key.name == entry.key && !key.applies_to(kind))
        table.complain(
            entry.node,
            fmt::format(
                "= {} does not apply to kind = \"{}\"{}; it belongs to {}",
                written(entry.node), kind, reason, fmt::join(key.kinds, ", ")));
}

void check_grid(TableReader& table, bool is_built,
                mechanics::SurfaceSpec& spec) {
  if (spec.length.value_or(1.0) <= 0.0)
    spec.length.reset(); // reported where it was read
  if (spec.points.value_or(1) <= 0)
    spec.points.reset();
  if (spec.kind == mechanics::SurfaceKind::measured)
    return;
  if (is_built)
    table.require("length");
  if (spec.points.value_or(0) % 2 != 0)
    table.refuse(table.said_by("points"), "must be even");
  if (is_built)
    table.require("points");
}

/// Requires one of two keys.
void check_either(TableReader& table, const std::string& first,
                  const std::string& second) {
  if (table.has(first) && table.has(second))
    table.refuse_both(first, second);
  if (!table.has(first) && !table.has(second))
    table.complain_missing(first, " (or " + second + ")");
}

void check_order(TableReader& table, const char* low, double q_low,
                 const char* high, double q_high) {
  if (q_low <= q_high * (1.0 + printed_rounding))
    return;
  table.complain(
      table.node(),
      fmt::format("has its wavevectors in the wrong order: {} = {:.6g} 1/m, "
                  "but must not exceed {} = {:.6g} 1/m",
                  low, q_low, high, q_high));
}

void check_wavevectors(TableReader& table, const mechanics::SurfaceSpec& spec) {
  const auto node_of = [&](const CutOffKeys& keys) -> const Node& {
    return table.said_by(table.has(keys.wavevector) ? keys.wavevector
                                                    : keys.wavelength);
  };
  const double low = spec.wavevector_low;
  const double roll_off = spec.wavevector_roll_off;
  const double high = spec.wavevector_high;
  if (low <= 0.0 || roll_off <= 0.0 || high <= 0.0)
    return;
  check_order(table, "q_L", low, "q_0", roll_off);
  check_order(table, "q_0", roll_off, "q_1", high);
  if (!spec.length)
    return;
  const double longest = 2.0 * std::numbers::pi / *spec.length;
  if (low < longest * (1.0 - printed_rounding))
    table.refuse(
        node_of(low_keys),
        fmt::format(
            "the longest wavelength that fits is \"1 length\", {:.7g} 1/m",
            longest));
  if (!spec.points)
    return;
  const double nyquist = std::numbers::pi * *spec.points / *spec.length;
  if (high > nyquist * (1.0 + printed_rounding))
    table.refuse(
        node_of(high_keys),
        fmt::format(
            "the shortest wavelength of the grid is \"2 h\", {:.7g} 1/m",
            nyquist));
}

void check_self_affine(TableReader& table, const mechanics::SurfaceSpec& spec) {
  check_either(table, "rms_height", "rms_slope");
  for (const CutOffKeys& keys : {low_keys, roll_off_keys, high_keys})
    check_either(table, keys.wavevector, keys.wavelength);
  check_wavevectors(table, spec);
}

/// Checks the edges of a surface that is periodic by itself.
void check_edges(TableReader& table, const mechanics::SurfaceSpec& spec) {
  if (spec.edges == mechanics::Edges::window ||
      spec.edges == mechanics::Edges::mirror)
    table.refuse(table.said_by("edges"),
                 "only a measured map is continued in this way; allowed here: "
                 "\"periodic\", \"free\"");
}

void check_wave(TableReader& table, const mechanics::SurfaceSpec& spec) {
  if (!spec.length || spec.wavelength <= 0.0)
    return;
  const double waves = *spec.length / spec.wavelength;
  if (std::abs(waves - std::round(waves)) > printed_rounding * waves)
    table.refuse(table.said_by("wavelength"),
                 fmt::format("surface.length must be a whole multiple of it, "
                             "but is {:.7g} times it",
                             waves));
  else if (spec.points && 2.0 * std::round(waves) >= *spec.points)
    table.refuse(table.said_by("wavelength"),
                 fmt::format("must be more than \"2 h\", {:.7g} m: the grid "
                             "does not resolve it",
                             2.0 * *spec.length / *spec.points));
}

void check_punch(TableReader& table, const mechanics::SurfaceSpec& spec) {
  if (table.has("radius") && spec.length && 2.0 * spec.radius >= *spec.length)
    table.refuse(table.said_by("radius"), "must be less than half of length");
  if (table.has("tilt") && std::abs(spec.tilt) * spec.radius >= spec.recess)
    table.refuse(table.said_by("tilt"), "must be less than recess over radius");
}

} // namespace

mechanics::SurfaceSpec read_surface(TableReader table, bool is_surface_built) {
  using enum mechanics::SurfaceKind;
  const std::optional<int> kind = table.word("kind");
  if (!kind)
    return {}; // the meaning of the other keys is unknown
  mechanics::SurfaceSpec spec;
  spec.kind = static_cast<mechanics::SurfaceKind>(*kind);
  complain_where_meaningless(table);
  if (spec.kind == measured)
    spec.edges = mechanics::Edges::mirror;
  table.read(spec);
  check_grid(table, is_surface_built, spec);
  if (spec.kind == measured)
    check_map(table, spec);
  else
    check_edges(table, spec);
  if (is_surface_built && (spec.kind == self_affine || spec.kind == spectrum))
    table.require("seed");
  if (spec.kind == self_affine)
    check_self_affine(table, spec);
  else if (spec.kind == punch || spec.kind == rounded_punch)
    check_punch(table, spec);
  else if (spec.kind == wave_1d || spec.kind == wave_2d)
    check_wave(table, spec);
  return spec;
}

} // namespace asperity::cases
