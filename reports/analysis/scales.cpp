#include "mechanics/adhesion_scales.hpp"
#include "reports/analysis/summary.hpp"
#include "surfaces/build.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

SurfaceScales formula_scales(const SurfaceSpec& surface) {
  SurfaceScales scales{0.0, not_a_number, not_a_number};
  if (surface.kind != SurfaceKind::self_affine)
    return scales;
  const surfaces::IsotropicSpectrum spectrum =
      surfaces::formula_spectrum(surface);
  scales.rms_height = std::sqrt(spectrum.mean_square_height);
  scales.rms_slope = std::sqrt(spectrum.mean_square_slope);
  return scales;
}

} // namespace

const cases::MethodSpec* spec_of(const cases::Case& contact_case,
                                 const results::MethodRecord& method) {
  const auto found = std::ranges::find(contact_case.methods, method.name,
                                       &cases::MethodSpec::name);
  return found == contact_case.methods.end() ? nullptr : &*found;
}

bool is_adhesive(const cases::Case& contact_case,
                 const results::MethodRecord& method) {
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  return spec != nullptr && spec->is_adhesive();
}

std::optional<mechanics::ContactInterface>
adhesion_of(const results::Result& result, const cases::Case& contact_case,
            const results::MethodRecord& method) {
  const results::SurfaceRecord* const surface = surface_of(result, method, 0);
  if (!is_adhesive(contact_case, method) || surface == nullptr)
    return std::nullopt;
  return spec_of(contact_case, method)
      ->adhesion(
          mechanics::adhesion_scales({.contact_modulus = result.contact_modulus,
                                      .length = surface->grid.length_x,
                                      .rms_height = surface->rms_height,
                                      .rms_slope = surface->rms_slope},
                                     surface->grid));
}

bool uses_formula(const cases::Case& contact_case,
                  const results::MethodRecord& method) {
  const auto* const theory =
      settings_of<mechanics::TheorySettings>(contact_case, method);
  return method.kind == "theory" && theory != nullptr &&
         theory->spectrum == mechanics::TheorySpectrum::formula;
}

bool is_exact_shape(const cases::Case& contact_case) {
  const SurfaceKind kind = contact_case.surface.kind;
  return contact_case.material.is_uniform() &&
         std::ranges::none_of(contact_case.methods,
                              [](const cases::MethodSpec& method) {
                                return method.is_adhesive() ||
                                       method.hardness().has_value();
                              }) &&
         (contact_case.surface.is_indenter() || kind == SurfaceKind::wave_1d ||
          kind == SurfaceKind::wave_2d);
}

bool has_exact_curve(const cases::Case& contact_case) {
  return is_exact_shape(contact_case) && contact_case.surface.tilt == 0.0;
}

const results::SurfaceRecord* surface_of(const results::Result& result,
                                         const results::MethodRecord& method,
                                         std::size_t realization) {
  if (realization < method.realizations.size() &&
      method.realizations[realization].own_surface)
    return &*method.realizations[realization].own_surface;
  if (result.surfaces.empty())
    return nullptr;
  return &result.surfaces[std::min(realization, result.surfaces.size() - 1)];
}

SurfaceScales scales_of(const results::Result& result,
                        const cases::Case& contact_case,
                        const results::MethodRecord& method,
                        std::size_t realization) {
  SurfaceScales scales = formula_scales(contact_case.surface);
  const bool formula_is_known = std::isfinite(scales.rms_height);
  const results::SurfaceRecord* surface =
      surface_of(result, method, realization);
  const bool is_own = realization < method.realizations.size() &&
                      method.realizations[realization].own_surface;
  if (surface != nullptr &&
      (is_own || !(uses_formula(contact_case, method) && formula_is_known))) {
    scales.rms_height = surface->rms_height;
    scales.rms_slope = surface->rms_slope;
  }
  scales.contact_modulus = result.contact_modulus;
  return scales;
}

mechanics::ContactCriterion
contact_criterion_of(const cases::Case& contact_case,
                     const results::MethodRecord& method, double rms_height) {
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  return spec != nullptr ? spec->contact_criterion(rms_height)
                         : mechanics::ContactCriterion{};
}

mechanics::Border border_of(const cases::Case& contact_case,
                            const results::MethodRecord& method) {
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  return spec != nullptr ? spec->border() : mechanics::Border::periodic;
}

bool has_free_boundaries(const cases::Case& contact_case,
                         const results::MethodRecord& method) {
  const auto* const half =
      settings_of<mechanics::HalfspaceSettings>(contact_case, method);
  return half != nullptr && half->block().is_free();
}

bool has_free_sides(const cases::Case& contact_case,
                    const results::MethodRecord& method) {
  const auto* const fem =
      settings_of<mechanics::FemSettings>(contact_case, method);
  return fem != nullptr &&
         (fem->full.sides == mechanics::BlockSides::free ||
          (fem->full.bodies == 2 && contact_case.mesh.counter));
}

std::optional<double> magnification_of(const cases::Case& contact_case,
                                       const results::MethodRecord& method) {
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  return spec == nullptr ? std::nullopt : spec->magnification;
}

const results::MethodRecord*
reference_theory(const results::Result& result, const cases::Case& contact_case,
                 const results::MethodRecord& method) {
  const std::optional<double> seen = magnification_of(contact_case, method);
  const results::MethodRecord* first = nullptr;
  for (const results::MethodRecord& theory : result.methods) {
    if (theory.kind != "theory" || theory.realizations.empty() ||
        magnification_of(contact_case, theory) != seen)
      continue;
    if (theory.name == "theory")
      return &theory;
    if (first == nullptr)
      first = &theory;
  }
  return first;
}

const results::MethodRecord* base_method(const results::Result& result,
                                         const results::MethodRecord& method) {
  const std::size_t dot = method.name.find('.');
  for (const results::MethodRecord& base : result.methods)
    if (dot != std::string::npos && base.name == method.name.substr(0, dot) &&
        !base.realizations.empty())
      return &base;
  return nullptr;
}

} // namespace asperity::reports
