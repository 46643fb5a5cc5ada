// Tests of series of ever finer settings, against series from a formula: c h^p
// has the order p and the limit with which it was made.
#include "reports/analysis/refinement.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

namespace asperity::reports::refinement_test {

// Any power law passes through two points, so that they determine none.
TEST(PowerLawThroughTwoPoints, IsNotDetermined) {
  const std::vector<double> x{1.0, 2.0, 4.0};
  const std::vector<double> y{3.0, 12.0, 48.0};

  const PowerLaw two = fit_power_law({x.data(), 2}, {y.data(), 2});

  EXPECT_NEAR(two.exponent, 2.0, 1e-14);
  EXPECT_TRUE(std::isnan(two.determined_exponent()));
  EXPECT_NEAR(fit_power_law(x, y).determined_exponent(), 2.0, 1e-14);
}

double between(double low, double high, int draw) {
  return low + (high - low) * draw / 1000.0;
}

// Verifies that any power law is recovered. Tolerance: roundoff of logarithms.
RC_GTEST_PROP(PowerLaws, AreFoundAgain, ()) {
  const double exponent = between(-4.0, 4.0, *rc::gen::inRange(0, 1001));
  const double factor = between(0.1, 10.0, *rc::gen::inRange(0, 1001));
  const std::vector<double> x{32.0, 64.0, 128.0, 192.0};
  std::vector<double> y;
  for (const double one : x)
    y.push_back(factor * std::pow(one, exponent));

  const PowerLaw law = fit_power_law(x, y);

  RC_ASSERT(std::abs(law.exponent - exponent) < 1e-12);
  RC_ASSERT(std::abs(law.factor / factor - 1.0) < 1e-11);
}

// Order and limit of c h^p are recovered, also where the spacings are not in
// one ratio. Tolerance: 40 bits of the root, seven digits lost where the
// differences are small beside the values.
RC_GTEST_PROP(RefinementLimits, AreFoundAgain, ()) {
  const double order = between(0.6, 3.9, *rc::gen::inRange(0, 1001));
  const double limit = between(1.0, 2.0, *rc::gen::inRange(0, 1001));
  const std::vector<double> spacings{1.0 / 64, 1.0 / 128, 1.0 / 250};
  std::vector<std::vector<double>> answers;
  for (const double h : spacings)
    answers.push_back(
        {limit + std::pow(h, order), -limit + std::pow(h, order)});

  const RefinementLimit found =
      refinement_limit(answers, spacings, std::array{1.0, 1.0});

  RC_ASSERT(found.is_extrapolated);
  RC_ASSERT(std::abs(found.order - order) < 1e-4);
  RC_ASSERT(std::abs(found.values[0] - limit) < 1e-6 * std::pow(1.0 / 64, 0.6));
  RC_ASSERT(std::abs(found.values[1] + limit) < 1e-6 * std::pow(1.0 / 64, 0.6));
}

// A series that oscillates is not extrapolated; the limit is the finest value
// with the last difference as its uncertainty.
TEST(RefinementLimit, OfAnIrregularSeriesIsItsFinest) {
  const std::vector<double> spacings{4.0, 2.0, 1.0};
  const std::vector<std::vector<double>> answers{{1.0}, {1.4}, {1.2}};

  const RefinementLimit found =
      refinement_limit(answers, spacings, std::array{2.0});

  EXPECT_FALSE(found.is_extrapolated);
  EXPECT_EQ(found.values, answers.back());
  EXPECT_NEAR(found.uncertainty, 0.1, 1e-15);
}

// Differences that grow have no order.
TEST(ObservedOrder, NeedsFallingDifferences) {
  const std::array spacings{4.0, 2.0, 1.0};

  EXPECT_TRUE(std::isnan(observed_order(spacings, 1.0, 1.5)));
  EXPECT_TRUE(std::isnan(observed_order(spacings, 1.0, 0.0)));
  EXPECT_NEAR(observed_order(spacings, 4.0, 1.0), 2.0, 1e-10);
}

// A value that is missing at one load has no error.
TEST(RmsDifference, OfAMissingValueIsMissing) {
  const std::array one{1.0, not_a_number};
  const std::array other{1.0, 2.0};
  const std::array scale{1.0, 1.0};

  EXPECT_TRUE(std::isnan(rms_difference(one, other, scale)));
  EXPECT_NEAR(rms_difference(other, std::array{1.0, 4.0}, scale),
              std::sqrt(2.0), 1e-15);
}

// Every pair is on the Pareto front or dominated by one that is, and along the
// front the error decreases as the cost increases.
RC_GTEST_PROP(ParetoFront, UndercutsEverythingElse, ()) {
  const auto draws = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 20), rc::gen::inRange(0, 20)));
  std::vector<double> costs;
  std::vector<double> errors;
  for (const auto& [cost, error] : draws) {
    costs.push_back(cost);
    errors.push_back(error == 13 ? not_a_number : error);
  }

  const std::vector<std::size_t> front = pareto_front(costs, errors);

  for (std::size_t k = 1; k < front.size(); ++k) {
    RC_ASSERT(costs[front[k]] > costs[front[k - 1]]);
    RC_ASSERT(errors[front[k]] < errors[front[k - 1]]);
  }
  for (std::size_t i = 0; i < costs.size(); ++i)
    RC_ASSERT(std::isnan(errors[i]) ||
              std::any_of(front.begin(), front.end(), [&](std::size_t k) {
                return costs[k] <= costs[i] && errors[k] <= errors[i];
              }));
}

} // namespace asperity::reports::refinement_test
