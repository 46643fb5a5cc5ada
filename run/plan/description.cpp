#include "run/plan/description.hpp"

#include "input/reader/case_hash.hpp"
#include "mechanics/adhesion_scales.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/methods.hpp"
#include "run/plan/plan.hpp"
#include "surfaces/inner_roughness.hpp"

#include <cmath>
#include <numbers>

namespace asperity::run {
namespace {

using cases::MethodSpec;
using results::not_given;

/// The surface of a case as far as it is known before the run.
struct KnownSurface {
  mechanics::Scales scales;
  Grid grid;                     ///< without points if no surface is built
  bool is_built = false;         ///< the statistics are those of realisation 0
  double rms_height = not_given; ///< [m]
  double rms_slope = not_given;  ///< both directions [1]
  double rms_curvature = not_given;   ///< of the continuation [1/m]
  double inner_curvature = not_given; ///< inside the map [1/m]
  double highest = not_given;         ///< [m]
  bool has_images = false;            ///< the grid has those of a measured map
};

/// Returns the methods with the full roughness of the surface.
std::vector<MethodSpec> without_magnification(std::vector<MethodSpec> methods) {
  for (MethodSpec& method : methods)
    method.magnification.reset();
  return methods;
}

KnownSurface built_surface(const cases::Case& contact_case,
                           const std::vector<MethodSpec>& methods) {
  cases::Case first = contact_case;
  first.surface.realizations = 1;
  const methods::CaseSurfaces surfaces(first, without_magnification(methods));
  const methods::SurfaceOfCase& surface = surfaces.whole().front();
  const results::SurfaceRecord& record = surface.record;
  KnownSurface known{surface.scales,    record.grid,      true,
                     record.rms_height, record.rms_slope, record.rms_curvature};
  known.highest = record.highest;
  known.has_images = !record.map.is_whole(record.grid);
  if (surfaces::is_judged_inside(first.surface, true) && record.has_heights())
    known.inner_curvature = surfaces::inner_curvature(
        {record.map_grid(), results::MapView(record.heights_of_map()).whole()});
  return known;
}

/// The roughness by which the adhesion of a method is judged.
mechanics::Roughness roughness_of(const cases::Case& contact_case,
                                  const KnownSurface& known, bool is_free) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const double side = known.scales.length;
  const double side_y = known.grid.length_y > 0.0 ? known.grid.length_y : side;
  if (const auto exact = surfaces::exact_roughness(surface, side, side_y))
    return *exact;
  return {known.rms_slope, surfaces::is_judged_inside(surface, is_free)
                               ? known.inner_curvature
                               : known.rms_curvature};
}

bool is_pressed_once(const MethodSpec& method) {
  return method.as<mechanics::HalfspaceSettings>() != nullptr &&
         method.border() == mechanics::Border::free;
}

bool has_formula(const cases::Case& contact_case) {
  return contact_case.surface.kind == mechanics::SurfaceKind::self_affine ||
         contact_case.surface.kind == mechanics::SurfaceKind::spectrum;
}

/// Returns what the case says of a surface that is not built.
KnownSurface stated_surface(const cases::Case& contact_case) {
  KnownSurface known;
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  known.scales.contact_modulus = contact_case.material.contact_modulus;
  known.scales.length = surface.length.value_or(0.0);
  if (surface.length && surface.points)
    known.scales.spacing = *surface.length / *surface.points;
  if (!has_formula(contact_case))
    return known;
  const theory::HeightSpectrum spectrum =
      methods::formula_of_case(contact_case, {});
  known.scales = methods::formula_scales(contact_case, spectrum);
  known.rms_height = spectrum.rms_height();
  known.rms_slope = spectrum.rms_slope();
  return known;
}

void add(std::vector<DerivedNumber>& numbers, const std::string& name,
         double value, const std::string& unit, const std::string& meaning) {
  if (std::isfinite(value) && value != 0.0)
    numbers.push_back({name, value, unit, meaning});
}

void add_surface(std::vector<DerivedNumber>& numbers,
                 const cases::Case& contact_case, const KnownSurface& known) {
  const std::string which =
      known.is_built ? ", realisation 0" : ", from the spectrum";
  if (known.grid.points_x > 0) {
    const std::string of = known.has_images ? ", mirror images included" : "";
    add(numbers, "points_x", known.grid.points_x, "1", "nodes along x" + of);
    add(numbers, "points_y", known.grid.points_y, "1", "nodes along y" + of);
    add(numbers, "node_spacing_y", known.grid.spacing_y(), "m",
        "distance of nodes along y");
  }
  add(numbers, "node_spacing", known.scales.spacing, "m",
      "h, distance of nodes along x");
  add(numbers, "rms_height", known.rms_height, "m", "h_rms" + which);
  add(numbers, "rms_slope", known.rms_slope, "1",
      "h'_rms, both directions" + which);
  const bool is_free = contact_case.surface.edges == mechanics::Edges::free;
  add(numbers, "rms_curvature",
      roughness_of(contact_case, known, is_free).rms_curvature, "1/m",
      "half the Laplacian" + which);
  add(numbers, "highest_peak", known.highest, "m",
      "above the mean plane" + which);
}

/// Adds the band of the spectrum and the wavevectors that the grid resolves.
void add_wavevectors(std::vector<DerivedNumber>& numbers,
                     const cases::Case& contact_case,
                     const KnownSurface& known) {
  const double two_pi = 2.0 * std::numbers::pi;
  double shortest = 0.0; // wavelength [m]
  if (contact_case.surface.kind == mechanics::SurfaceKind::self_affine) {
    const mechanics::SurfaceSpec& surface = contact_case.surface;
    add(numbers, "wavevector_low", surface.wavevector_low, "1/m",
        "q_L, where the spectrum begins");
    add(numbers, "wavevector_roll_off", surface.wavevector_roll_off, "1/m",
        "q_0, where the plateau ends");
    add(numbers, "wavevector_high", surface.wavevector_high, "1/m",
        "q_1, where the spectrum ends");
    add(numbers, "magnification",
        surface.wavevector_high / surface.wavevector_roll_off, "1", "q_1/q_0");
    shortest = two_pi / surface.wavevector_high;
    add(numbers, "wavelength_short", shortest, "m", "2 pi/q_1");
  }
  if (known.scales.length > 0.0)
    add(numbers, "lowest_resolved_wavevector", two_pi / known.scales.length,
        "1/m", "2 pi/L of the periodic square");
  if (known.scales.spacing > 0.0) {
    add(numbers, "highest_resolved_wavevector",
        std::numbers::pi / known.scales.spacing, "1/m", "pi/h of the grid");
    if (shortest > 0.0)
      add(numbers, "nodes_per_shortest_wavelength",
          shortest / known.scales.spacing, "1", "wavelength_short/h");
  }
}

void add_material(std::vector<DerivedNumber>& numbers,
                  const mechanics::MaterialSpec& material,
                  const KnownSurface& known) {
  add(numbers, "contact_modulus", material.contact_modulus, "Pa",
      "E* of the pair");
  if (material.poisson_ratio)
    add(numbers, "block_youngs_modulus", material.block_youngs_modulus(), "Pa",
        "E of one block with this E*");
  add(numbers, "full_contact_pressure",
      material.contact_modulus * known.rms_slope / 2.0, "Pa",
      "rms pressure E* h'_rms/2 of full contact");
}

/// Adds by what the adhesion of a method is judged.
void add_adhesion(std::vector<DerivedNumber>& numbers,
                  const cases::Case& contact_case,
                  const std::vector<MethodSpec>& methods,
                  const KnownSurface& known) {
  for (const MethodSpec& method : methods) {
    if (!method.is_adhesive() || !(known.scales.spacing > 0.0))
      continue;
    const mechanics::Scales scales =
        known.grid.points_x > 0
            ? mechanics::adhesion_scales(known.scales, known.grid)
            : known.scales;
    const mechanics::ContactInterface law = *method.adhesion(scales);
    const double modulus = known.scales.contact_modulus;
    const mechanics::Roughness rough =
        roughness_of(contact_case, known, is_pressed_once(method));
    add(numbers, "work_of_adhesion", law.work_of_adhesion, "J/m^2",
        "w of " + method.name);
    add(numbers, "adhesion_range", law.adhesion_range, "m",
        "rho of " + method.name);
    if (method.contact() != nullptr)
      add(numbers, "adhesion_grid_number",
          law.grid_number(modulus, scales.spacing), "1",
          "s^2 h/(w E*); above 0.25 the grid resolves the range coarsely");
    add(numbers, "tabor_parameter", tabor_parameter(law, modulus, rough), "1",
        "(w^2/(E*^2 kappa rho^3))^{1/3} with the rms curvature kappa");
    add(numbers, "stickiness", stickiness(law, modulus, rough), "1",
        "of Pastewka and Robbins (2014); the faces stick below 1");
  }
}

std::vector<DescribedLoad> loads_of(const mechanics::LoadingPath& load,
                                    const KnownSurface& known) {
  const bool is_pressure = load.control == mechanics::Control::nominal_pressure;
  const double unit =
      is_pressure ? known.scales.contact_modulus : known.scales.rms_height;
  std::vector<DescribedLoad> loads;
  for (std::size_t step = 0; step < load.targets.size(); ++step) {
    const mechanics::Quantity& target = load.targets[step];
    double in_si = target.in_si(known.scales);
    if (in_si == 0.0 && target.value != 0.0)
      in_si = not_given; // the reference unit is not known
    loads.push_back({in_si, unit > 0.0 ? in_si / unit : not_given,
                     load.is_unloading[step]});
  }
  return loads;
}

} // namespace

CaseDescription describe_case(const cases::Case& contact_case,
                              const RunOptions& options) {
  CaseDescription description;
  description.name = contact_case.name;
  description.title = contact_case.title;
  description.file = contact_case.path;
  description.hash = cases::case_hash(contact_case);
  description.inputs = methods::input_hashes(contact_case);
  description.control = contact_case.load.control;
  const std::vector<MethodSpec> methods =
      methods::chosen_methods(contact_case, options.methods);
  for (const MethodSpec& method : methods) {
    const methods::MethodDescription one =
        methods::describe(method, contact_case.material);
    description.methods.push_back({method.name, one.kind, one.text});
  }
  description.plan = make_plan(contact_case, options);
  const KnownSurface known =
      methods::needs_surfaces(methods) && refusal_of(description.plan).empty()
          ? built_surface(contact_case, methods)
          : stated_surface(contact_case);
  description.keys = cases::resolved_keys(contact_case, known.scales);
  add_surface(description.derived, contact_case, known);
  add_wavevectors(description.derived, contact_case, known);
  add_material(description.derived, contact_case.material, known);
  add_adhesion(description.derived, contact_case, methods, known);
  description.loads = loads_of(contact_case.load, known);
  return description;
}

} // namespace asperity::run
