// Tests of reports/sweeps/sweep_scatter.hpp.
#include "reports/sweeps/sweep_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::scatter_test {

/// Results of one method with these values of kappa, NaN for no result.
SweptResults results_with(const std::vector<double>& values) {
  SweptResults results;
  for (const double value : values) {
    auto result = std::make_unique<SweptResult>();
    result->point = results.size();
    result->status = "complete";
    MethodSummary method;
    method.name = "halfspace";
    method.quantities["kappa"].value = value;
    result->summary.methods.push_back(method);
    results.push_back(std::move(result));
  }
  return results;
}

// By hand: median 2, distances 1, 0, 1, 0, 8 of which the median is 1; the last
// has a modified z-score of 5.4, those of the others are at most 0.67.
TEST(Outliers, AreFarFromTheMedian) {
  EXPECT_EQ(outliers_of(std::vector{1.0, 2.0, 3.0, 2.0, 10.0}),
            (std::vector<std::size_t>{4}));
  EXPECT_TRUE(outliers_of(std::vector{1.0, 2.0, 3.0, 2.0, 7.0}).empty());
}

TEST(Outliers, NeedFiveValuesAndAScatter) {
  EXPECT_TRUE(outliers_of(std::vector{1.0, 1.1, 0.9, 100.0}).empty());
  EXPECT_TRUE(
      outliers_of(std::vector{1.0, 1.0, 1.0, 1.0, 1.0 + 1e-15}).empty());
}

TEST(ScatterOfSamples, IsTheirMeanAndDeviation) {
  const auto results = results_with({1.0, 2.0, NAN, 3.0, 2.0, 10.0});

  const std::vector<Scatter> rows = scatter_of(results, {"kappa", "beta"});

  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].method, "halfspace");
  EXPECT_EQ(rows[0].count, 5);
  EXPECT_DOUBLE_EQ(rows[0].spread.mean, 3.6);
  EXPECT_DOUBLE_EQ(rows[0].spread.deviation, std::sqrt(53.2 / 4.0));
  EXPECT_EQ(rows[0].lowest, 0U);
  EXPECT_EQ(rows[0].highest, 5U);
  EXPECT_EQ(rows[0].outliers, (std::vector<std::size_t>{5}));
}

TEST(ScatterOfSamples, LeavesOutWhatIsNotOfTheSurface) {
  EXPECT_TRUE(scatter_of(results_with({1.0, 1.0, 1.0}), {"kappa"}).empty());
  EXPECT_TRUE(scatter_of(results_with({1.0, NAN}), {"kappa"}).empty());
  auto given = results_with({1.0, 2.0});
  for (auto& result : given)
    result->summary.methods[0].quantities["kappa"].is_input = true;
  EXPECT_TRUE(scatter_of(given, {"kappa"}).empty());
}

} // namespace asperity::reports::scatter_test
