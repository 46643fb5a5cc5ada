#include "theory/exact/punches.hpp"

#include "base/require.hpp"
#include "theory/exact/hertz.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

FlatPunch::FlatPunch(double punch_radius, double contact_modulus)
    : punch_radius_(punch_radius), contact_modulus_(contact_modulus) {
  require_positive("punch_radius", punch_radius, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
}

PunchContact FlatPunch::contact(double load) const {
  if (!std::isfinite(load))
    refuse_argument("load", load, "finite [N]");
  return {punch_radius_, 0.5 * load / (contact_modulus_ * punch_radius_), load};
}

double FlatPunch::pressure(double load, double radius) const {
  require_not_negative("radius", radius, "m");
  const double mean = contact(load).load / (pi * punch_radius_ * punch_radius_);
  if (radius > punch_radius_)
    return 0.0;
  const double ratio = radius / punch_radius_;
  return 0.5 * mean / std::sqrt((1.0 - ratio) * (1.0 + ratio));
}

double FlatPunch::displacement(double load, double radius) const {
  require_not_negative("radius", radius, "m");
  const double approach = contact(load).approach;
  if (radius <= punch_radius_)
    return approach;
  return 2.0 / pi * approach * std::asin(punch_radius_ / radius);
}

double FlatPunch::touching_load_in_array(double recess, double period) const {
  require_positive("recess", recess, "m");
  if (!(period > 2.0 * punch_radius_))
    refuse_argument("period", period, "larger than two punch radii [m]");
  const double images =
      (2.0 - std::numbers::sqrt2) * square_array_constant() / (pi * period);
  return recess * contact_modulus_ / (0.5 / punch_radius_ - images);
}

double FlatPunch::touching_load(double recess, double radius) const {
  require_positive("recess", recess, "m");
  if (!(radius > punch_radius_))
    refuse_argument("radius", radius, "larger than the punch radius [m]");
  return recess / (contact(1.0).approach - displacement(1.0, radius));
}

double FlatPunch::moment(double angle) const {
  if (!std::isfinite(angle))
    refuse_argument("angle", angle, "finite [rad]");
  return 4.0 / 3.0 * contact_modulus_ * punch_radius_ * punch_radius_ *
         punch_radius_ * angle;
}

Cone::Cone(double slope, double contact_modulus)
    : slope_(slope), contact_modulus_(contact_modulus) {
  require_positive("slope", slope, "1");
  require_positive("contact_modulus", contact_modulus, "Pa");
}

PunchContact Cone::contact(double load) const {
  require_not_negative("load", load, "N");
  const double radius =
      std::sqrt(2.0 * load / (pi * contact_modulus_ * slope_));
  return {radius, 0.5 * pi * slope_ * radius, load};
}

double Cone::pressure(double load, double radius) const {
  require_not_negative("radius", radius, "m");
  const double a = contact(load).contact_radius;
  if (radius >= a)
    return 0.0;
  return 0.5 * contact_modulus_ * slope_ * std::acosh(a / radius);
}

double Cone::displacement(double load, double radius) const {
  require_not_negative("radius", radius, "m");
  const PunchContact spot = contact(load);
  const double a = spot.contact_radius;
  if (radius <= a)
    return spot.approach - slope_ * radius;
  const double root = std::sqrt((radius - a) * (radius + a));
  // root - r = -a^2/(root + r), which avoids cancellation far from the contact
  return slope_ * (a * std::asin(a / radius) - a * a / (root + radius));
}

RoundedPunch::RoundedPunch(double end_radius, double edge_radius,
                           double contact_modulus)
    : end_radius_(end_radius),
      edge_radius_(edge_radius),
      contact_modulus_(contact_modulus) {
  require_positive("end_radius", end_radius, "m");
  require_positive("edge_radius", edge_radius, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
}

PunchContact RoundedPunch::contact(double load) const {
  require_not_negative("load", load, "N");
  const double b = end_radius_;
  if (load == 0.0)
    return {b, 0.0, 0.0};
  // In s/b: the bracket of F is b^3 times a number from y^3/3 to 2 y^3/3.
  const double wanted =
      0.5 * load * edge_radius_ / (contact_modulus_ * b * b * b);
  const auto excess = [wanted](double y) {
    return 2.0 / 3.0 * y * y * y + 0.5 * (y - (1.0 + y * y) * std::atan(y)) -
           wanted;
  };
  constexpr double margin = 1e-6;
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, (1.0 - margin) * std::cbrt(1.5 * wanted),
      (1.0 + margin) * std::cbrt(3.0 * wanted),
      boost::math::tools::eps_tolerance<double>(52), steps);
  const double s = 0.5 * (low + high) * b;
  const double a = std::hypot(b, s);
  return {a, a / edge_radius_ * (s - b * std::atan(s / b)), load};
}

double RoundedPunch::displacement(const PunchContact& spot,
                                  double radius) const {
  require_not_negative("radius", radius, "m");
  const double a = spot.contact_radius, b = end_radius_;
  if (radius <= a) {
    const double beyond = std::max(radius - b, 0.0);
    return spot.approach - 0.5 * beyond * beyond / edge_radius_;
  }
  // x = b + (a - b) sin^2(angle) is smooth at both ends.
  const double sum = boost::math::quadrature::gauss<double, 20>::integrate(
      [&](double angle) {
        const double x = b + (a - b) * std::pow(std::sin(angle), 2);
        const double s = std::sqrt((x - b) * (x + b));
        return (2.0 * s - b * std::atan(s / b)) * std::asin(x / radius) *
               std::sin(2.0 * angle);
      },
      0.0, 0.5 * pi);
  return 2.0 / pi * (a - b) / edge_radius_ * sum;
}

} // namespace asperity::theory
