#include "theory/hertz.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

HertzContact hertz_contact(double load, double sphere_radius,
                           double contact_modulus) {
  require_not_negative("load", load, "N");
  require_positive("sphere_radius", sphere_radius, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  const double radius =
      std::cbrt(0.75 * load * sphere_radius / contact_modulus);
  const double approach = radius * radius / sphere_radius;
  // p_0 = 3 F/(2 pi a^2) without a division by the area of no contact
  const double peak = 2.0 * contact_modulus * radius / (pi * sphere_radius);
  return {load, sphere_radius, contact_modulus,      radius,
          peak, approach,      0.4 * load * approach};
}

double hertz_load(double contact_radius, double sphere_radius,
                  double contact_modulus) {
  require_not_negative("contact_radius", contact_radius, "m");
  require_positive("sphere_radius", sphere_radius, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  return 4.0 / 3.0 * contact_modulus * std::pow(contact_radius, 3) /
         sphere_radius;
}

double hertz_pressure(const HertzContact& contact, double radius) {
  require_not_negative("radius", radius, "m");
  if (radius >= contact.contact_radius)
    return 0.0;
  const double ratio = radius / contact.contact_radius;
  return contact.peak_pressure * std::sqrt((1.0 - ratio) * (1.0 + ratio));
}

double hertz_displacement(const HertzContact& contact, double radius) {
  require_not_negative("radius", radius, "m");
  const double a = contact.contact_radius;
  const double r = radius;
  // p_0/(2 a E*) = 1/(pi R), finite for no contact at all
  const double scale = 1.0 / (pi * contact.sphere_radius);
  if (r <= a)
    return 0.5 * pi * scale * (2.0 * a * a - r * r);
  return scale * ((2.0 * a * a - r * r) * std::asin(a / r) +
                  a * std::sqrt((r - a) * (r + a)));
}

double hertz_gap(const HertzContact& contact, double radius) {
  if (radius <= contact.contact_radius)
    return 0.0;
  return 0.5 * radius * radius / contact.sphere_radius - contact.approach +
         hertz_displacement(contact, radius);
}

// Ewald's sum at the width where the lattice and its reciprocal are alike:
// sum' 1/n -> 2 sum' erfc(sqrt(pi) n)/n - 4, with the background taken off.
double square_array_constant() {
  const int reach = 4; // erfc(4 sqrt(pi)) = 1e-23
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      if (i != 0 || j != 0) {
        const double n = std::hypot(i, j);
        sum += std::erfc(std::sqrt(pi) * n) / n;
      }
  return 4.0 - 2.0 * sum;
}

double square_array_approach(double load, double contact_modulus,
                             double period) {
  require_not_negative("load", load, "N");
  require_positive("contact_modulus", contact_modulus, "Pa");
  require_positive("period", period, "m");
  return square_array_constant() * load / (pi * contact_modulus * period);
}

} // namespace asperity::theory
