#include "robustness/case_instance.hpp"

#include "input/input_error.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/statistics.hpp"

#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

void take_surface(const mechanics::SurfaceSpec& surface, Instance& instance) {
  if (surface.kind == mechanics::SurfaceKind::self_affine) {
    const double longest = 2.0 * std::numbers::pi / *surface.length;
    instance.length = *surface.length;
    instance.hurst = surface.hurst;
    instance.roll_off = surface.wavevector_roll_off / longest;
    if (surface.points)
      instance.shortest_wave =
          *surface.points * longest / surface.wavevector_high;
    instance.rms_slope =
        std::sqrt(surfaces::formula_spectrum(surface).mean_square_slope);
    return;
  }
  const surfaces::HeightMap map = surfaces::build_surface(surface, 0);
  instance.length = map.grid.length_x;
  instance.rms_slope = surfaces::statistics(map).rms_slope;
}

void take_contact(const mechanics::ContactSettings& contact,
                  const mechanics::Scales& scales, Instance& instance) {
  instance.law = contact.law;
  instance.penalty =
      contact.penalty.in_si(scales) * scales.spacing / scales.contact_modulus;
}

void take_method(const mechanics::HalfspaceSettings& half,
                 const mechanics::Scales& scales, Instance& instance) {
  instance.family = half.thickness ? Family::slab : Family::halfspace;
  if (half.thickness)
    instance.thickness = half.thickness->in_si(scales) / scales.length;
  instance.far_boundary = half.far_boundary;
  instance.has_free_boundaries = half.has_free_boundaries;
  take_contact(half.contact, scales, instance);
}

void take_method(const mechanics::FemSettings& settings,
                 const mechanics::Scales& scales, Instance& instance) {
  instance.family = settings.block.element == mechanics::Element::q1
                        ? Family::condensed_q1
                        : Family::condensed_q2;
  if (settings.solver == mechanics::FemSolver::full)
    instance.family = Family::full_block;
  instance.degree = degree_of(settings.block.element);
  instance.thickness = settings.block.depth.in_si(scales) / scales.length;
  instance.growth = settings.block.growth;
  instance.far_boundary = settings.block.far_boundary;
  take_contact(settings.contact, scales, instance);
}

void take_method(const mechanics::TheorySettings& theory,
                 const mechanics::Scales& /*scales*/, Instance& instance) {
  instance.family = Family::theory;
  instance.gamma = theory.gamma;
}

void take_method(const mechanics::MdSettings& /*atoms*/,
                 const mechanics::Scales& /*scales*/, Instance& instance) {
  instance.family = Family::atoms;
}

/// Winkler foundations are solved exactly: there is no family of them.
void take_method(const mechanics::WinklerSettings& /*springs*/,
                 const mechanics::Scales& /*scales*/, Instance& /*instance*/) {}

} // namespace

Instance instance_of_case(const cases::Case& contact_case) {
  for (const cases::MethodSpec& method : contact_case.methods)
    if (method.hardness())
      throw input::InputError(
          contact_case.path + ": " + method.name +
          " has a hardness, for which this version has no random problems");
  Instance instance;
  take_surface(contact_case.surface, instance);
  instance.contact_modulus = contact_case.material.contact_modulus;
  instance.poisson_ratio = contact_case.material.poisson_ratio.value_or(0.3);
  const int points = contact_case.surface.points.value_or(instance.points);
  const mechanics::Scales scales{instance.contact_modulus, instance.length,
                                 instance.length / points,
                                 instance.rms_slope * instance.length / points};
  // From last to first, so that the settings of the first method take
  // precedence.
  for (auto method = contact_case.methods.rbegin();
       method != contact_case.methods.rend(); ++method)
    std::visit(
        [&](const auto& settings) { take_method(settings, scales, instance); },
        method->settings);
  return instance;
}

} // namespace asperity::robustness
