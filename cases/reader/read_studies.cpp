#include "cases/reader/read_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace asperity::cases {
namespace {

/// @param takes_maps  the study also describes a measured surface
void check_theory(TableReader& table, const Case& read, bool takes_maps) {
  const bool is_measured =
      read.surface.kind == mechanics::SurfaceKind::measured;
  if (!study_theory(read.surface, read.methods) || (is_measured && !takes_maps))
    table.complain(
        table.node(),
        fmt::format("needs a [theory] whose spectrum is \"formula\"{}, and "
                    "whose loss_factor is \"yang-persson\"",
                    takes_maps ? ", or a measured surface" : ""));
}

void check_ends(TableReader& table, double from, double to) {
  if (from > 0.0 && to > 0.0 && !(from < to))
    table.refuse(table.said_by("to"),
                 "must be above " + table.node().path + ".from");
}

/// Returns 2 pi over the wavelength given by that key [rad/m]; 0 after
/// reporting a mistake.
double wavevector_of(TableReader& table, const std::string& key,
                     const mechanics::SurfaceSpec& surface) {
  const mechanics::Quantity wavelength = table.quantity(key);
  if (wavelength.reference == mechanics::ReferenceUnit::length &&
      !surface.length) {
    table.refuse(table.said_by(key),
                 "surface.length is missing, which its unit needs");
    return 0.0;
  }
  const double metres =
      wavelength.in_si({0.0, surface.length.value_or(0.0), 0.0, 0.0});
  return metres > 0.0 ? 2.0 * std::numbers::pi / metres : 0.0;
}

double read_reference_wavevector(TableReader& table,
                                 const mechanics::SurfaceSpec& surface,
                                 const MagnificationStudy& study) {
  const std::string direct = "reference_wavevector";
  const std::string inverse = "reference_wavelength";
  if (table.has(direct) && table.has(inverse))
    table.refuse_both(direct, inverse);
  if (table.has(direct))
    return study.reference_wavevector;
  if (table.has(inverse))
    return wavevector_of(table, inverse, surface);
  if (surface.kind != mechanics::SurfaceKind::self_affine)
    table.complain_missing(
        direct, " (or " + inverse +
                    "), because the surface has no roll-off wavevector");
  return surface.wavevector_roll_off;
}

void require_fields(TableReader& table, const Case& read,
                    const std::string& what) {
  if (std::ranges::none_of(read.methods, &MethodSpec::has_fields))
    table.complain(table.node(), "needs a method with a " + what +
                                     ": [halfspace], [fem] or [md]");
}

/// Both bodies have a property, or neither.
void require_both(TableReader& table, const std::string& key) {
  const std::string counter = "counter_" + key;
  if (table.has(key) != table.has(counter))
    table.complain_missing(table.has(key) ? counter : key,
                           ": both bodies conduct; a body of the same material "
                           "has the same value");
}

} // namespace

MagnificationStudy read_magnification_study(TableReader table,
                                            const Case& read) {
  check_theory(table, read, true);
  MagnificationStudy study;
  table.read(study);
  check_ends(table, study.from, study.to);
  study.reference_wavevector =
      read_reference_wavevector(table, read.surface, study);
  if (const Node* const leak = table.sub_table("leak"))
    table.part(*leak, "magnification.leak").read(study.leak.emplace());
  return study;
}

AdhesionStudy read_adhesion_study(TableReader table, const Case& read) {
  check_theory(table, read, false);
  AdhesionStudy study;
  table.read(study);
  check_ends(table, study.from, study.to);
  return study;
}

FlowStudy read_flow_study(TableReader table, const Case& read) {
  FlowStudy study;
  table.read(study);
  require_fields(table, read, "gap");
  if (study.length.has_value() != study.width.has_value())
    table.complain_missing(study.length ? "width" : "length",
                           ": a seal has both");
  return study;
}

SpotsStudy read_spots_study(TableReader table, const Case& read) {
  SpotsStudy study;
  table.read(study);
  require_fields(table, read, "contact map");
  return study;
}

ConductanceStudy read_conductance_study(TableReader table, const Case& read) {
  ConductanceStudy study;
  table.read(study);
  require_fields(table, read, "contact map");
  require_both(table, "thermal_conductivity");
  require_both(table, "resistivity");
  return study;
}

} // namespace asperity::cases
