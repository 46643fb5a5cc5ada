#include "theory/exact/hertz.hpp"

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
  // p_0 = 3 F/(2 pi a^2), without dividing by a zero area if there is no
  // contact
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
  // p_0/(2 a E*) = 1/(pi R), which is finite without contact
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

double AxisStress::largest_shear() const {
  return 0.5 * std::abs(radial - axial);
}

AxisStress hertz_axis_stress(const HertzContact& contact, double depth,
                             double poisson) {
  require_positive("contact_radius", contact.contact_radius, "m");
  require_not_negative("depth", depth, "m");
  require_between("poisson", poisson, -1.0, 0.5, "1");
  const double z = depth / contact.contact_radius;
  const double fall = 1.0 / (1.0 + z * z);
  double spread = 1.0 - z * std::atan2(1.0, z);
  if (z > 20.0) { // 1/(3 z^2) - 1/(5 z^4) + ... avoids cancellation
    const double square = 1.0 / (z * z);
    spread =
        square * (1.0 / 3.0 -
                  square * (1.0 / 5.0 - square * (1.0 / 7.0 - square / 9.0)));
  }
  return {-contact.peak_pressure * fall,
          -contact.peak_pressure * ((1.0 + poisson) * spread - 0.5 * fall)};
}

namespace {

// Sum over the square lattice without its origin, to the precision of
// exp(-pi n^2)
template <class Function>
double lattice_sum(Function function) {
  const int reach = 4; // erfc(4 sqrt(pi)) = 1e-23
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      if (i != 0 || j != 0)
        sum += function(static_cast<double>(i * i + j * j));
  return sum;
}

} // namespace

// Ewald's sum, with the width for which the direct and the reciprocal sums are
// equal:
//   pi^-s Gamma(s) sum' n^-2s = 1/(s - 1) - 1/s + sum' [Gamma(s, x) x^-s +
//   Gamma(1 - s, x) x^{s - 1}],  x = pi n^2,
// here with s = 1/2, for which the lattice sum means the sum minus its
// integral.
double square_array_constant() {
  return 4.0 - 2.0 * lattice_sum([](double square) {
                 return std::erfc(std::sqrt(pi * square)) / std::sqrt(square);
               });
}

// The same sum with s = 3/2, from Gamma(1/2, x) = sqrt(pi) erfc(sqrt x) and the
// recurrence relation.
double square_array_curvature_constant() {
  const double sum = lattice_sum([](double square) {
    const double root = std::sqrt(pi * square);
    const double half = std::sqrt(pi) * std::erfc(root); // Gamma(1/2, x)
    const double gaussian = std::exp(-root * root);
    const double three_halves = 0.5 * half + root * gaussian;
    const double minus_half = 2.0 * (gaussian / root - half);
    return three_halves / (root * root * root) + minus_half * root;
  });
  const double gamma_three_halves = 0.5 * std::sqrt(pi);
  return pi * std::sqrt(pi) / gamma_three_halves * (2.0 - 2.0 / 3.0 + sum);
}

double square_array_approach(double load, double contact_modulus,
                             double period) {
  require_not_negative("load", load, "N");
  require_positive("contact_modulus", contact_modulus, "Pa");
  require_positive("period", period, "m");
  return square_array_constant() * load / (pi * contact_modulus * period);
}

SquareArrayContact square_array_contact(double load, double sphere_radius,
                                        double contact_modulus, double period) {
  require_positive("sphere_radius", sphere_radius, "m");
  const double uniform = square_array_approach(load, contact_modulus, period);
  const double scale = load / (pi * contact_modulus * period);
  const double bend = square_array_curvature_constant() / (period * period);
  const double curvature = 1.0 / sphere_radius + 0.5 * bend * scale;
  const HertzContact spot =
      hertz_contact(load, 1.0 / curvature, contact_modulus);
  const double spread = 0.1 * spot.contact_radius * spot.contact_radius;
  return {spot, spot.approach - uniform + scale * bend * spread};
}

} // namespace asperity::theory
