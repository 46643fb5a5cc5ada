#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

#include <numbers>

namespace asperity::cases {
namespace {

void check_theory(TableReader& table, const Case& read) {
  if (!study_theory(read.methods))
    table.complain(table.node(), "needs a [theory] whose spectrum is "
                                 "\"formula\"");
}

void check_ends(TableReader& table, double from, double to) {
  if (from > 0.0 && to > 0.0 && !(from < to))
    table.refuse(*table.node().find("to"),
                 "must be above " + table.node().path + ".from");
}

/// Returns 2 pi over the wavelength given by that key [rad/m]; 0 after
/// reporting a mistake.
double wavevector_of(TableReader& table, const std::string& key,
                     const mechanics::SurfaceSpec& surface) {
  const mechanics::Quantity wavelength = table.quantity(key);
  if (wavelength.reference == mechanics::ReferenceUnit::length &&
      !surface.length) {
    table.refuse(*table.node().find(key),
                 "surface.length is missing, which its unit needs");
    return 0.0;
  }
  const double metres =
      wavelength.in_si({0.0, surface.length.value_or(0.0), 0.0, 0.0});
  return metres > 0.0 ? 2.0 * std::numbers::pi / metres : 0.0;
}

double read_reference_wavevector(TableReader& table,
                                 const mechanics::SurfaceSpec& surface) {
  const std::string direct = "reference_wavevector";
  const std::string inverse = "reference_wavelength";
  if (table.has(direct) && table.has(inverse))
    table.refuse_both(direct, inverse);
  if (table.has(direct))
    return table.number(direct);
  if (table.has(inverse))
    return wavevector_of(table, inverse, surface);
  if (surface.kind != mechanics::SurfaceKind::self_affine)
    table.complain_missing(
        direct, " (or " + inverse +
                    "), because the surface has no roll-off wavevector");
  return surface.wavevector_roll_off;
}

std::optional<LeakStudy> read_leak(TableReader& magnification,
                                   Mistakes& mistakes) {
  const Node* const node = magnification.sub_table("leak");
  if (!node)
    return std::nullopt;
  TableReader table(*node, vocabulary_table("magnification.leak"), mistakes);
  table.refuse_unknown();
  LeakStudy leak;
  leak.density = table.number("density");
  leak.viscosity = table.number("viscosity");
  leak.pressure_drop = table.number("pressure_drop");
  if (table.has("critical_area"))
    leak.critical_area = table.number("critical_area");
  return leak;
}

} // namespace

MagnificationStudy read_magnification_study(const Node& node, const Case& read,
                                            Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("magnification"), mistakes);
  table.refuse_unknown({"leak"});
  check_theory(table, read);
  MagnificationStudy study;
  study.nominal_pressures = read_targets(table, "nominal_pressure", mistakes);
  study.from = table.number("from");
  study.to = table.number("to");
  check_ends(table, study.from, study.to);
  study.points = table.integer("points");
  study.reference_wavevector = read_reference_wavevector(table, read.surface);
  study.leak = read_leak(table, mistakes);
  return study;
}

AdhesionStudy read_adhesion_study(const Node& node, const Case& read,
                                  Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("adhesion"), mistakes);
  table.refuse_unknown();
  check_theory(table, read);
  AdhesionStudy study;
  study.work_of_adhesion = table.number("work_of_adhesion");
  study.from = table.number("from");
  study.to = table.number("to");
  check_ends(table, study.from, study.to);
  study.points = table.integer("points");
  if (table.has("detachment_factor"))
    study.detachment_factor = table.number("detachment_factor");
  if (table.has("sphere_radius"))
    study.sphere_radius = table.number("sphere_radius");
  study.steps = table.integer("steps");
  return study;
}

} // namespace asperity::cases
