#include "theory/exact/adhesive_sphere.hpp"

#include "base/require.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

namespace {

void check(const AdhesiveSphere& sphere) {
  require_positive("sphere_radius", sphere.sphere_radius, "m");
  require_positive("contact_modulus", sphere.contact_modulus, "Pa");
  require_positive("work_of_adhesion", sphere.work_of_adhesion, "J/m^2");
}

// pi w R, the unit of force.
double force_unit(const AdhesiveSphere& sphere) {
  return pi * sphere.work_of_adhesion * sphere.sphere_radius;
}

// The cohesive (Dugdale) zone, with t = arcsec(c/a), s = tan t, n = 1/cos t.
struct Zone {
  double angle = 0.0;

  double tangent() const { return std::tan(angle); }

  double ratio() const { return 1.0 / std::cos(angle); } // n = c/a

  double peeling() const { // s + (n^2 - 2) t
    return tangent() - angle + angle * tangent() * tangent();
  }

  double stretching() const { // s t - n + 1
    const double half = std::sin(0.5 * angle);
    return (angle * std::sin(angle) - 2.0 * half * half) * ratio();
  }

  double pull() const { // s + n^2 t
    return tangent() + ratio() * ratio() * angle;
  }
};

Zone zone_of(double reduced_radius, double lambda) {
  const double a = reduced_radius;
  std::uintmax_t steps = 300;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double angle) {
        const Zone zone{angle};
        return std::log(0.5 * lambda * a * a * zone.peeling() +
                        4.0 / 3.0 * lambda * lambda * a * zone.stretching());
      },
      1e-12, 0.5 * pi * (1.0 - 1e-14),
      boost::math::tools::eps_tolerance<double>(52), steps);
  return {0.5 * (bracket.first + bracket.second)};
}

} // namespace

MaugisSphere::MaugisSphere(const AdhesiveSphere& sphere, double adhesive_stress)
    : sphere_(sphere), adhesive_stress_(adhesive_stress) {
  check(sphere);
  require_positive("adhesive_stress", adhesive_stress, "Pa");
  const auto& [radius, modulus, work] = sphere;
  const double stiffness = 4.0 / 3.0 * modulus; // K
  radius_unit_ = std::cbrt(pi * work * radius * radius / stiffness);
  transition_parameter_ =
      2.0 * adhesive_stress *
      std::cbrt(radius / (pi * work * stiffness * stiffness));
}

AdhesiveContact MaugisSphere::contact(double contact_radius) const {
  require_positive("contact_radius", contact_radius, "m");
  const double lambda = transition_parameter_;
  const double a = contact_radius / radius_unit_;
  const Zone zone = zone_of(a, lambda);
  const double approach_unit =
      radius_unit_ * radius_unit_ / sphere_.sphere_radius;
  return {contact_radius, contact_radius * zone.ratio(),
          approach_unit * (a * a - 4.0 / 3.0 * lambda * a * zone.tangent()),
          force_unit(sphere_) * (a * a * a - lambda * a * a * zone.pull())};
}

double MaugisSphere::pressure(const AdhesiveContact& contact,
                              double radius) const {
  require_not_negative("radius", radius, "m");
  const double a = contact.contact_radius, c = contact.adhesive_radius;
  if (radius > c)
    return 0.0;
  if (radius > a)
    return -adhesive_stress_;
  const double root = std::sqrt((a - radius) * (a + radius));
  const double hertz =
      2.0 * sphere_.contact_modulus * root / (pi * sphere_.sphere_radius);
  // arccos[(2a^2 - c^2 - r^2)/(c^2 - r^2)] = 2 atan sqrt[(c^2 - a^2)/(a^2 -
  // r^2)], without cancellation
  const double annulus = std::sqrt((c - a) * (c + a));
  return hertz - 2.0 / pi * adhesive_stress_ * std::atan2(annulus, root);
}

double MaugisSphere::weakest_radius() const {
  const auto load = [&](double log_radius) {
    return contact(radius_unit_ * std::exp(log_radius)).load;
  };
  const auto minimum = boost::math::tools::brent_find_minima(
      load, std::log(1e-4), std::log(10.0), 30);
  return radius_unit_ * std::exp(minimum.first);
}

double MaugisSphere::pull_off_force() const {
  return -contact(weakest_radius()).load;
}

AdhesiveContact MaugisSphere::contact_at_load(double load) const {
  const double weakest = weakest_radius();
  const auto excess = [&](double log_radius) {
    return contact(std::exp(log_radius)).load - load;
  };
  const double from = std::log(weakest);
  if (!(excess(from) <= 0.0 && std::isfinite(load)))
    refuse_argument("load", load, "finite and not below the pull-off [N]");
  double to = from + 1.0;
  while (excess(to) < 0.0)
    to += 1.0;
  std::uintmax_t steps = 300;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, from, to, boost::math::tools::eps_tolerance<double>(50), steps);
  return contact(std::exp(0.5 * (bracket.first + bracket.second)));
}

} // namespace asperity::theory
