#include "reports/analysis/exact.hpp"
#include "theory/exact/hertz.hpp"
#include "theory/exact/punches.hpp"
#include "theory/exact/wave_2d.hpp"
#include "theory/exact/westergaard.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::reports {
namespace {

using mechanics::SurfaceSpec;

ExactPoint on_sphere(const SurfaceSpec& surface, double contact_modulus,
                     double nominal_pressure, double surface_top,
                     bool is_free) {
  ExactPoint exact;
  if (!surface.length)
    return exact;
  const double side = *surface.length;
  const double load = nominal_pressure * side * side;
  const theory::HertzContact hertz =
      theory::hertz_contact(load, surface.radius, contact_modulus);
  if (2.0 * hertz.contact_radius > side)
    return exact; // the contact reaches the images or the border
  exact.contact_radius = hertz.contact_radius;
  exact.approach = hertz.approach;
  exact.area_fraction = std::numbers::pi * hertz.contact_radius *
                        hertz.contact_radius / (side * side);
  if (is_free)
    exact.elastic_energy = hertz.elastic_energy / (side * side);
  exact.mean_gap = surface_top - hertz.approach +
                   approach_excess(surface, contact_modulus, load, is_free);
  return exact;
}

ExactPoint on_punch(const SurfaceSpec& surface, double contact_modulus,
                    double nominal_pressure, double surface_top, bool is_free) {
  ExactPoint exact;
  if (!surface.length ||
      nominal_pressure >= touching_pressure(surface, contact_modulus, is_free))
    return exact;
  const double side = *surface.length;
  const double load = nominal_pressure * side * side;
  const theory::PunchContact punch =
      theory::FlatPunch(surface.radius, contact_modulus).contact(load);
  if (punch.approach < 2.0 * surface.radius * std::abs(surface.tilt))
    return exact; // the edge of the end lifts
  exact.contact_radius = punch.contact_radius;
  exact.area_fraction = std::numbers::pi * punch.contact_radius *
                        punch.contact_radius / (side * side);
  if (surface.tilt != 0.0)
    return exact; // of the approach, only that of the middle is known
  exact.approach = punch.approach;
  exact.mean_gap = surface_top - punch.approach +
                   approach_excess(surface, contact_modulus, load, false);
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
                       double nominal_pressure, double surface_top,
                       bool is_free) {
  switch (surface.kind) {
  case mechanics::SurfaceKind::sphere:
    return on_sphere(surface, contact_modulus, nominal_pressure, surface_top,
                     is_free);
  case mechanics::SurfaceKind::punch:
    return on_punch(surface, contact_modulus, nominal_pressure, surface_top,
                    is_free);
  case mechanics::SurfaceKind::wave_1d:
    return on_wave_1d(surface, contact_modulus, nominal_pressure);
  case mechanics::SurfaceKind::wave_2d:
    return on_wave_2d(surface, contact_modulus, nominal_pressure);
  default:
    return {};
  }
}

double touching_pressure(const SurfaceSpec& surface, double contact_modulus,
                         bool is_free) {
  if (surface.kind != mechanics::SurfaceKind::punch || !surface.length ||
      !(surface.recess > 0.0) || !(*surface.length > 2.0 * surface.radius))
    return std::numeric_limits<double>::infinity();
  const double side = *surface.length;
  const theory::FlatPunch punch(surface.radius, contact_modulus);
  const double load =
      is_free ? punch.touching_load(surface.recess, side / std::numbers::sqrt2)
              : punch.touching_load_in_array(surface.recess, side);
  return load / (side * side);
}

double approach_excess(const SurfaceSpec& sphere, double contact_modulus,
                       double load, bool is_free) {
  const double side = sphere.length.value_or(not_a_number);
  if (!is_free)
    return theory::square_array_approach(load, contact_modulus, side);
  const theory::HertzContact hertz =
      theory::hertz_contact(load, sphere.radius, contact_modulus);
  const int points = sphere.points.value_or(0);
  double sum = 0.0;
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      sum += theory::hertz_displacement(
          hertz, std::hypot(ix - points / 2, iy - points / 2) * side / points);
  return sum / (static_cast<double>(points) * points);
}

} // namespace asperity::reports
