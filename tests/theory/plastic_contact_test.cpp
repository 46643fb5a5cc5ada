// Tests of theory/persson/plastic_contact.hpp.
#include "theory/persson/plastic_contact.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::theory::plastic_contact_test {

constexpr double hardness = 3.0;
const std::vector<double> loads{0.01, 0.5, 1.5, 2.9};
/// On both sides of the change from images to the series at .05 H^2 = .45.
const std::vector<double> variances{0.01, 0.3, 0.449, 0.451, 2.0, 50.0};

/// P by its series, of which 80 terms have all digits at the least variance.
double density(double sigma, double load, double variance) {
  double sum = 0.0;
  for (int n = 1; n <= 80; ++n) {
    const double wave = n * std::numbers::pi / hardness;
    sum += 2.0 / hardness * std::sin(wave * load) * std::sin(wave * sigma) *
           std::exp(-wave * wave * variance);
  }
  return sum;
}

/// int_0^H sigma^power P dsigma.
double moment(double load, double variance, int power) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double sigma) {
        return std::pow(sigma, power) * density(sigma, load, variance);
      },
      0.0, hardness, 10, 1e-13);
}

// Tolerance: roundoff of the series and of its quadrature.
TEST(PlasticContact, SharesAreThoseOfTheDistribution) {
  for (const double load : loads)
    for (const double variance : variances) {
      const PlasticShares found = plastic_shares(load, variance, hardness);
      EXPECT_NEAR(found.elastic, moment(load, variance, 0), 1e-12)
          << load << " " << variance;
      EXPECT_NEAR(load, moment(load, variance, 1) + hardness * found.plastic,
                  1e-12)
          << load << " " << variance;
      EXPECT_GE(found.plastic, 0.0);
      EXPECT_LE(found.elastic + found.plastic, 1.0 + 1e-15);
    }
}

// Both forms hold at .05 H^2.
TEST(PlasticContact, SeriesAndImagesAgree) {
  const double at = 0.05 * hardness * hardness;
  for (const double load : loads) {
    const PlasticShares below =
        plastic_shares(load, at * (1.0 - 1e-15), hardness);
    const PlasticShares above =
        plastic_shares(load, at * (1.0 + 1e-15), hardness);
    EXPECT_NEAR(below.elastic, above.elastic, 1e-14);
    EXPECT_NEAR(below.plastic, above.plastic, 1e-14);
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
}

} // namespace asperity::theory::plastic_contact_test
