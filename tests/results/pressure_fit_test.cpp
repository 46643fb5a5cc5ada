// Tests of results/observables/pressure_fit.hpp: G is recovered from samples of
// (20), weak pressures at open nodes do not change it, and units do not matter.
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <boost/math/tools/roots.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

namespace asperity::results::pressure_fit_test {

PressureFit fit_by_moment(std::span<const double> pressure,
                          std::span<const double> weights = {}) {
  return pressure_fits(pressure, weights).by_moment;
}

using Fit = PressureFit (*)(std::span<const double> pressure,
                            std::span<const double> weights);
constexpr std::array<Fit, 2> both_fits{
    [](std::span<const double> pressure, std::span<const double> weights) {
      return fit_pressure_distribution(pressure, weights);
    },
    [](std::span<const double> pressure, std::span<const double> weights) {
      return fit_by_moment(pressure, weights);
    }};

constexpr double load = 1e7; // p [Pa]

/// Fraction of the surface with a pressure above `stress`, from (20): that of a
/// Gaussian and its image.
double share_above(double stress, double variance) {
  const double width = 2.0 * std::sqrt(variance);
  return 0.5 * (std::erfc((stress - load) / width) -
                std::erfc((stress + load) / width));
}

/// A map with n nodes in all whose pressures are quantiles of (20) rather than
/// random draws, each representing an equal fraction. The open ones are exactly
/// 0.
std::vector<double> samples(double variance, int n) {
  const double area = share_above(0.0, variance);
  const auto in_contact = static_cast<int>(std::lround(area * n));
  std::vector<double> pressure(static_cast<std::size_t>(n), 0.0);
  for (int i = 0; i < in_contact; ++i) {
    const double share = area * (i + 0.5) / in_contact;
    const auto [low, high] = boost::math::tools::bisect(
        [&](double stress) { return share_above(stress, variance) - share; },
        0.0, load + 20.0 * std::sqrt(variance),
        boost::math::tools::eps_tolerance<double>(40));
    pressure[static_cast<std::size_t>(i)] = 0.5 * (low + high);
  }
  return pressure;
}

// sqrt(G)/p from light contact (A = 3 %) to full contact (1 - A = 5e-7).
const std::vector<double> roots{20.0, 5.0, 1.0, 0.4, 0.14};

// Verifies that G and the area of (21) are recovered. Tolerance: a bin of the
// 48 or more holds some n A/20 nodes, known to half a node at both its edges,
// and as many bins err to either side: 1/(n A/20)/sqrt(20) = 1.5e-4 at n A =
// 3e4.
TEST(PressureFit, RecoversTheVarianceOfItsSamples) {
  for (const double root : roots) {
    const double variance = root * root * load * load;
    const double area = share_above(0.0, variance);
    const auto pressure = samples(variance, static_cast<int>(3e4 / area));

    const PressureFit fit = fit_pressure_distribution(pressure);

    EXPECT_TRUE(fit.reason.empty());
    EXPECT_NEAR(fit.variance / variance, 1.0, 1.5e-4) << root;
    EXPECT_NEAR(fit.area_fraction / area, 1.0, 1.5e-4) << root;
  }
}

// The same by the second moment. Tolerance: quantiles at the middle of their
// fraction are a midpoint rule with a logarithmic end, some 10/n of the second
// moment and of the first, hence of sqrt(G): 1e-3 at n A = 3e4.
TEST(PressureFitByMoment, RecoversTheVarianceOfItsSamples) {
  for (const double root : roots) {
    const double variance = root * root * load * load;
    const double area = share_above(0.0, variance);
    const auto pressure = samples(variance, static_cast<int>(3e4 / area));

    const PressureFit fit = fit_by_moment(pressure);

    EXPECT_NEAR(fit.variance / variance, 1.0, 1e-3) << root;
    EXPECT_NEAR(fit.area_fraction / area, 1.0, 1e-3) << root;
  }
}

// The recovered G has the second moment of the positive part of the map, by the
// closed moments of theory/, for any map with a positive mean, with and without
// tension. Tolerance: roundoff of 64 terms and of a root known to 2^-52, 1e-13.
RC_GTEST_PROP(PressureFitByMoment, HasTheMomentsOfTheMap, ()) {
  const int least = *rc::gen::element(-300, 0, 1);
  std::vector<double> pressure(64);
  double mean_square = 0.0;
  for (double& one : pressure) {
    one =
        1e4 * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, 1000));
    mean_square += std::pow(std::max(0.0, one), 2) / 64.0;
  }
  RC_PRE(weighted_mean(pressure) > 0.0);

  const PressureFit fit = fit_by_moment(pressure);

  const theory::PressureMoments moments =
      theory::pressure_moments(fit.nominal_pressure, fit.variance);
  RC_ASSERT(std::abs(fit.nominal_pressure / weighted_mean(pressure) - 1.0) <
            1e-13);
  RC_ASSERT(std::abs(moments.mean_square_pressure / mean_square - 1.0) < 1e-13);
  RC_ASSERT(std::abs(moments.area_fraction - fit.area_fraction) < 1e-13);
}

// Open nodes with weak pressures, as atoms have them, do not change the fit,
// although counting regards the entire surface as contact. The weak ones are a
// tail from 0.15 sqrt(G) down to zero with a density like 1/sigma, of a mean of
// some 0.4 % of p. Tolerance: the mean p, which the fit takes from the map,
// changes by that much, and the area is proportional to it at light load.
TEST(PressureFit, IgnoresWeakPressuresOfOpenNodes) {
  const double variance = 25.0 * load * load;
  std::vector<double> pressure = samples(variance, 200'000);
  const double hard_area = fit_pressure_distribution(pressure).area_fraction;
  double weak = 0.15 * std::sqrt(variance);
  double weak_mean = 0.0;
  for (double& one : pressure)
    if (one == 0.0) {
      one = weak;
      weak_mean += weak / 200'000.0;
      weak *= 0.99;
    }

  const PressureFit fit = fit_pressure_distribution(pressure);

  EXPECT_GT(counted_area_fraction(ContactNodes::under(pressure)), 0.9);
  EXPECT_LT(weak_mean, 0.005 * load);
  EXPECT_NEAR(fit.variance / variance, 1.0, 2.0 * weak_mean / load + 1.5e-4);
  EXPECT_NEAR(fit.area_fraction / hard_area, 1.0,
              2.0 * weak_mean / load + 1.5e-4);
}

// The unit does not matter: all pressures times a power of two give G times its
// square and the same area, bit for bit; a pressure in other units too, to the
// half of a double's digits that a minimum has.
TEST(PressureFit, IsIndependentOfUnits) {
  const std::vector<double> pressure = samples(load * load, 20'000);
  const PressureFit fit = fit_pressure_distribution(pressure);
  for (const double unit : {0x1p-60, 0x1p40, 1e-9}) {
    std::vector<double> scaled = pressure;
    for (double& one : scaled)
      one *= unit;

    const PressureFit again = fit_pressure_distribution(scaled);

    EXPECT_NEAR(again.variance / (unit * unit) / fit.variance, 1.0,
                unit == 1e-9 ? 1e-7 : 0.0);
    EXPECT_NEAR(again.area_fraction / fit.area_fraction, 1.0,
                unit == 1e-9 ? 1e-7 : 0.0);
  }
}

// A node of weight 2 counts as two of weight 1. Tolerance: roundoff of the
// sums.
TEST(PressureFit, WeighsNodes) {
  std::vector<double> pressure = samples(load * load, 4000);
  std::vector<double> weights(pressure.size(), 1.0);
  std::vector<double> twice = pressure;
  double mean_weight = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (i % 3 == 0) {
      weights[i] = 2.0;
      twice.push_back(pressure[i]);
    }
    mean_weight += weights[i] / static_cast<double>(weights.size());
  }
  for (double& weight : weights)
    weight /= mean_weight;

  for (const Fit fit_of : both_fits) {
    const PressureFit weighted = fit_of(pressure, weights);
    const PressureFit repeated = fit_of(twice, {});
    EXPECT_NEAR(weighted.variance / repeated.variance, 1.0, 1e-7);
    EXPECT_NEAR(weighted.nominal_pressure / repeated.nominal_pressure, 1.0,
                1e-13);
  }
}

TEST(PressureFit, HasTheLimitsOfNoAndFullContact) {
  const std::vector<double> open(100, 0.0);
  const std::vector<double> uniform(100, 3e6);
  std::vector<double> touching(100, 0.0);
  touching[7] = 1e6;
  std::vector<double> pulled(100, -1e6);
  pulled[7] = 2e6;
  for (const Fit fit_of : both_fits) {
    EXPECT_EQ(fit_of(open, {}).area_fraction, 0.0);
    EXPECT_TRUE(std::isnan(fit_of(open, {}).variance));
    EXPECT_EQ(fit_of(open, {}).reason, "nothing is in contact");
    EXPECT_EQ(fit_of(uniform, {}).area_fraction, 1.0);
    EXPECT_NEAR(fit_of(uniform, {}).variance, 0.0, 1e-24);
    EXPECT_TRUE(std::isnan(fit_of(pulled, {}).area_fraction));
    EXPECT_EQ(fit_of(pulled, {}).reason, "the mean pressure is not positive");
  }
  EXPECT_EQ(fit_pressure_distribution(touching).reason,
            "too few nodes are in contact for a histogram");
  EXPECT_GT(fit_by_moment(touching).area_fraction, 0.0);
  EXPECT_THROW(fit_pressure_distribution({}), std::domain_error);
  EXPECT_THROW(fit_pressure_distribution(std::vector{1.0, 1.0 / 0.0}),
               std::domain_error);
  EXPECT_THROW(fit_by_moment(open, std::vector{1.0}), std::domain_error);
}

// From full contact to a single node in 10^8 every map has a fit by moment with
// the moments of the map. Near both ends the root lies at the bound of its
// bracket to within roundoff: pressures 1 -+ d have the excess d^2, and n nodes
// of which one is in contact have n - 1 (by weights, so that the map stays
// small). Tolerance: roundoff of the moments, 1e-13.
TEST(PressureFitByMoment, HasARootAtBothEndsOfContact) {
  for (int i = 0; i <= 2000; ++i) {
    const double spread = std::sqrt(0.005 + 1e-5 * i);

    const PressureFit fit =
        fit_by_moment(std::vector{1.0 - spread, 1.0 + spread});

    ASSERT_NEAR(
        theory::pressure_moments(1.0, fit.variance).mean_square_pressure,
        1.0 + spread * spread, 1e-13)
        << spread * spread;
  }
  for (double n = 1e3; n <= 1e8; n *= 1.1) {
    const std::vector<double> weights{2.0 / n, 2.0 - 2.0 / n};

    const PressureFit fit = fit_by_moment(std::vector{0.5 * n, 0.0}, weights);

    ASSERT_NEAR(
        theory::pressure_moments(0.5, fit.variance).mean_square_pressure /
            (0.25 * n),
        1.0, 1e-13)
        << n;
  }
}

// Verifies that pressures at the limits of a double, and a mean that is lost in
// roundoff beside the pressures, have a result and no exception.
TEST(PressureFit, WorksAtTheLimitsOfADouble) {
  const std::vector<double> reduced = samples(load * load, 4000);
  std::vector<double> pulled(100, 1.0);
  std::fill(pulled.begin(), pulled.begin() + 50, -1.0);
  pulled.back() += 1e-15;
  for (const Fit fit_of : both_fits) {
    const double area = fit_of(reduced, {}).area_fraction;
    for (const double unit : {0x1p-600, 0x1p600}) {
      std::vector<double> pressure = reduced;
      for (double& one : pressure)
        one *= unit;
      EXPECT_EQ(fit_of(pressure, {}).area_fraction, area) << unit;
    }
    EXPECT_TRUE(std::isnan(fit_of(pulled, {}).area_fraction));
    EXPECT_EQ(fit_of(pulled, {}).reason,
              "the mean pressure is dominated by roundoff");
  }
}

// For one Hertzian contact, whose density of pressures increases towards its
// end, in contrast to a Gaussian, the numbers still have the right magnitude:
// both areas are within a factor of two of the exact one.
TEST(PressureFit, OfASphereIsWithinAFactorOfTwo) {
  const int n = 200;
  const double radius = 0.3; // of the contact, in sides
  std::vector<double> pressure;
  for (int iy = 0; iy < n; ++iy)
    for (int ix = 0; ix < n; ++ix) {
      const double place = std::hypot(ix - 100, iy - 100) / (radius * n);
      pressure.push_back(1e9 * std::sqrt(std::max(0.0, 1.0 - place * place)));
    }
  const double area = std::numbers::pi * radius * radius;

  for (const Fit fit_of : both_fits) {
    const double found = fit_of(pressure, {}).area_fraction;
    EXPECT_GT(found, 0.5 * area);
    EXPECT_LT(found, 2.0 * area);
  }
}

} // namespace asperity::results::pressure_fit_test
