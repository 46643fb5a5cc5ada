#include "reports/analysis/exact.hpp"
#include "theory/exact/hertz.hpp"
#include "theory/exact/punches.hpp"
#include "theory/exact/wave_2d.hpp"
#include "theory/exact/westergaard.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace asperity::reports {
namespace {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

/// Largest diameter of a contact in a square array over the period: for which
/// square_array_contact() is accurate to 0.3 %, and, of contacts whose images
/// are point loads, to (a/L)^3.
constexpr double widest_in_array = 0.6;
constexpr double widest_of_point_loads = 0.2;

/// The contact of one indenter.
struct IndenterContact {
  double radius = 0.0;
  double approach = 0.0; ///< if it is alone
  double energy = 0.0;   ///< likewise [J]; NaN: not known
};

/// The contact under a load; nothing where the solution does not hold.
std::optional<IndenterContact> indenter_contact(const SurfaceSpec& surface,
                                                double contact_modulus,
                                                double load, bool is_free) {
  const double side = *surface.length;
  // Whether the contact is inside the square, and apart from its images.
  const auto fits = [&](double radius, double widest) {
    return 2.0 * radius <= (is_free ? 1.0 : widest) * side;
  };
  if (surface.kind == SurfaceKind::sphere) {
    const theory::HertzContact spot =
        sphere_contact(surface, contact_modulus, load, is_free);
    if (!fits(spot.contact_radius, widest_in_array))
      return {};
    return IndenterContact{
        spot.contact_radius,
        theory::hertz_contact(load, surface.radius, contact_modulus).approach,
        spot.elastic_energy};
  }
  if (surface.kind == SurfaceKind::punch) {
    const theory::PunchContact spot =
        theory::FlatPunch(surface.radius, contact_modulus).contact(load);
    if (load / (side * side) >=
            touching_pressure(surface, contact_modulus, is_free) ||
        spot.approach < 2.0 * surface.radius * std::abs(surface.tilt))
      return {}; // the recess touches, or the edge of the end lifts
    return IndenterContact{spot.contact_radius, spot.approach,
                           0.5 * load * spot.approach};
  }
  const bool is_cone = surface.kind == SurfaceKind::cone;
  const theory::PunchContact spot =
      is_cone ? theory::Cone(surface.slope, contact_modulus).contact(load)
              : theory::RoundedPunch(surface.radius, surface.edge_radius,
                                     contact_modulus)
                    .contact(load);
  if (!fits(spot.contact_radius, widest_of_point_loads))
    return {};
  return IndenterContact{spot.contact_radius, spot.approach,
                         is_cone ? load * spot.approach / 3.0 : not_a_number};
}

ExactPoint on_indenter(const SurfaceSpec& surface, double contact_modulus,
                       double nominal_pressure, double surface_top,
                       bool is_free) {
  ExactPoint exact;
  if (!surface.length)
    return exact;
  const double area = *surface.length * *surface.length;
  const double load = nominal_pressure * area;
  const auto spot = indenter_contact(surface, contact_modulus, load, is_free);
  if (!spot)
    return exact;
  exact.contact_radius = spot->radius;
  exact.area_fraction = std::numbers::pi * spot->radius * spot->radius / area;
  if (surface.tilt != 0.0)
    return exact; // of the approach, only that of the middle is known
  exact.approach = spot->approach;
  if (is_free)
    exact.elastic_energy = spot->energy / area;
  exact.mean_gap = surface_top - spot->approach +
                   approach_excess(surface, contact_modulus, load, is_free);
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
  case SurfaceKind::sphere:
  case SurfaceKind::punch:
  case SurfaceKind::cone:
  case SurfaceKind::rounded_punch:
    return on_indenter(surface, contact_modulus, nominal_pressure, surface_top,
                       is_free);
  case SurfaceKind::wave_1d: // which are periodic
    return is_free ? ExactPoint()
                   : on_wave_1d(surface, contact_modulus, nominal_pressure);
  case SurfaceKind::wave_2d:
    return is_free ? ExactPoint()
                   : on_wave_2d(surface, contact_modulus, nominal_pressure);
  default:
    return {};
  }
}

double touching_pressure(const SurfaceSpec& surface, double contact_modulus,
                         bool is_free) {
  if (surface.kind != SurfaceKind::punch || !surface.length ||
      !(surface.recess > 0.0) || !(*surface.length > 2.0 * surface.radius))
    return std::numeric_limits<double>::infinity();
  const double side = *surface.length;
  const theory::FlatPunch punch(surface.radius, contact_modulus);
  const double load =
      is_free ? punch.touching_load(surface.recess, side / std::numbers::sqrt2)
              : punch.touching_load_in_array(surface.recess, side);
  return load / (side * side);
}

theory::HertzContact sphere_contact(const SurfaceSpec& sphere,
                                    double contact_modulus, double load,
                                    bool is_free) {
  return is_free ? theory::hertz_contact(load, sphere.radius, contact_modulus)
                 : theory::square_array_contact(
                       load, sphere.radius, contact_modulus,
                       sphere.length.value_or(not_a_number))
                       .spot;
}

namespace {

/// The mean of a function of the distance from the middle over the nodes of the
/// map.
template <class Function>
double mean_over_nodes(const SurfaceSpec& surface, const Function& function) {
  const int points = surface.points.value_or(0);
  if (points == 0)
    return not_a_number;
  const double spacing = surface.length.value_or(not_a_number) / points;
  // Of the middle and of the border there is one row, of the others two.
  const auto rows = [&](int i) {
    return i == 0 || 2 * i == points ? 1.0 : 2.0;
  };
  double sum = 0.0;
  for (int i = 0; 2 * i <= points; ++i)
    for (int j = 0; j <= i; ++j)
      sum += (i == j ? 1.0 : 2.0) * rows(i) * rows(j) *
             function(std::hypot(i, j) * spacing);
  return sum / (static_cast<double>(points) * points);
}

} // namespace

double approach_excess(const SurfaceSpec& surface, double contact_modulus,
                       double load, bool is_free) {
  const double side = surface.length.value_or(not_a_number);
  if (surface.kind != SurfaceKind::sphere && !is_free)
    return theory::square_array_approach(load, contact_modulus, side);
  if (surface.kind == SurfaceKind::punch) {
    const theory::FlatPunch punch(surface.radius, contact_modulus);
    return mean_over_nodes(surface, [&](double radius) {
      return punch.displacement(load, radius);
    });
  }
  if (surface.kind == SurfaceKind::cone) {
    const theory::Cone cone(surface.slope, contact_modulus);
    return mean_over_nodes(surface, [&](double radius) {
      return cone.displacement(load, radius);
    });
  }
  if (surface.kind == SurfaceKind::rounded_punch) {
    const theory::RoundedPunch punch(surface.radius, surface.edge_radius,
                                     contact_modulus);
    const theory::PunchContact spot = punch.contact(load);
    return mean_over_nodes(surface, [&](double radius) {
      return punch.displacement(spot, radius);
    });
  }
  const theory::HertzContact hertz =
      theory::hertz_contact(load, surface.radius, contact_modulus);
  return is_free
             ? mean_over_nodes(surface,
                               [&](double radius) {
                                 return theory::hertz_displacement(hertz,
                                                                   radius);
                               })
             : hertz.approach - theory::square_array_contact(
                                    load, surface.radius, contact_modulus, side)
                                    .approach;
}

} // namespace asperity::reports
