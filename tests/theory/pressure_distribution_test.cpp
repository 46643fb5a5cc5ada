// Tests of theory/persson/pressure_distribution.hpp: closed forms against
// integrals.
#include "tests/message_of.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::theory::pressure_distribution_test {

using std::numbers::pi;
constexpr double variance = 4.0e16; // G [Pa^2], sqrt(G) = 200 MPa

// int_0^inf sigma^power P dsigma, on both sides of the load, as far as the
// Gaussian reaches: 26 sqrt(G) away it is e^{-169}.
double moment_by_quadrature(double nominal_pressure, int power) {
  const double reach = 26.0 * std::sqrt(variance);
  const auto integrand = [&](double stress) {
    return std::pow(stress, power) *
           pressure_density(stress, nominal_pressure, variance);
  };
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  return Quadrature::integrate(integrand,
                               std::max(0.0, nominal_pressure - reach),
                               nominal_pressure, 12, 1e-14) +
         Quadrature::integrate(integrand, nominal_pressure,
                               nominal_pressure + reach, 12, 1e-14);
}

// The three moments of (1) are the area (4), the load, and the closed second
// moment, at any load. Tolerance: the quadrature's.
RC_GTEST_PROP(PressureDensity, HasTheMomentsItShould, ()) {
  const int decade = *rc::gen::inRange(-300, 150);
  const double pressure = std::sqrt(variance) * std::pow(10.0, decade / 100.0);

  const PressureMoments moments = pressure_moments(pressure, variance);

  const auto agree = [&](double closed, int power) {
    RC_ASSERT(std::abs(closed / moment_by_quadrature(pressure, power) - 1.0) <
              1e-12);
  };
  agree(moments.area_fraction, 0);
  agree(moments.nominal_pressure, 1);
  agree(moments.mean_square_pressure, 2);
}

// The fraction between two pressures is the integral of the density, and the
// total is (4). Tolerance: roundoff of four erf, absolute.
TEST(PressureShare, IsTheIntegralOfTheDensity) {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  for (const double load : {1e6, 1e8, 1e9})
    for (const double low : {0.0, 5e7, 9e8}) {
      const double high = low + 1.5e8;
      const double integral = Quadrature::integrate(
          [&](double stress) {
            return pressure_density(stress, load, variance);
          },
          low, high);

      EXPECT_NEAR(pressure_share(low, high, load, variance), integral, 4e-16);
      EXPECT_NEAR(pressure_share(0.0, 1e10, load, variance),
                  area_fraction(load, variance), 4e-16);
    }
}

// (1) solves the diffusion equation dP/dG = d^2P/dsigma^2 from which it is
// derived, with P = 0 at sigma = 0. Tolerance: central differences of step d
// have the error d^2/12 of a fourth derivative of order one, roundoff eps/d^2:
// 1e-7 at 1e-4.
TEST(PressureDensity, DiffusesWithMagnification) {
  const double load = 0.7, step = 1e-4;
  const auto density = [&](double stress, double spread) {
    return pressure_density(stress, load, spread);
  };
  for (const double stress : {0.2, 1.0, 2.5}) {
    const double in_variance =
        (density(stress, 1.0 + step) - density(stress, 1.0 - step)) /
        (2.0 * step);
    const double in_stress =
        (density(stress + step, 1.0) - 2.0 * density(stress, 1.0) +
         density(stress - step, 1.0)) /
        (step * step);

    EXPECT_NEAR(in_variance, in_stress, 1e-7);
  }
  EXPECT_EQ(pressure_density(0.0, load, 1.0), 0.0);
}

// At small load the density is p sigma/(2 sqrt(pi) G^{3/2}) * e^{-sigma^2/4G}:
// its digits are not lost in the difference of two nearly equal numbers.
// Tolerance: the next term is (p/sqrt G)^2 = 1e-18.
TEST(PressureDensity, LosesNoDigitsAtSmallLoad) {
  const double load = 1e-9 * std::sqrt(variance);
  const double stress = 0.8 * std::sqrt(variance);

  const double expected = load * stress / (2.0 * std::sqrt(pi)) /
                          std::pow(variance, 1.5) * std::exp(-0.16);
  EXPECT_NEAR(pressure_density(stress, load, variance) / expected, 1.0, 1e-14);
}

// (2) with (4) is erf(sqrt2 p/(E* h')), the other form of it.
TEST(StressVariance, GivesTheSlopeFormOfTheArea) {
  const double modulus = 2e9, slope = 0.1, load = 3e7;

  const double area = area_fraction(load, stress_variance(modulus, slope));

  EXPECT_NEAR(area, std::erf(std::numbers::sqrt2 * load / (modulus * slope)),
              1e-15);
}

TEST(PressureDistributionInput, RefusesBadArgumentsByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto names = [](const std::string& message, const std::string& name) {
    return message.starts_with(name + " = ");
  };
  EXPECT_TRUE(names(tests::message_of<std::domain_error>(
                        [&] { pressure_density(-1.0, 1.0, 1.0); }),
                    "contact_pressure"));
  EXPECT_TRUE(names(tests::message_of<std::domain_error>(
                        [&] { pressure_share(2.0, 1.0, 1.0, 1.0); }),
                    "high"));
  EXPECT_TRUE(names(
      tests::message_of<std::domain_error>([&] { area_fraction(nan, 1.0); }),
      "nominal_pressure"));
  EXPECT_TRUE(names(
      tests::message_of<std::domain_error>([&] { pressure_moments(1.0, 0.0); }),
      "variance"));
  EXPECT_TRUE(names(
      tests::message_of<std::domain_error>([&] { stress_variance(1.0, -0.1); }),
      "rms_slope"));
}

} // namespace asperity::theory::pressure_distribution_test
