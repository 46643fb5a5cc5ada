#include "tests/theory/hertz_stress.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

namespace {

/// A point in units of a, in the coordinates of Huber's solution.
struct SpheroidalPoint {
  double r = 0.0, z = 0.0;
  double u = 0.0;       ///< r^2/(1 + u) + z^2/u = 1
  double k = 0.0;       ///< z/sqrt(u), 0..1
  double angle = 0.0;   ///< atan(1/sqrt(u))
  double deficit = 0.0; ///< 1 - sqrt(u) angle
  double bend = 0.0;    ///< angle - sqrt(u)/(1 + u)
};

// 1 - atan(x)/x, by its series for small x, where the difference would cancel.
double arc_deficit(double x) {
  if (x > 0.1)
    return 1.0 - std::atan(x) / x;
  double sum = 0.0;
  for (int n = 8; n >= 1; --n) // truncation error: x^16 of the first term
    sum = (1.0 / (2.0 * n + 1.0) - sum) * x * x;
  return sum;
}

SpheroidalPoint point_at(const HertzContact& contact, double radius,
                         double depth, double poisson) {
  require_positive("contact_radius", contact.contact_radius, "m");
  require_not_negative("radius", radius, "m");
  require_not_negative("depth", depth, "m");
  require_between("poisson", poisson, -1.0, 0.5, "1");
  SpheroidalPoint point;
  point.r = radius / contact.contact_radius;
  point.z = depth / contact.contact_radius;
  const double r = point.r;
  const double z = point.z;
  const double s = (r - 1.0) * (r + 1.0) + z * z;
  const double root = std::hypot(s, 2.0 * z);
  if (root == 0.0) // the contact edge
    return {r, z, 0.0, 0.0, 0.5 * pi, 1.0, 0.5 * pi};
  // u = (s + root)/2 and z^2/u = (root - s)/2, each computed without
  // cancellation.
  point.u = s >= 0.0 ? 0.5 * (s + root) : 2.0 * z * z / (root - s);
  point.k = std::sqrt(s >= 0.0 ? 2.0 * z * z / (root + s) : 0.5 * (root - s));
  const double q = std::sqrt(point.u);
  point.angle = std::atan2(1.0, q);
  point.deficit = q > 0.0 ? arc_deficit(1.0 / q) : 1.0;
  const double fall = 1.0 / (1.0 + point.u);
  point.bend = q < 1.0 ? point.angle - q * fall : (fall - point.deficit) / q;
  return point;
}

// (1 - k^3)/r^2, from 1 - k^2 = r^2/(1 + u).
double boundary_share(const SpheroidalPoint& point) {
  const double k = point.k;
  return (1.0 + k + k * k) / ((1.0 + k) * (1.0 + point.u));
}

} // namespace

double AxisymmetricStress::largest_shear() const {
  const double middle = 0.5 * (radial + axial);
  const double half = std::hypot(0.5 * (radial - axial), shear);
  const double highest = std::max(middle + half, hoop);
  const double lowest = std::min(middle - half, hoop);
  return 0.5 * (highest - lowest);
}

AxisymmetricStress hertz_stress(const HertzContact& contact, double radius,
                                double depth, double poisson) {
  const SpheroidalPoint at = point_at(contact, radius, depth, poisson);
  const double k = at.k;
  const double square = at.u + k * k;
  // k^3 u/(u^2 + z^2) = k^3/(u + k^2), finite on the surface.
  const double normal = square > 0.0 ? k * k * k / square : 0.0;
  const double fall = 1.0 / (1.0 + at.u);
  const double hole = (1.0 - 2.0 * poisson) / 3.0 * boundary_share(at);
  const double arc = (1.0 + poisson) * at.deficit;
  const double spread = (1.0 - poisson) * fall;
  const double scale = contact.peak_pressure; // (3/2) p_m
  const double tangential = // r z^2 sqrt(u)/((u^2 + z^2)(1 + u))
      square > 0.0 ? at.r * k * k * std::sqrt(at.u) * fall / square : 0.0;
  return {scale * (hole + normal - k * (arc + spread)),
          -scale * (hole + k * (arc - spread)), -scale * normal,
          -scale * tangential};
}

} // namespace asperity::theory
