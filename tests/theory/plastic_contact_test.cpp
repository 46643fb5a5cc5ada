// Tests of theory/persson/plastic_contact.hpp.
#include "theory/persson/plastic_contact.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace asperity::theory::plastic_contact_test {

constexpr double hardness = 3.0;
const std::vector<double> loads{0.01, 0.5, 1.5, 2.9};
/// On both sides of the change from images to the series at .05 H^2 = .45.
const std::vector<double> variances{0.01, 0.3, 0.449, 0.451, 2.0, 50.0};

/// int_0^H sigma^power P dsigma by the trapezoidal rule in n intervals, with an
/// error of (H/n)^2/12 times the slope at the ends, which is 70 at most here.
double moment(double load, double variance, int power) {
  constexpr int n = 40000;
  double sum = 0.0;
  for (int i = 1; i < n; ++i) {
    const double sigma = hardness * i / n;
    sum += std::pow(sigma, power) *
           plastic_pressure_density(sigma, load, variance, hardness);
  }
  return sum * hardness / n;
}

TEST(PlasticContact, SharesAreThoseOfTheDistribution) {
  for (const double load : loads)
    for (const double variance : variances) {
      const PlasticShares found = plastic_shares(load, variance, hardness);
      EXPECT_NEAR(found.elastic, moment(load, variance, 0), 1e-7)
          << load << " " << variance;
      EXPECT_NEAR(load, moment(load, variance, 1) + hardness * found.plastic,
                  1e-7)
          << load << " " << variance;
      EXPECT_GE(found.plastic, 0.0);
      EXPECT_LE(found.elastic + found.plastic, 1.0 + 1e-15);
    }
}

// Both forms hold at .05 H^2, where the density has no jump either.
TEST(PlasticContact, SeriesAndImagesAgree) {
  const double at = 0.05 * hardness * hardness;
  for (const double load : loads) {
    const PlasticShares below =
        plastic_shares(load, at * (1.0 - 1e-15), hardness);
    const PlasticShares above =
        plastic_shares(load, at * (1.0 + 1e-15), hardness);
    EXPECT_NEAR(below.elastic, above.elastic, 1e-14);
    EXPECT_NEAR(below.plastic, above.plastic, 1e-14);
    EXPECT_NEAR(
        plastic_pressure_density(1.0, load, at * (1.0 - 1e-15), hardness),
        plastic_pressure_density(1.0, load, at * (1.0 + 1e-15), hardness),
        1e-14);
  }
}

TEST(PlasticContact, WithoutYieldIsElastic) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double load : loads)
    for (const double wall : {1e4, infinite}) {
      const PlasticShares found = plastic_shares(load, 2.0, wall);
      EXPECT_NEAR(found.elastic, area_fraction(load, 2.0), 1e-15);
      EXPECT_EQ(found.plastic, 0.0);
    }
}

// Rough surfaces that are soft yield wherever they touch: A = p/H, which is
// also the area at the largest load.
TEST(PlasticContact, IsFullyPlasticOnRoughSurfaces) {
  const PlasticShares rough = plastic_shares(1.2, 1e3, hardness);
  EXPECT_NEAR(rough.plastic, 1.2 / hardness, 1e-15);
  EXPECT_NEAR(rough.elastic, 0.0, 1e-15);
  EXPECT_NEAR(plastic_shares(hardness, 0.3, hardness).plastic, 1.0, 1e-15);
}

// Stress that leaves to 0 and stress that leaves to H: with p and H - p the
// two boundaries change places.
TEST(PlasticContact, BoundariesAreMirrorImages) {
  for (const double variance : variances) {
    const PlasticShares light = plastic_shares(0.7, variance, hardness);
    const PlasticShares heavy =
        plastic_shares(hardness - 0.7, variance, hardness);
    EXPECT_NEAR(heavy.plastic, 1.0 - light.elastic - light.plastic, 1e-14);
  }
}

TEST(PlasticContact, RefusesALoadAboveTheHardness) {
  EXPECT_THROW(plastic_shares(3.1, 1.0, hardness), std::domain_error);
  EXPECT_THROW(plastic_shares(1.0, 1.0, 0.0), std::domain_error);
  EXPECT_THROW(plastic_pressure_density(3.1, 1.0, 1.0, hardness),
               std::domain_error);
}

} // namespace asperity::theory::plastic_contact_test
