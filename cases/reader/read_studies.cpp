#include "cases/reader/read_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

/// Whether the loads are nominal pressures that rise.
bool has_rising_loads(const mechanics::LoadingPath& load) {
  return load.control == mechanics::Control::nominal_pressure &&
         !load.targets.empty() &&
         std::ranges::none_of(load.is_unloading, std::identity()) &&
         std::ranges::is_sorted(load.targets, {}, &mechanics::Quantity::value);
}

/// A pressure in the unit of the loads; nothing if that needs the surface.
std::optional<mechanics::Quantity> like_loads(const mechanics::Quantity& load,
                                              const Case& read) {
  const mechanics::ReferenceUnit unit = read.load.targets.back().reference;
  if (load.reference == unit)
    return load;
  using mechanics::ReferenceUnit;
  if (load.reference == ReferenceUnit::contact_modulus_times_slope ||
      unit == ReferenceUnit::contact_modulus_times_slope ||
      !(read.material.contact_modulus > 0.0))
    return {};
  const mechanics::Scales scales{.contact_modulus =
                                     read.material.contact_modulus};
  const double one = mechanics::Quantity{1.0, unit}.in_si(scales);
  return mechanics::Quantity{load.in_si(scales) / one, unit};
}

/// Adds a load step, unless there is one: before the first larger load.
void add_step(mechanics::LoadingPath& load, const mechanics::Quantity& step) {
  constexpr double same = 1e-12;
  auto next = load.targets.begin();
  while (next != load.targets.end() && next->value < step.value * (1.0 - same))
    ++next;
  if (next != load.targets.end() && next->value <= step.value * (1.0 + same))
    return;
  load.targets.insert(next, step);
  load.is_unloading.push_back(false);
}

/// The steps of this load and of the lighter one nearest to its half.
std::vector<std::size_t> steps_of_traction(const mechanics::LoadingPath& load,
                                           double full) {
  std::size_t pressed = 0;
  while (pressed + 1 < load.targets.size() &&
         load.targets[pressed].value < full)
    ++pressed;
  if (pressed == 0)
    return {};
  std::size_t eased = 0;
  for (std::size_t i = 1; i < pressed; ++i)
    if (std::abs(load.targets[i].value - 0.5 * full) <
        std::abs(load.targets[eased].value - 0.5 * full))
      eased = i;
  return {eased, pressed};
}

/// Adds the load steps of the normal load and of the tangential loads.
void add_friction_steps(TableReader& table, FrictionStudy& study, Case& read) {
  for (const char* const key : {"normal_load", "tangential_load"})
    if (table.has(key) && !has_rising_loads(read.load)) {
      table.refuse(table.said_by(key),
                   "needs a [load] by nominal pressures that only rise");
      return;
    }
  if (!has_rising_loads(read.load))
    return;
  mechanics::Quantity full = read.load.targets.back();
  if (study.normal_load) {
    const auto own = like_loads(*study.normal_load, read);
    if (!own) {
      table.refuse(table.said_by("normal_load"),
                   "must be in E* h' where the loads are, and only there: the "
                   "slope h' of the surface is not known before the run");
      return;
    }
    full = *own;
    add_step(read.load, full);
  }
  for (const mechanics::Quantity& share : study.tangential_loads)
    add_step(read.load, {full.value * (1.0 - share.value), full.reference});
  study.map_steps = steps_of_traction(read.load, full.value * (1.0 - 1e-12));
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

FrictionStudy read_friction_study(TableReader table, Case& read) {
  FrictionStudy study;
  table.read(study);
  if (std::ranges::none_of(read.methods, [&](const MethodSpec& method) {
        return has_partial_slip(method, read.material);
      }))
    table.complain(table.node(),
                   "needs a [theory] or a [halfspace] without thickness, "
                   "adhesion and hardness, on a uniform material");
  if (!read.material.poisson_ratio)
    table.complain(table.node(), "needs material.poisson_ratio");
  add_friction_steps(table, study, read);
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
  if (study.gap_conductivity || study.smallest_gap)
    for (const char* const key :
         {"gap_conductivity", "smallest_gap", "thermal_conductivity"})
      table.require(key, ", which heat through the gap needs");
  return study;
}

} // namespace asperity::cases
