#include "reports/pages/html_report.hpp"

#include <fmt/format.h>

namespace asperity::reports {
namespace {

using mechanics::SurfaceKind;

std::string surface_words(const mechanics::SurfaceSpec& surface) {
  switch (surface.kind) {
  case SurfaceKind::self_affine:
    return fmt::format("self-affine surface, H = {:.3g}, roll-off at {:.3g} "
                       "µm, wavelengths from {:.3g} to {:.3g} µm",
                       surface.hurst,
                       6.283185307179586e6 / surface.wavevector_roll_off,
                       6.283185307179586e6 / surface.wavevector_high,
                       6.283185307179586e6 / surface.wavevector_low);
  case SurfaceKind::spectrum:
    return "surface with a tabulated spectrum";
  case SurfaceKind::measured:
    return "measured surface";
  case SurfaceKind::sphere:
    return fmt::format("sphere of radius {:.6g} µm", surface.radius * 1e6);
  case SurfaceKind::wave_1d:
    return fmt::format("one-dimensional wave, amplitude {:.4g} nm, length "
                       "{:.4g} µm",
                       surface.amplitude * 1e9, surface.wavelength * 1e6);
  case SurfaceKind::wave_2d:
    return fmt::format("two-dimensional wave, amplitude {:.4g} nm, length "
                       "{:.4g} µm",
                       surface.amplitude * 1e9, surface.wavelength * 1e6);
  }
  return "surface";
}

std::string grid_words(const results::Result& result) {
  if (result.surfaces.empty())
    return "";
  const results::SurfaceRecord& surface = result.surfaces.front();
  std::string words = fmt::format(
      "; {} × {} points over {:.4g} × {:.4g} µm, rms height {:.4g} nm, rms "
      "slope {:.3g}",
      surface.grid.points_x, surface.grid.points_y, surface.grid.length_x * 1e6,
      surface.grid.length_y * 1e6, surface.rms_height * 1e9, surface.rms_slope);
  if (result.surfaces.size() > 1)
    words += fmt::format("; {} realisations", result.surfaces.size());
  return words;
}

std::string load_words(const results::Result& result) {
  double least = not_a_number;
  double largest = not_a_number;
  std::size_t steps = 0;
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations) {
      steps = std::max(steps, curve.points.size());
      for (const results::CurvePoint& point : curve.points) {
        least = std::fmin(least, point.nominal_pressure);
        largest = std::fmax(largest, point.nominal_pressure);
      }
    }
  if (steps == 0)
    return "";
  return fmt::format("; {} load step{}, p/E* from {:.3g} to {:.3g}", steps,
                     steps == 1 ? "" : "s", least / result.contact_modulus,
                     largest / result.contact_modulus);
}

} // namespace

std::string case_sentence(const ReportEntry& entry) {
  return fmt::format(
      "An elastic block, E* = {:.4g} GPa, pressed against a rigid {}{}{}.",
      entry.result->contact_modulus * 1e-9,
      entry.result->case_text.empty()
          ? "surface"
          : surface_words(entry.contact_case->surface),
      grid_words(*entry.result), load_words(*entry.result));
}

} // namespace asperity::reports
