#include "robustness/case_scene.hpp"

#include "surfaces/build.hpp"
#include "surfaces/maps/statistics.hpp"

#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

void take_surface(const mechanics::SurfaceSpec& surface, Scene& scene) {
  if (surface.kind == mechanics::SurfaceKind::self_affine) {
    const double longest = 2.0 * std::numbers::pi / *surface.length;
    scene.length = *surface.length;
    scene.hurst = surface.hurst;
    scene.roll_off = surface.wavevector_roll_off / longest;
    if (surface.points)
      scene.shortest_wave = *surface.points * longest / surface.wavevector_high;
    scene.rms_slope =
        std::sqrt(surfaces::formula_spectrum(surface).mean_square_slope);
    return;
  }
  const surfaces::HeightMap map = surfaces::build_surface(surface, 0);
  scene.length = map.grid.length_x;
  scene.rms_slope = surfaces::statistics(map).rms_slope;
}

void take_contact(const mechanics::ContactSettings& contact,
                  const mechanics::Scales& scales, Scene& scene) {
  scene.law = contact.law;
  scene.penalty =
      contact.penalty.in_si(scales) * scales.spacing / scales.contact_modulus;
}

void take_method(const mechanics::HalfspaceSettings& half,
                 const mechanics::Scales& scales, Scene& scene) {
  scene.family = half.thickness ? Family::slab : Family::halfspace;
  if (half.thickness)
    scene.thickness = half.thickness->in_si(scales) / scales.length;
  scene.top = half.far_boundary;
  scene.has_free_boundaries = half.has_free_boundaries;
  take_contact(half.contact, scales, scene);
}

void take_method(const mechanics::FemSettings& settings,
                 const mechanics::Scales& scales, Scene& scene) {
  scene.family = settings.block.element == mechanics::Element::q1
                     ? Family::condensed_q1
                     : Family::condensed_q2;
  if (settings.solver == mechanics::FemSolver::full)
    scene.family = Family::full_block;
  scene.degree = degree_of(settings.block.element);
  scene.thickness = settings.block.depth.in_si(scales) / scales.length;
  scene.growth = settings.block.growth;
  scene.top = settings.block.far_boundary;
  take_contact(settings.contact, scales, scene);
}

void take_method(const mechanics::TheorySettings& theory,
                 const mechanics::Scales& /*scales*/, Scene& scene) {
  scene.family = Family::theory;
  scene.gamma = theory.gamma;
}

void take_method(const mechanics::MdSettings& /*atoms*/,
                 const mechanics::Scales& /*scales*/, Scene& scene) {
  scene.family = Family::atoms;
}

/// Winkler foundations are solved exactly: there is no family of them.
void take_method(const mechanics::WinklerSettings& /*springs*/,
                 const mechanics::Scales& /*scales*/, Scene& /*scene*/) {}

} // namespace

Scene scene_of_case(const cases::Case& contact_case) {
  Scene scene;
  take_surface(contact_case.surface, scene);
  scene.contact_modulus = contact_case.material.contact_modulus;
  scene.poisson_ratio = contact_case.material.poisson_ratio.value_or(0.3);
  const int points = contact_case.surface.points.value_or(scene.points);
  const mechanics::Scales scales{scene.contact_modulus, scene.length,
                                 scene.length / points,
                                 scene.rms_slope * scene.length / points};
  // From last to first, so that the settings of the first method take
  // precedence.
  for (auto method = contact_case.methods.rbegin();
       method != contact_case.methods.rend(); ++method)
    std::visit(
        [&](const auto& settings) { take_method(settings, scales, scene); },
        method->settings);
  return scene;
}

} // namespace asperity::robustness
