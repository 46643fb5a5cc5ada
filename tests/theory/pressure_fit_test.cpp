// Claims about theory/pressure_fit.hpp: the fit of (20) finds the variance a
// histogram was made with, and (21) its area.
#include "theory/pressure_distribution.hpp"
#include "theory/pressure_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::theory {
namespace {

std::vector<PressureBin> histogram(double pressure, double variance,
                                   double noise) {
  std::vector<PressureBin> bins;
  const double width = 0.1 * (std::sqrt(variance) + pressure);
  for (int i = 0; i < 80; ++i) {
    const double sigma = width * (i + 0.5);
    const double ripple = 1.0 + noise * std::cos(0.3 * i);
    bins.push_back(
        {sigma, ripple * pressure_density(sigma, pressure, variance)});
  }
  return bins;
}

// Claim: an exact histogram returns its variance, from light to full contact.
// Tolerance: the minimum of a square is flat over sqrt(eps).
TEST(PressureFit, FindsTheVarianceOfAnExactHistogram) {
  const double variance = 4e16;
  for (const double pressure : {1e5, 1e7, 2e8, 5e9}) {
    const PressureFit fit =
        fit_pressure_distribution(histogram(pressure, variance, 0.0), pressure);

    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.variance / variance, 1.0, 1e-7);
    EXPECT_EQ(fit.area_fraction, area_fraction(pressure, fit.variance));
  }
}

// Claim: it is a least squares fit: a ripple shifts it, and no variance 1 %
// either way fits better.
TEST(PressureFit, IsTheLeastSquaresOfARoughHistogram) {
  const double pressure = 2e8;
  const std::vector<PressureBin> bins = histogram(pressure, 4e16, 0.3);
  const auto misfit = [&](double variance) {
    double sum = 0.0;
    for (const PressureBin& bin : bins)
      sum += std::pow(bin.density - pressure_density(bin.contact_pressure,
                                                     pressure, variance),
                      2);
    return sum;
  };

  const double found = fit_pressure_distribution(bins, pressure).variance;

  EXPECT_GT(std::abs(found / 4e16 - 1.0), 1e-3);
  EXPECT_LT(misfit(found), misfit(1.01 * found));
  EXPECT_LT(misfit(found), misfit(0.99 * found));
}

// Claim: a histogram of nothing has no variance of its own, and it is said.
TEST(PressureFit, SaysWhenThereIsNothingToFit) {
  const std::vector<PressureBin> empty{{1e8, 0.0}, {2e8, 0.0}};
  EXPECT_FALSE(fit_pressure_distribution(empty, 1e8).converged);
  EXPECT_THROW(fit_pressure_distribution({}, 1e8), std::domain_error);
  EXPECT_THROW(fit_pressure_distribution(empty, 0.0), std::domain_error);
}

} // namespace
} // namespace asperity::theory
