// Tests of theory/persson/gap_kernel.hpp, each against an integral that is
// evaluated directly.
#include "theory/persson/gap_kernel.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::theory::gap_kernel_test {

using Quadrature = boost::math::quadrature::tanh_sinh<double>;

double slope_linear(double t) {
  return std::exp(-t * t);
}

double slope_cubic(double t) {
  return 3.0 * std::erf(t) * std::erf(t) * std::exp(-t * t);
}

// int_x^inf f dt/t for f = g(t) e^{-t^2}, truncated where the Gaussian has
// decreased by e^{-44} = 1e-19. Up to 1 over ln t; beyond, t = x + s with
// e^{-x^2} as a factor, so that the digits of x^2 do not enter.
template <class Function>
double tail_integral(Function g, double x) {
  Quadrature quadrature;
  const auto over_logarithm = [&](double s) {
    const double t = std::exp(s);
    return g(t) * std::exp(-t * t);
  };
  const double begin = std::max(x, 1.0);
  const auto shifted = [&](double s) {
    const double t = begin + s;
    return g(t) / t * std::exp(-s * (2.0 * begin + s));
  };
  const double end = std::sqrt(begin * begin + 44.0) - begin;
  const double tail =
      std::exp(-begin * begin) * quadrature.integrate(shifted, 0.0, end);
  return x < 1.0 ? tail + quadrature.integrate(over_logarithm, std::log(x), 0.0)
                 : tail;
}

double linear_factor(double) {
  return 1.0;
}

double cubic_factor(double t) {
  return 3.0 * std::erf(t) * std::erf(t);
}

class GapKernel : public ::testing::TestWithParam<double> {};

// Verifies both parts against their defining integral, over the whole range and
// on both sides of every change of formula. Tolerance: the accuracy that the
// header states.
TEST_P(GapKernel, IsTheIntegralThatDefinesIt) {
  const double x = GetParam();

  const GammaParts kernel = gap_kernel(x);

  const double tolerance = 1e-14;
  EXPECT_NEAR(kernel.linear / tail_integral(linear_factor, x), 1.0, tolerance);
  EXPECT_NEAR(kernel.cubic / tail_integral(cubic_factor, x), 1.0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(Sweep, GapKernel,
                         ::testing::Values(1e-150, 1e-12, 1e-6, 1e-3, 0.1, 0.4,
                                           0.7, 0.7072, 0.9, 1.2, 1.414, 1.4143,
                                           2.0, 2.83, 3.9, 5.65, 5.66, 8.0,
                                           11.31, 11.32, 15.0, 25.0));

// gap_kernel_slope is minus the derivative in ln x: its integral from x to 2x
// is the decrease of the kernel. Tolerance: the two differences round at eps *
// J, J < 40.
TEST(GapKernelSlope, IntegratesToTheDecreaseOfTheKernel) {
  Quadrature quadrature;
  for (const double x : {1e-9, 0.02, 0.5, 0.69, 1.1, 3.0}) {
    const double fall = gap_kernel(x).at(0.42) - gap_kernel(2.0 * x).at(0.42);

    const double integral = quadrature.integrate(
        [](double s) { return gap_kernel_slope(std::exp(s)).at(0.42); },
        std::log(x), std::log(2.0 * x));

    EXPECT_NEAR(fall, integral, 2e-14) << "x = " << x;
  }
}

// The derivative of the slope integrates to the change of the slope over a
// factor of two in x. Tolerance: the quadrature's.
TEST(GapKernelSlopeRate, IntegratesToTheChangeOfTheSlope) {
  for (const double x : {1e-3, 0.1, 0.6, 1.0, 2.5}) {
    const auto integral = [&](auto part) {
      return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double t) { return part(gap_kernel_slope_rate(t)) / t; }, x,
          2.0 * x, 10, 1e-14);
    };
    const GammaParts low = gap_kernel_slope(x);
    const GammaParts high = gap_kernel_slope(2.0 * x);

    EXPECT_NEAR(integral([](GammaParts p) { return p.linear; }),
                high.linear - low.linear, 1e-14);
    EXPECT_NEAR(integral([](GammaParts p) { return p.cubic; }),
                high.cubic - low.cubic, 1e-14);
  }
}

// Verifies the series of the slope. Tolerance: 26 terms of an alternating
// series whose largest term is of order one.
TEST(SmallPressureSeriesTest, SumsToTheSlope) {
  const SmallPressureSeries& series = small_pressure_series();
  for (const double x : {0.0, 0.1, 0.5, SmallPressureSeries::limit}) {
    double linear = 0.0, cubic = 0.0;
    for (std::size_t n = SmallPressureSeries::n_terms; n-- > 0;) {
      linear = linear * x * x + series.slope_linear[n];
      cubic = cubic * x * x + series.slope_cubic[n];
    }

    EXPECT_NEAR(linear, slope_linear(x), 1e-15);
    EXPECT_NEAR(cubic, slope_cubic(x), 1e-15);
  }
}

// K of (16) is 3 int_0^inf erf^2 e^{-x^2} dx/x, which the closed form on
// 0..asinh 1 replaces. The integrand begins as x and ends at e^{-44}.
TEST(CubicEnergyConstant, IsTheIntegralItReplaces) {
  Quadrature quadrature;

  const double integral = quadrature.integrate(
      [](double x) { return x > 0.0 ? slope_cubic(x) / x : 0.0; }, 0.0, 6.7);

  EXPECT_NEAR(cubic_energy_constant(), integral, 1e-14);
}

} // namespace asperity::theory::gap_kernel_test
