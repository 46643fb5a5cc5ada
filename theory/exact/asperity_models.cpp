#include "theory/exact/asperity_models.hpp"

#include "base/require.hpp"
#include "theory/exact/elliptic_hertz.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity::theory {

using std::numbers::pi;

namespace {

void check(const ProfileMoments& moments, double contact_modulus,
           double mean_gap) {
  require_positive("contact_modulus", contact_modulus, "Pa");
  if (!std::isfinite(mean_gap))
    refuse_argument("mean_gap", mean_gap, "finite [m]");
  require_positive("height moment", moments.height, "m^2");
  require_positive("slope moment", moments.slope, "1");
  require_positive("curvature moment", moments.curvature, "1/m^2");
  const double nayak =
      moments.height * moments.curvature / (moments.slope * moments.slope);
  if (!(nayak > 1.5))
    refuse_argument("nayak", nayak, "above 3/2, that of a single wavelength");
}

// int_0^inf x^power e^{-(x + distance)^2/2} dx/sqrt(2 pi), integrated over
// root = sqrt(x - start), in which x^power is smooth, until the integrand has
// fallen to e^-45 of its maximum.
double gaussian_excess(double power, double distance) {
  const double nearest = std::max(0.0, distance);
  const double farthest = std::sqrt(nearest * nearest + 90.0);
  const double start = std::max(0.0, -distance - farthest);
  const double last = std::sqrt(farthest - distance - start);
  const auto integrand = [=](double root) {
    const double x = start + root * root;
    return 2.0 * root * std::pow(x, power) *
           std::exp(-0.5 * (x + distance - nearest) * (x + distance + nearest));
  };
  double sum = 0.0;
  const int n_panels = 4 + static_cast<int>(last);
  for (int i = 0; i < n_panels; ++i)
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        integrand, last * i / n_panels, last * (i + 1) / n_panels);
  return sum * std::exp(-0.5 * nearest * nearest) / std::sqrt(2.0 * pi);
}

// A node of the quadrature over rho/t = 1 - v^2, v = 0..1.
struct ShapeNode {
  double contrast = 0.0;    // rho/t
  double weight = 0.0;      // d(rho/t)
  double load_factor = 0.0; // see EllipticFactors
  double area_factor = 0.0;
};

constexpr std::size_t n_shapes = 40;
using Shapes = std::array<ShapeNode, n_shapes>;

// In v, both 1/sqrt(1 - rho/t) in the factors and 1 - (rho/t)^2 in the summit
// density are smooth.
const Shapes& shapes() {
  static const Shapes nodes = [] {
    using Gauss = boost::math::quadrature::gauss<double, n_shapes>;
    Shapes made;
    for (std::size_t i = 0; i < n_shapes; ++i) {
      const double sign = i % 2 == 0 ? 1.0 : -1.0;
      const double v = 0.5 * (1.0 + sign * Gauss::abscissa()[i / 2]);
      const double contrast = 1.0 - v * v;
      const EllipticFactors factors = elliptic_factors(contrast);
      made[i] = {contrast, Gauss::weights()[i / 2] * v, factors.load_factor,
                 factors.area_factor};
    }
    return made;
  }();
  return nodes;
}

// Averages over rho at fixed t, in units of y = t/sqrt(2 m_4/3):
// int (1 - g^2) 2 y^4 g e^{-y^2 g^2} factor dg, g = rho/t.
AsperityLoad shape_means(double y) {
  AsperityLoad mean;
  for (const ShapeNode& node : shapes()) {
    const double g = node.contrast;
    const double share = node.weight * (1.0 - g * g) * 2.0 * g *
                         std::pow(y, 4) * std::exp(-y * y * g * g);
    mean.nominal_pressure += share * node.load_factor;
    mean.area_fraction += share * node.area_factor;
  }
  return mean;
}

} // namespace

AsperityLoad bush_gibson_thomas(const ProfileMoments& moments,
                                double contact_modulus, double mean_gap) {
  check(moments, contact_modulus, mean_gap);
  const double m0 = moments.height, m2 = moments.slope;
  const double unit = std::sqrt(2.0 / 3.0 * moments.curvature); // unit of t
  const double correlation = m2 / (std::sqrt(m0) * unit);       // of z and t
  const double deviation =
      std::sqrt(m0 * (1.0 - correlation) * (1.0 + correlation)); // of z given t
  const double height = m2 / unit; // mean of z at y = 1

  // Density of summits times load at y, without the common factors below.
  const auto at = [&](double y) {
    const double distance = (mean_gap - height * y) / deviation;
    AsperityLoad load = shape_means(y);
    const double density = std::exp(-0.5 * y * y) / std::sqrt(2.0 * pi);
    load.nominal_pressure *=
        density * gaussian_excess(1.5, distance) / std::sqrt(y);
    load.area_fraction *= density * gaussian_excess(1.0, distance) / y;
    return load;
  };
  const double likely = std::max(0.0, correlation * mean_gap / std::sqrt(m0));
  const double reach = 9.0;
  const double from = std::max(0.0, likely - reach), to = likely + reach;
  const int n_panels = 16;
  using Gauss = boost::math::quadrature::gauss<double, 20>;
  AsperityLoad sum;
  for (int i = 0; i < n_panels; ++i) {
    const double low = from + (to - from) * i / n_panels;
    const double half = 0.5 * (to - from) / n_panels;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k)
      for (const double sign : {-1.0, 1.0}) {
        const AsperityLoad load =
            at(low + half * (1.0 + sign * Gauss::abscissa()[k]));
        sum.nominal_pressure +=
            half * Gauss::weights()[k] * load.nominal_pressure;
        sum.area_fraction += half * Gauss::weights()[k] * load.area_fraction;
      }
  }
  const double density = unit * unit / (2.0 * pi * m2);
  return {4.0 / 3.0 * contact_modulus * density * deviation *
              std::sqrt(deviation / unit) * sum.nominal_pressure,
          pi * density * deviation / unit * sum.area_fraction};
}

} // namespace asperity::theory
