// Tests of theory/exact/asperity_models.hpp: the statistics of summits by their
// own integrals, printed numbers, and the limits that the paper states.
#include "tests/theory/spectra.hpp"
#include "theory/exact/asperity_models.hpp"
#include "theory/persson/persson.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::theory::asperity_models_test {

using std::numbers::pi;

ProfileMoments moments_of_the_paper() {
  return surface_of_the_paper().spectrum().profile_moments();
}

// Density, mean height and height variance of summits are integrals of Nayak's
// distribution: with y = t/sqrt(2 m_4/3) and the half difference of the
// curvatures integrated, summits at y go as (y^2 - 1 + e^{-y^2}) e^{-y^2/2},
// and z given y is normal about m_2 y/sqrt(2 m_4/3). Tolerance: quadrature; the
// variance's 0.8968 is printed to four digits.
TEST(SummitStatistics, AreIntegralsOfNayaksDistribution) {
  const ProfileMoments moments = moments_of_the_paper();
  const SummitStatistics summits = summit_statistics(moments);
  const auto mean = [&](int power) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double y) {
          return std::pow(y, power) * (y * y + std::expm1(-y * y)) *
                 std::exp(-0.5 * y * y) / std::sqrt(2.0 * pi);
        },
        0.0, 40.0, 10, 1e-13);
  };
  const double unit = std::sqrt(2.0 / 3.0 * moments.curvature);
  const double slope = moments.slope / unit; // <z> per y
  const double count = mean(0);
  const double height = slope * mean(1) / count;
  const double variance = moments.height - slope * slope +
                          slope * slope * mean(2) / count - height * height;

  EXPECT_NEAR(summits.density /
                  (unit * unit * count / (2.0 * pi * moments.slope)),
              1.0, 1e-10);
  EXPECT_NEAR(summits.mean_height / height, 1.0, 1e-10);
  EXPECT_NEAR(std::pow(summits.height_deviation, 2) / variance, 1.0, 5e-5);
  EXPECT_NEAR(summits.nayak, 3.8694, 1e-3);
}

// The radius is one over the mean curvature of summits, (8/3) sqrt(m_4/pi),
// another integral of the distribution.
TEST(SummitStatistics, RadiusIsOneOverTheMeanCurvature) {
  const ProfileMoments moments = moments_of_the_paper();
  const auto mean = [&](int power) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double y) {
          return std::pow(y, power) * (y * y + std::expm1(-y * y)) *
                 std::exp(-0.5 * y * y);
        },
        0.0, 40.0, 10, 1e-13);
  };
  const double curvature =
      std::sqrt(2.0 / 3.0 * moments.curvature) * mean(1) / mean(0);

  EXPECT_NEAR(summit_statistics(moments).radius * curvature, 1.0, 1e-10);
}

// p/E* on the paper's surface, computed by another program, together with
// Persson's (14). Tolerance: half a unit of the fourth digit.
TEST(AsperityModels, HaveTheirPrintedNumbers) {
  const ProfileMoments moments = moments_of_the_paper();
  const PerssonContact persson(surface_of_the_paper().spectrum(), 1.0, 0.42);

  struct Row {
    double gap, gw, bgt, persson;
  };

  for (const Row& row : {Row{1.0, 7.585e-3, 7.700e-3, 1.2633e-2},
                         Row{2.0, 1.118e-3, 1.086e-3, 1.585e-3},
                         Row{3.0, 6.706e-5, 6.589e-5, 1.781e-4},
                         Row{4.0, 1.416e-6, 1.583e-6, 1.932e-5}}) {
    const double gap = row.gap * 1e-9;
    EXPECT_NEAR(greenwood_williamson(moments, 1.0, gap).nominal_pressure /
                    row.gw,
                1.0, 5e-4);
    EXPECT_NEAR(bush_gibson_thomas(moments, 1.0, gap).nominal_pressure /
                    row.bgt,
                1.0, 5e-4);
    EXPECT_NEAR(persson.nominal_pressure(gap) / row.persson, 1.0, 5e-4);
  }
}

// The exponents stated in the paper, a = 5/2 and 1, are the local slope of ln(p
// e^{x^2/2}) against ln x, x = d/s and u/sqrt(m_0). Tolerance: the next term of
// both is of relative order 1/x^2: 35/4 of it for the first; for the second 2
// from erfc and twice the distance to the asymptote of the next test.
TEST(AsperityModels, DecreaseFarOutWithTheirExponents) {
  const ProfileMoments moments = moments_of_the_paper();
  const SummitStatistics summits = summit_statistics(moments);
  const auto exponent = [](double x, auto pressure) {
    const double step = 0.01 * x;
    const auto log_rest = [&](double at) {
      return std::log(pressure(at)) + 0.5 * at * at;
    };
    return -x * (log_rest(x + step) - log_rest(x - step)) / (2.0 * step);
  };
  for (const double x : {10.0, 20.0, 30.0}) {
    const double gw = exponent(x, [&](double at) {
      return greenwood_williamson(moments, 1.0,
                                  summits.mean_height +
                                      at * summits.height_deviation)
          .nominal_pressure;
    });
    const double bgt = exponent(x, [&](double at) {
      return bush_gibson_thomas(moments, 1.0, at * std::sqrt(moments.height))
          .nominal_pressure;
    });

    EXPECT_NEAR(gw, 2.5, 9.0 / x / x) << x;
    EXPECT_NEAR(bgt, 1.0, 4.0 / x / x) << x;
  }
}

// The full model tends to its asymptote as 1 - O(m_0/u^2), in pressure and in
// area; the limit is extrapolated from 20 and 30 sqrt(m_0). Tolerance: the
// remaining order x^-4, 10/20^4.
TEST(BushGibsonThomas, TendsToItsAsymptote) {
  const ProfileMoments moments = moments_of_the_paper();
  const auto ratio = [&](double x, auto member) {
    const double area = 0.25 * std::erfc(x / std::sqrt(2.0));
    const AsperityLoad asymptote{5.0 * std::sqrt(moments.slope / pi) * area,
                                 area};
    return (bush_gibson_thomas(moments, 5.0, x * std::sqrt(moments.height)).*
            member) /
           (asymptote.*member);
  };
  for (const auto member :
       {&AsperityLoad::nominal_pressure, &AsperityLoad::area_fraction}) {
    const double at_20 = ratio(20.0, member), at_30 = ratio(30.0, member);

    EXPECT_NEAR(at_20, 1.0, 2.0 / 400.0);
    EXPECT_NEAR((900.0 * at_30 - 400.0 * at_20) / 500.0, 1.0, 6e-5);
  }
}

// Every summit above the separation contributes area at the same rate, dA/du =
// -pi eta R times the fraction of summits above u, by a central difference.
// Tolerance: its second order, step 1e-4.
TEST(GreenwoodWilliamson, AreaDecreasesWithTheSummitsInReach) {
  const ProfileMoments moments = moments_of_the_paper();
  const SummitStatistics summits = summit_statistics(moments);
  for (const double at : {-3.0, 0.5, 4.0}) {
    const double s = summits.height_deviation, step = 1e-4 * s;
    const auto area = [&](double gap) {
      return greenwood_williamson(moments, 1.0, summits.mean_height + gap)
          .area_fraction;
    };
    const double slope =
        (area(at * s - step) - area(at * s + step)) / (2.0 * step);
    const double in_reach = 0.5 * std::erfc(at / std::sqrt(2.0));

    EXPECT_NEAR(slope / (pi * summits.density * summits.radius * in_reach), 1.0,
                1e-6);
  }
}

TEST(AsperityModels, RefuseWhatIsOutsideItsRange) {
  const ProfileMoments moments = moments_of_the_paper();
  EXPECT_THROW(greenwood_williamson(moments, 0.0, 1e-9), std::domain_error);
  EXPECT_THROW(bush_gibson_thomas(moments, 1.0, NAN), std::domain_error);
  try {
    summit_statistics({1.0, 1.0, 1.5});
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("nayak = 1.5"), std::string::npos);
  }
}

} // namespace asperity::theory::asperity_models_test
