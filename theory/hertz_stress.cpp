#include "theory/hertz_stress.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::theory {
namespace {

AxisymmetricStress on_axis(const HertzContact& contact, double depth,
                           double poisson) {
  const AxisStress axis = hertz_axis_stress(contact, depth, poisson);
  return {axis.radial, axis.radial, axis.axial, 0.0};
}

} // namespace

double AxisymmetricStress::von_mises() const {
  const double squares = std::pow(radial - hoop, 2) +
                         std::pow(hoop - axial, 2) +
                         std::pow(axial - radial, 2);
  return std::sqrt(0.5 * squares + 3.0 * shear * shear);
}

double AxisymmetricStress::largest_shear() const {
  const double middle = 0.5 * (radial + axial);
  const double half = std::hypot(0.5 * (radial - axial), shear);
  const double highest = std::max(middle + half, hoop);
  const double lowest = std::min(middle - half, hoop);
  return 0.5 * (highest - lowest);
}

AxisymmetricStress hertz_stress(const HertzContact& contact, double radius,
                                double depth, double poisson) {
  require_not_negative("radius", radius, "m");
  require_not_negative("depth", depth, "m");
  require_between("poisson", poisson, -1.0, 0.5, "1");
  const double a = contact.contact_radius;
  if (radius < 1e-4 * a)
    return on_axis(contact, depth, poisson);

  const double r = radius / a;
  const double z = depth / a;
  const double s = r * r + z * z - 1.0;
  const double root = std::hypot(s, 2.0 * z);
  // u = (s + root)/2 and z^2/u = (root - s)/2, each without cancellation.
  const double u = s >= 0.0 ? 0.5 * (s + root) : 2.0 * z * z / (root - s);
  const double k_square =
      s >= 0.0 ? 2.0 * z * z / (root + s) : 0.5 * (root - s);
  const double k = std::sqrt(s >= 0.0 && root == 0.0 ? 0.0 : k_square);
  const double k_cube = k * k * k;
  // k^3 u/(u^2 + z^2) = k^3/(u + k^2), finite on the face.
  const double normal = u + k * k > 0.0 ? k_cube / (u + k * k) : 0.0;
  const double hole = (1.0 - 2.0 * poisson) / 3.0 * (1.0 - k_cube) / (r * r);
  const double bend = (1.0 - poisson) * u / (1.0 + u);
  const double arc =
      (1.0 + poisson) * std::sqrt(u) * std::atan2(1.0, std::sqrt(u));

  const double scale = contact.peak_pressure; // (3/2) p_m
  const double tangential = // r z^2 sqrt(u)/((u^2 + z^2)(1 + u))
      u + k * k > 0.0 ? r * k * k * std::sqrt(u) / ((u + k * k) * (1.0 + u))
                      : 0.0;
  return {scale * (hole + normal + k * (arc + bend - 2.0)),
          -scale * (hole + k * (2.0 * poisson + bend - arc)), -scale * normal,
          -scale * tangential};
}

} // namespace asperity::theory
