#include "theory/exact/wave_2d.hpp"

#include "base/require.hpp"
#include "theory/exact/hertz.hpp"
#include "theory/exact/wave_2d_table.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <vector>

namespace asperity::theory {

using std::numbers::pi;

namespace {

// Cubic interpolation through the four nearest rows, which keeps the noise from
// counting contact nodes local.
struct Interpolant {
  std::vector<double> at, values;

  double operator()(double x) const {
    const auto above = std::upper_bound(at.begin(), at.end(), x);
    const auto place = std::clamp<std::ptrdiff_t>(above - at.begin() - 2, 0,
                                                  std::ssize(at) - 4);
    const auto first = static_cast<std::size_t>(place);
    double sum = 0.0;
    for (std::size_t i = first; i < first + 4; ++i) {
      double weight = values[i];
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i)
          weight *= (x - at[j]) / (at[i] - at[j]);
      sum += weight;
    }
    return sum;
  }
};

// Corrections to the two limits, from the table, over t = P^{2/3}; in units of
// D and p*.
struct BetweenTheEnds {
  // Up to the split load: A divided by the light-load limit, and the error of
  // the gap in that limit divided by t^2.
  Interpolant light_area, light_gap;
  // Above the split load: 1 - A over 1 - P, and the gap over (1 - P)^{5/2}.
  Interpolant heavy_area, heavy_gap;
};

// Neighbouring contacts coalesce at this load; each side is interpolated
// separately.
constexpr double split_load = 0.375;

BetweenTheEnds between_the_ends() {
  const Wave2dContact unit(1.0, 1.0, 1.0 / (std::numbers::sqrt2 * pi));
  std::vector<double> light{0.0}, light_area{1.0}, light_gap{0.0};
  std::vector<double> heavy, heavy_area, heavy_gap;
  for (const Wave2dRow& row : wave_2d_table) {
    const double t = row.load, ratio = t * std::sqrt(t);
    const double deficit = 1.0 - ratio;
    if (t <= split_load) {
      light.push_back(t);
      light_area.push_back(row.area_fraction / unit.light_area_fraction(ratio));
      light_gap.push_back((row.reduced_mean_gap - unit.light_mean_gap(ratio)) /
                          (t * t));
    }
    if (t >= split_load) {
      heavy.push_back(t);
      heavy_area.push_back((1.0 - row.area_fraction) / deficit);
      heavy_gap.push_back(row.reduced_mean_gap / std::pow(deficit, 2.5));
    }
  }
  light_gap[0] = 2.0 * light_gap[1] - light_gap[2]; // linear extrapolation
  heavy.push_back(1.0);
  heavy_area.push_back(1.5 / pi);
  heavy_gap.push_back(unit.heavy_mean_gap(0.0));
  return {{light, light_area},
          {light, light_gap},
          {heavy, heavy_area},
          {heavy, heavy_gap}};
}

const BetweenTheEnds& between() {
  static const BetweenTheEnds table = between_the_ends();
  return table;
}

} // namespace

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

double Wave2dContact::area_fraction(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  const double load = std::pow(ratio, 2.0 / 3.0);
  if (load <= split_load)
    return light_area_fraction(nominal_pressure) * between().light_area(load);
  return 1.0 - (1.0 - ratio) * between().heavy_area(load);
}

double Wave2dContact::mean_gap(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  const double load = std::pow(ratio, 2.0 / 3.0);
  if (load <= split_load)
    return light_mean_gap(nominal_pressure) +
           amplitude_ * load * load * between().light_gap(load);
  return amplitude_ * std::pow(1.0 - ratio, 2.5) * between().heavy_gap(load);
}

// Integration panels end at the rows; in P^{1/3} the gap in the light-load
// limit is a polynomial.
double Wave2dContact::elastic_energy(double nominal_pressure) const {
  const double ratio = reduced_pressure(nominal_pressure);
  const double last = std::cbrt(ratio);
  const auto integrand = [this](double root) { // u dP/d(root)
    const double pressure = root * root * root * full_contact_pressure_;
    return 3.0 * root * root * mean_gap(pressure);
  };
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  double sum = 0.0, from = 0.0;
  for (const Wave2dRow& row : wave_2d_table) {
    const double to = std::min(last, std::sqrt(row.load));
    sum += Gauss::integrate(integrand, from, to);
    from = to;
  }
  sum += Gauss::integrate(integrand, from, last);
  return full_contact_pressure_ *
         (sum - ratio * mean_gap(ratio * full_contact_pressure_));
}

// (1/2) <p u> for p = p* cos cos, u = D cos cos, with <cos^2 cos^2> = 1/4
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
