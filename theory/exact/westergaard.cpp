#include "theory/exact/westergaard.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

WestergaardContact::WestergaardContact(double amplitude, double wavelength,
                                       double contact_modulus)
    : amplitude_(amplitude),
      wavelength_(wavelength),
      full_contact_pressure_(pi * contact_modulus * amplitude / wavelength) {
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
}

double WestergaardContact::reduced_pressure(double nominal_pressure) const {
  require_not_negative("nominal_pressure", nominal_pressure, "Pa");
  return std::min(1.0, nominal_pressure / full_contact_pressure_);
}

double WestergaardContact::area_fraction(double nominal_pressure) const {
  return 2.0 / pi * std::asin(std::sqrt(reduced_pressure(nominal_pressure)));
}

double WestergaardContact::mean_gap(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  if (ratio == 0.0)
    return amplitude_;
  const double deficit = 1.0 - ratio;
  if (deficit > 0.1)
    return amplitude_ * (deficit + ratio * std::log(ratio));
  // sum_{n>=2} deficit^n/(n (n - 1)), because the terms of the closed form
  // nearly cancel
  double sum = 0.0;
  double power = deficit;
  for (int n = 2; n <= 18; ++n) {
    power *= deficit;
    sum += power / (n * (n - 1.0));
  }
  return amplitude_ * sum;
}

double WestergaardContact::adhesive_pressure(double area_fraction,
                                             double work_of_adhesion) const {
  require_not_negative("work_of_adhesion", work_of_adhesion, "J/m^2");
  if (!(area_fraction >= 0.0 && area_fraction < 1.0))
    refuse_argument("area_fraction", area_fraction, ">= 0 and < 1 [1]");
  const double modulus =
      full_contact_pressure_ * wavelength_ / (pi * amplitude_);
  const double alpha = std::numbers::sqrt2 / pi * wavelength_ / amplitude_ *
                       std::sqrt(work_of_adhesion / (modulus * wavelength_));
  const double angle = 0.5 * pi * area_fraction;
  return full_contact_pressure_ * (std::sin(angle) * std::sin(angle) -
                                   alpha * std::sqrt(std::tan(angle)));
}

double WestergaardContact::contact_stiffness(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  return full_contact_pressure_ / (amplitude_ * std::abs(std::log(ratio)));
}

double WestergaardContact::elastic_energy(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  if (ratio == 0.0)
    return 0.0;
  return amplitude_ * full_contact_pressure_ * ratio * ratio *
         (0.25 - 0.5 * std::log(ratio));
}

double WestergaardContact::contact_pressure(double position,
                                            double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  const double angle = pi * position / wavelength_;
  if (ratio == 1.0)
    return nominal_pressure + full_contact_pressure_ * std::cos(2.0 * angle);
  const double sine = std::sin(angle);
  const double depth = ratio - sine * sine;
  if (depth <= 0.0)
    return 0.0;
  return 2.0 * full_contact_pressure_ * std::abs(std::cos(angle)) *
         std::sqrt(depth);
}

double WestergaardContact::gap(double position, double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  const double sine = std::abs(std::sin(pi * position / wavelength_));
  const double edge = std::sqrt(ratio);
  if (sine <= edge || ratio == 1.0)
    return 0.0;
  if (ratio == 0.0)
    return 2.0 * amplitude_ * sine * sine;
  const double root = std::sqrt((sine - edge) * (sine + edge));
  return 2.0 * amplitude_ * (sine * root - ratio * std::acosh(sine / edge));
}

} // namespace asperity::theory
