#include "reports/analysis/exact.hpp"
#include "theory/exact/hertz.hpp"
#include "theory/exact/wave_2d.hpp"
#include "theory/exact/westergaard.hpp"

#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

using cases::SurfaceSpec;

ExactPoint on_sphere(const SurfaceSpec& surface, double contact_modulus,
                     double nominal_pressure, double surface_top) {
  ExactPoint exact;
  if (!surface.length)
    return exact;
  const double side = *surface.length;
  const double load = nominal_pressure * side * side;
  const theory::HertzContact hertz =
      theory::hertz_contact(load, surface.radius, contact_modulus);
  exact.contact_radius = hertz.contact_radius;
  exact.approach = hertz.approach;
  exact.area_fraction = std::numbers::pi * hertz.contact_radius *
                        hertz.contact_radius / (side * side);
  exact.mean_gap = surface_top - hertz.approach +
                   periodic_approach(load, side, contact_modulus);
  return exact;
}

ExactPoint on_wave_1d(const SurfaceSpec& surface, double contact_modulus,
                      double nominal_pressure) {
  const theory::WestergaardContact wave(surface.amplitude, surface.wavelength,
                                        contact_modulus);
  ExactPoint exact;
  exact.mean_gap = wave.mean_gap(nominal_pressure);
  exact.area_fraction = wave.area_fraction(nominal_pressure);
  return exact;
}

// Between its two limits, the solution is a table computed with this program on
// finer grids. A continuum half-space is therefore compared with a refinement
// of itself there; any other method is compared with an independent solution.
ExactPoint on_wave_2d(const SurfaceSpec& surface, double contact_modulus,
                      double nominal_pressure) {
  const theory::Wave2dContact wave(surface.amplitude, surface.wavelength,
                                   contact_modulus);
  ExactPoint exact;
  exact.mean_gap = wave.mean_gap(nominal_pressure);
  exact.area_fraction = wave.area_fraction(nominal_pressure);
  return exact;
}

} // namespace

ExactPoint exact_point(const SurfaceSpec& surface, double contact_modulus,
                       double nominal_pressure, double surface_top) {
  switch (surface.kind) {
  case cases::SurfaceKind::sphere:
    return on_sphere(surface, contact_modulus, nominal_pressure, surface_top);
  case cases::SurfaceKind::wave_1d:
    return on_wave_1d(surface, contact_modulus, nominal_pressure);
  case cases::SurfaceKind::wave_2d:
    return on_wave_2d(surface, contact_modulus, nominal_pressure);
  default:
    return {};
  }
}

double periodic_approach(double load, double length, double contact_modulus) {
  return theory::square_array_approach(load, contact_modulus, length);
}

} // namespace asperity::reports
