// Tests of reports/numbers/estimate.hpp: lines, their errors, and the coverage
// of intervals.
#include "reports/numbers/estimate.hpp"
#include "reports/numbers/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asperity::reports::estimate_test {

// Slope, intercept and errors of the four points (0,1) (1,3) (2,2) (3,5): slope
// 11/10, intercept 11/10, residual squares 2.7, slope error sqrt(1.35/5).
// Tolerance: roundoff.
TEST(FitLine, EqualsTheExplicitSums) {
  const std::vector<double> x{0.0, 1.0, 2.0, 3.0};
  const std::vector<double> y{1.0, 3.0, 2.0, 5.0};

  const LineFit fit = fit_line(x, y);

  EXPECT_NEAR(fit.slope, 1.1, 1e-14);
  EXPECT_NEAR(fit.intercept, 1.1, 1e-14);
  EXPECT_NEAR(fit.slope_error, std::sqrt(1.35 / 5.0), 1e-14);
  EXPECT_NEAR(fit.intercept_error, std::sqrt(1.35 * (0.25 + 2.25 / 5.0)),
              1e-14);
  EXPECT_NEAR(fit.largest_residual, 1.3, 1e-14);
}

// For any curve there is a line or none; nothing is thrown.
TEST(FitLine, IsNoneWithoutALine) {
  const std::vector<double> one{1.0};
  const std::vector<double> same{2.0, 2.0, 2.0};
  const std::vector<double> rising{1.0, 2.0, 3.0};
  const std::vector<double> broken{1.0, not_a_number, 3.0};

  EXPECT_TRUE(std::isnan(fit_line({}, {}).slope));
  EXPECT_TRUE(std::isnan(fit_line(one, one).slope));
  EXPECT_TRUE(std::isnan(fit_line(same, rising).slope));
  EXPECT_TRUE(std::isnan(fit_line(rising, broken).slope));
  EXPECT_TRUE(std::isnan(fit_line(broken, rising).intercept));
}

// Student's t for 1 and 2 degrees of freedom, whose quantiles are closed:
// tan(pi 0.475), and 2 a sqrt(2/(4 b)) with a = .475, b = a^2.
TEST(StudentHalfWidth, EqualsTheClosedQuantiles) {
  const double one = std::tan(std::acos(-1.0) * 0.475);
  const double alpha = 0.975 * 0.025 * 4.0;
  const double two = 0.95 * std::sqrt(2.0 / alpha);

  EXPECT_NEAR(student_half_width(1.0, 1), one, 1e-9);
  EXPECT_NEAR(student_half_width(3.0, 2), 3.0 * two, 1e-9);
  EXPECT_TRUE(std::isnan(student_half_width(1.0, 0)));
}

// The interval covers the exact value in 95 % of ensembles, also for three
// realisations. Tolerance: 3 sigma of 4000 trials, 3 sqrt(.95 .05/4000) = 1 %.
TEST(MeanOverRealizations, CoversTheExactValueAsOftenAsStated) {
  std::mt19937_64 generator(20080101);
  std::normal_distribution<double> gamma(0.4, 0.03);
  const int trials = 4000;
  for (const int realizations : {2, 3, 8}) {
    int covered = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<FittedValue> fits;
      for (int i = 0; i < realizations; ++i)
        fits.push_back({gamma(generator), 1e-9, 5});
      const Estimate estimate = mean_over_realizations(fits);
      covered += std::abs(estimate.value - 0.4) <= estimate.half_width;
    }
    EXPECT_NEAR(covered / static_cast<double>(trials), 0.95, 0.0104)
        << realizations << " realisations";
  }
}

TEST(MeanOverRealizations, ReportsAnIntervalOfTheFitAlone) {
  const std::vector<FittedValue> one{{0.41, 0.01, 2}};

  const Estimate estimate = mean_over_realizations(one);

  EXPECT_EQ(estimate.realizations, 1);
  EXPECT_NEAR(estimate.half_width, student_half_width(0.01, 2), 1e-15);
  EXPECT_NE(estimate.remark.find("that of the fit"), std::string::npos);
}

TEST(MeanOverRealizations, LeavesOutAndCountsFitsWithoutAnswer) {
  const std::vector<FittedValue> fits{{0.4, 0.0, 1}, {}, {0.5, 0.0, 1}};
  const std::vector<FittedValue> none{{}, {.reason = "too few rows"}};

  const Estimate estimate = mean_over_realizations(fits);

  EXPECT_NEAR(estimate.value, 0.45, 1e-15);
  EXPECT_EQ(estimate.realizations, 2);
  EXPECT_NE(estimate.remark.find("1 without a value"), std::string::npos);
  EXPECT_FALSE(mean_over_realizations({}).has_value());
  EXPECT_EQ(mean_over_realizations(none).remark, "too few rows");
}

// A large percentage without an interval is printed in full digits, not as
// 1.2e+02 %.
TEST(PercentText, HasNoExponent) {
  Estimate estimate;
  estimate.value = 7.519;
  EXPECT_EQ(percent_text(estimate), "752 %");

  estimate.value = 0.00412;
  EXPECT_EQ(percent_text(estimate), "0.41 %");
}

// An interval is printed to two digits, but with one decimal at most.
TEST(PercentText, HasOneDecimalAtMost) {
  Estimate estimate;
  estimate.value = 0.12345;
  estimate.half_width = 0.00123;
  EXPECT_EQ(percent_text(estimate), "+12.3 ± 0.1 %");

  estimate.value = -0.12345;
  estimate.half_width = 0.234;
  EXPECT_EQ(percent_text(estimate), "-12 ± 23 %");
}

TEST(NumberText, HasNoIntervalOfRoundoff) {
  Estimate estimate;
  estimate.value = 0.32391;
  estimate.half_width = 0.0213;
  EXPECT_EQ(number_text(estimate), "0.324 ± 0.021");

  estimate.half_width = 6e-16;
  EXPECT_EQ(number_text(estimate), "0.3239");
}

} // namespace asperity::reports::estimate_test
