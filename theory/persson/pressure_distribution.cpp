#include "theory/persson/pressure_distribution.hpp"

#include "base/require.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

double stress_variance(double contact_modulus, double rms_slope) {
  require_positive("contact_modulus", contact_modulus, "Pa");
  require_positive("rms_slope", rms_slope, "1");
  const double stress = contact_modulus * rms_slope;
  return stress * stress / 8.0; // Eq. (2)
}

double pressure_density(double contact_pressure, double nominal_pressure,
                        double variance) {
  require_not_negative("contact_pressure", contact_pressure, "Pa");
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  require_positive("variance", variance, "Pa^2");
  const double distance = contact_pressure - nominal_pressure;
  const double mirror_loss =
      -std::expm1(-contact_pressure * nominal_pressure / variance);
  return std::exp(-distance * distance / (4.0 * variance)) * mirror_loss /
         (2.0 * std::sqrt(pi * variance)); // Eq. (1)
}

double pressure_share(double low, double high, double nominal_pressure,
                      double variance) {
  require_not_negative("low", low, "Pa");
  require_between("high", high, low, std::numeric_limits<double>::max(), "Pa");
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  require_positive("variance", variance, "Pa^2");
  const double width = 2.0 * std::sqrt(variance);
  const auto rise = [&](double centre) {
    return std::erf((high - centre) / width) - std::erf((low - centre) / width);
  };
  return 0.5 * (rise(nominal_pressure) - rise(-nominal_pressure));
}

double area_fraction(double nominal_pressure, double variance) {
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  require_positive("variance", variance, "Pa^2");
  return std::erf(0.5 * nominal_pressure / std::sqrt(variance)); // Eq. (4)
}

PressureMoments pressure_moments(double nominal_pressure, double variance) {
  const double area = area_fraction(nominal_pressure, variance);
  const double square = nominal_pressure * nominal_pressure;
  const double edge = 2.0 * nominal_pressure * std::sqrt(variance / pi) *
                      std::exp(-square / (4.0 * variance));
  return {area, nominal_pressure, (square + 2.0 * variance) * area + edge};
}

} // namespace asperity::theory
