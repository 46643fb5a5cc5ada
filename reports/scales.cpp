#include "reports/summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

using cases::SurfaceKind;
using cases::SurfaceSpec;

// int_low^high (q/q_0)^(-2-2H) q^n dq / q_0^(n+1), in k = q/q_0
double power_moment(double low, double high, double exponent) {
  return std::abs(exponent + 1.0) < 1e-12 ? std::log(high / low)
                                          : (std::pow(high, exponent + 1.0) -
                                             std::pow(low, exponent + 1.0)) /
                                                (exponent + 1.0);
}

// int q C dq in units of the plateau and q_0^2.
double height_moment(const SurfaceSpec& surface) {
  const double low = surface.wavevector_low / surface.wavevector_roll_off;
  const double high = surface.wavevector_high / surface.wavevector_roll_off;
  return power_moment(low, 1.0, 1.0) +
         power_moment(1.0, high, -1.0 - 2.0 * surface.hurst);
}

// (h'/h_rms)^2 = int q^3 C dq / int q C dq of the self-affine formula [1/m^2].
double slope_over_height_squared(const SurfaceSpec& surface) {
  const double roll_off = surface.wavevector_roll_off;
  const double low = surface.wavevector_low / roll_off;
  const double high = surface.wavevector_high / roll_off;
  const double decay = -2.0 - 2.0 * surface.hurst;
  const double slope =
      power_moment(low, 1.0, 3.0) + power_moment(1.0, high, 3.0 + decay);
  return roll_off * roll_off * slope / height_moment(surface);
}

SurfaceScales formula_scales(const SurfaceSpec& surface) {
  SurfaceScales scales{0.0, not_a_number, not_a_number};
  if (surface.kind != SurfaceKind::self_affine)
    return scales;
  const double ratio = std::sqrt(slope_over_height_squared(surface));
  scales.rms_height = surface.rms_height
                          ? *surface.rms_height
                          : surface.rms_slope.value_or(not_a_number) / ratio;
  scales.rms_slope = scales.rms_height * ratio;
  return scales;
}

} // namespace

double formula_spectrum(const SurfaceSpec& surface, double wavevector) {
  const SurfaceScales scales = formula_scales(surface);
  if (wavevector < surface.wavevector_low ||
      wavevector > surface.wavevector_high)
    return 0.0;
  const double roll_off = surface.wavevector_roll_off;
  const double plateau = std::pow(scales.rms_height / roll_off, 2.0) /
                         (2.0 * std::numbers::pi * height_moment(surface));
  return plateau * std::pow(std::max(1.0, wavevector / roll_off),
                            -2.0 - 2.0 * surface.hurst);
}

bool uses_formula(const cases::Case& rough_case,
                  const results::MethodRecord& method) {
  if (method.kind != "theory")
    return false;
  for (const cases::MethodSpec& spec : rough_case.methods)
    if (spec.name == method.name)
      if (const auto* theory =
              std::get_if<cases::TheorySettings>(&spec.settings))
        return theory->spectrum == cases::TheorySpectrum::formula;
  return false;
}

bool is_exact_shape(const SurfaceSpec& surface) {
  return surface.kind == SurfaceKind::sphere ||
         surface.kind == SurfaceKind::wave_1d ||
         surface.kind == SurfaceKind::wave_2d;
}

SurfaceScales scales_of(const results::Result& result,
                        const cases::Case& rough_case,
                        const results::MethodRecord& method,
                        std::size_t realization) {
  SurfaceScales scales = formula_scales(rough_case.surface);
  const bool formula_is_known = std::isfinite(scales.rms_height);
  if (!result.surfaces.empty() &&
      !(uses_formula(rough_case, method) && formula_is_known)) {
    const results::SurfaceRecord& surface =
        result.surfaces[std::min(realization, result.surfaces.size() - 1)];
    scales.rms_height = surface.rms_height;
    scales.rms_slope = surface.rms_slope;
  }
  scales.contact_modulus = result.contact_modulus;
  return scales;
}

const results::MethodRecord* reference_theory(const results::Result& result) {
  const results::MethodRecord* first = nullptr;
  for (const results::MethodRecord& method : result.methods) {
    if (method.kind != "theory" || method.realizations.empty())
      continue;
    if (method.name == "theory")
      return &method;
    if (first == nullptr)
      first = &method;
  }
  return first;
}

} // namespace asperity::reports
