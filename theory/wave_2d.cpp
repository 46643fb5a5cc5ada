#include "theory/wave_2d.hpp"

#include "base/require.hpp"
#include "theory/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

Wave2dContact::Wave2dContact(double amplitude, double wavelength,
                             double contact_modulus)
    : amplitude_(amplitude),
      wavelength_(wavelength),
      contact_modulus_(contact_modulus),
      full_contact_pressure_(std::numbers::sqrt2 * pi * contact_modulus *
                             amplitude / wavelength) {
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
}

double Wave2dContact::reduced_pressure(double nominal_pressure) const {
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  return std::min(1.0, nominal_pressure / full_contact_pressure_);
}

// (1/2) <p u> of p = p* cos cos, u = D cos cos, with <cos^2 cos^2> = 1/4
double Wave2dContact::full_contact_energy() const {
  return 0.125 * amplitude_ * full_contact_pressure_;
}

double Wave2dContact::light_area_fraction(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  return pi * std::pow(3.0 * ratio / (8.0 * pi), 2.0 / 3.0);
}

double Wave2dContact::light_mean_gap(double nominal_pressure) const {
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  const double crest_load = 0.5 * nominal_pressure * wavelength_ * wavelength_;
  const double crest_radius =
      wavelength_ * wavelength_ / (4.0 * pi * pi * amplitude_);
  const HertzContact crest =
      hertz_contact(crest_load, crest_radius, contact_modulus_);
  return amplitude_ - crest.approach +
         square_array_approach(crest_load, contact_modulus_,
                               wavelength_ / std::numbers::sqrt2);
}

double Wave2dContact::heavy_area_fraction(double nominal_pressure) const {
  return 1.0 - 1.5 / pi * (1.0 - reduced_pressure(nominal_pressure));
}

double Wave2dContact::heavy_mean_gap(double nominal_pressure) const {
  const double deficit = 1.0 - reduced_pressure(nominal_pressure);
  return 4.0 * std::sqrt(6.0) / (5.0 * pi * pi) * amplitude_ *
         std::pow(deficit, 2.5);
}

} // namespace asperity::theory
