// Tests of theory/persson/absorbed_flux.hpp against absorbing boundaries with a
// closed form, and of the order of convergence.
#include "theory/persson/absorbed_flux.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::absorbed_flux_test {

// Times that are dense towards 0, as those of a spectrum are, up to tau = 1.
MovingBoundary boundary_of(int n_steps, auto distance, auto rate) {
  MovingBoundary boundary;
  for (int i = 0; i <= n_steps; ++i) {
    const double t = std::expm1(3.0 * i / n_steps) / std::expm1(3.0);
    boundary.time.push_back(t);
    boundary.distance.push_back(distance(t));
    boundary.rate.push_back(rate(t));
  }
  return boundary;
}

double lost_at_end(const MovingBoundary& boundary) {
  return 1.0 - absorbed_flux(boundary).survival.back();
}

// A boundary at rest leaves P = erf(b/(2 sqrt tau)), by the method of images; f
// is then exact at every node. Tolerance: the trapezoidal rule of its integral,
// of second order: 4 per halving.
TEST(AbsorbedFlux, OfABoundaryAtRestIsTheMirrorImage) {
  const double distance = 0.8;
  const auto error = [&](int n) {
    const MovingBoundary boundary = boundary_of(
        n, [&](double) { return distance; }, [](double) { return 0.0; });
    return lost_at_end(boundary) - std::erfc(0.5 * distance);
  };
  const Absorption coarse = absorbed_flux(boundary_of(
      20, [&](double) { return distance; }, [](double) { return 0.0; }));

  EXPECT_NEAR(coarse.flux.back(),
              distance / std::sqrt(4.0 * std::numbers::pi) *
                  std::exp(-0.25 * distance * distance),
              1e-15);
  EXPECT_LT(std::abs(error(200)), 1e-5);
  EXPECT_NEAR(error(100) / error(200), 4.0, 0.1);
}

// A boundary with constant velocity, b + v tau, has the inverse Gaussian
// distribution
//
//   1 - P = [erfc((b + v tau)/2 sqrt tau)
//            + e^{-v b} erfc((b - v tau)/2 sqrt tau)]/2.
//
// The kernel vanishes again and f is exact.
TEST(AbsorbedFlux, OfASteadyBoundaryIsTheInverseGaussian) {
  for (const double speed : {-0.5, 0.7, 3.0}) {
    const double distance = 1.0;
    const MovingBoundary boundary = boundary_of(
        400, [&](double t) { return distance + speed * t; },
        [&](double) { return speed; });
    const double expected = 0.5 * (std::erfc(0.5 * (distance + speed)) +
                                   std::exp(-speed * distance) *
                                       std::erfc(0.5 * (distance - speed)));

    EXPECT_NEAR(lost_at_end(boundary) / expected, 1.0, 2e-5) << speed;
  }
}

// A curved boundary (Daniels): where a unit source at 0 and two image sinks at
// d and 2d cancel,
//
//   e^{-b^2/4t} = k_1 e^{-(b - d)^2/4t} + k_2 e^{-(b - 2d)^2/4t},
//
// a quadratic equation in e^{b d/2t}, the result is the sum of the images below
// b. Here the kernel does not vanish. Tolerance: the order, above 1.4 as
// documented.
TEST(AbsorbedFlux, OfDanielsBoundaryIsASumOfImages) {
  const double d = 1.0, k1 = 0.5, k2 = 0.2;
  const auto boundary_at = [&](double t) {
    if (t == 0.0)
      return 0.5 * d;
    const double p = k1 * std::exp(-d * d / (4.0 * t));
    const double q = k2 * std::exp(-d * d / t);
    const double z = 2.0 / (p + std::sqrt(p * p + 4.0 * q));
    return 2.0 * t / d * std::log(z);
  };
  const auto rate_at = [&](double t) {
    const double step = 1e-4 * (t + 1e-3);
    const double low = t > step ? t - step : 0.0;
    return (boundary_at(t + step) - boundary_at(low)) / (t + step - low);
  };
  const double b = boundary_at(1.0);
  const auto below = [](double x) { return 0.5 * std::erfc(-0.5 * x); };
  const double kept = below(b) - k1 * below(b - d) - k2 * below(b - 2.0 * d);
  const auto error = [&](int n) {
    return 1.0 - lost_at_end(boundary_of(n, boundary_at, rate_at)) - kept;
  };

  const double order = std::log2(error(100) / error(200));

  EXPECT_LT(std::abs(error(200)), 1e-4);
  EXPECT_GT(order, 1.4);
}

TEST(AbsorbedFlux, RefusesInvalidBoundaries) {
  EXPECT_THROW(absorbed_flux({{0.0}, {1.0}, {0.0}}), std::domain_error);
  EXPECT_THROW(absorbed_flux({{0.0, 1.0}, {1.0}, {0.0, 0.0}}),
               std::domain_error);
  EXPECT_THROW(absorbed_flux({{0.1, 1.0}, {1.0, 1.0}, {0.0, 0.0}}),
               std::domain_error);
  EXPECT_THROW(absorbed_flux({{0.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}}),
               std::domain_error);
  EXPECT_THROW(absorbed_flux({{0.0, 1.0}, {1.0, 0.0}, {0.0, 0.0}}),
               std::domain_error);
}

} // namespace asperity::theory::absorbed_flux_test
