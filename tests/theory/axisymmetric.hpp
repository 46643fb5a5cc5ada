#pragma once

// The displacement of an elastic half-space under any axisymmetric pressure, by
// quadrature: an independent check of every solution with a circular contact.

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::theory {

/// u(r) = (4/(pi E*)) int p(s) s K(k) ds/(r + s), k = 2 sqrt(r s)/(r + s).
///
/// @param edges  radii between which p is smooth, ascending from 0; tanh-sinh
///               accepts ends with integrable singularities
template <class Pressure>
double displacement_under(const Pressure& pressure, std::vector<double> edges,
                          double contact_modulus, double radius) {
  if (radius > 0.0 && radius < edges.back())
    edges.push_back(radius);
  std::sort(edges.begin(), edges.end());
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto integrand = [&](double s) {
    // ellint_1 of 1 - tiny: the logarithmic singularity at s = r is at an end
    // of the interval
    const double k = 2.0 * std::sqrt(radius * s) / (radius + s);
    return pressure(s) * s / (radius + s) *
           boost::math::ellint_1(std::min(k, 1.0 - 1e-16));
  };
  double sum = 0.0;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i] > edges[i - 1])
      sum += quadrature.integrate(integrand, edges[i - 1], edges[i], 1e-9);
  return 4.0 / (std::numbers::pi * contact_modulus) * sum;
}

/// int p 2 pi s ds.
template <class Pressure>
double load_of(const Pressure& pressure, const std::vector<double>& edges) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  double sum = 0.0;
  for (std::size_t i = 1; i < edges.size(); ++i)
    sum += quadrature.integrate([&](double s) { return pressure(s) * s; },
                                edges[i - 1], edges[i], 1e-11);
  return 2.0 * std::numbers::pi * sum;
}

} // namespace asperity::theory
