// Tests of results/observables/distributions.hpp: densities whose integrals are
// known.
#include "results/observables/distributions.hpp"
#include "results/observables/observables.hpp"
#include "tests/results/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::results::distributions_test {

double integral(const Histogram& histogram) {
  double sum = 0.0;
  for (const double density : histogram.density)
    sum += density * histogram.bin_width();
  return sum;
}

double first_moment(const Histogram& histogram) {
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.density.size(); ++i)
    sum +=
        histogram.density[i] * histogram.bin_width() * histogram.bin_centre(i);
  return sum;
}

// The integral is the area fraction (roundoff of 40 bins), the first moment the
// nominal pressure to half a bin times the area; the density of a linear ramp
// is flat.
TEST(PressureHistogram, IntegratesToAreaAndNominalPressure) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> pressure(4000);
  for (double& one : pressure)
    one = std::max(0.0, uniform(random)) * 1e6;

  const Histogram histogram = pressure_histogram(pressure, 40);

  const double area = counted_area_fraction(ContactNodes::under(pressure));
  EXPECT_NEAR(integral(histogram), area, 1e-13);
  EXPECT_NEAR(first_moment(histogram), weighted_mean(pressure),
              0.5 * histogram.bin_width() * area);
}

TEST(PressureHistogram, OfARampIsFlat) {
  std::vector<double> pressure(1000);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    pressure[i] = (static_cast<double>(i) + 0.5) * 2.0; // to 2000 Pa

  const Histogram histogram = pressure_histogram(pressure, 10);

  ASSERT_EQ(histogram.density.size(), 10U);
  EXPECT_EQ(histogram.highest, 1999.0);
  for (const double density : histogram.density) // a bin may have one node more
    EXPECT_NEAR(density * 2000.0, 1.0, 0.02);
}

// Only open nodes count: neither contact with penetration (negative gap) nor
// contact at zero gap does; a gap that is below zero by roundoff does.
TEST(GapHistogram, IsOfTheOpenNodes) {
  const std::vector<double> pressure{5.0, 5.0, 0.0, 0.0, 0.0};
  const std::vector<double> gap{-1.0, 0.0, -1e-20, 0.1, 1.0};

  const Histogram histogram = gap_histogram(gap, pressure, 4);

  EXPECT_NEAR(integral(histogram), 3.0 / 5.0, 1e-15);
  EXPECT_NEAR(histogram.density[0] * histogram.bin_width(), 2.0 / 5.0, 1e-15);
  EXPECT_NEAR(histogram.density[3] * histogram.bin_width(), 1.0 / 5.0, 1e-15);
}

// Atoms, and nodes with adhesion, have pressures of either sign anywhere.
TEST(GapHistogram, OfAtomsIsOfThoseWhoseGapIsOpen) {
  const std::vector<double> pressure{5.0, -5.0, 1e-3, -1e-3, 2.0};
  const std::vector<double> gap{-1.0, 0.0, 1.0, 0.1, 0.6};

  const Histogram histogram =
      gap_histogram(gap, pressure, 4, {mechanics::ContactField::gap, 0.0});

  EXPECT_NEAR(integral(histogram), 3.0 / 5.0, 1e-15);
}

TEST(Histograms, HaveNoBinsWhereNothingIsCounted) {
  EXPECT_TRUE(pressure_histogram(std::vector{0.0, 0.0}, 8).density.empty());
  EXPECT_TRUE(gap_histogram(std::vector{0.0, 0.0}, std::vector{1.0, 1.0}, 8)
                  .density.empty());
  EXPECT_THROW(pressure_histogram(std::vector{1.0}, 0), std::domain_error);
  EXPECT_THROW(pressure_histogram(std::vector{1.0 / 0.0}, 3),
               std::domain_error);
}

} // namespace asperity::results::distributions_test
