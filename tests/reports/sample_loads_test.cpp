// Tests of reports/sweeps/sample_loads.hpp.
#include "reports/sweeps/sample_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::sample_loads_test {

/// Samples with converged steps, by index, at nominal pressures of as many MPa
/// as the index says.
SampleLoads table_of(const std::vector<std::vector<int>>& steps,
                     double load_of_last = 1e6) {
  SweepRecord record;
  record.keys.push_back({"surface.seed", {}});
  SweptResults results;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    record.keys[0].values.push_back(std::to_string(i));
    record.points.push_back({{i}, "", ""});
    auto result = std::make_unique<SweptResult>();
    result->point = i;
    MethodSummary& method = result->summary.methods.emplace_back();
    method.name = method.kind = "halfspace";
    SweptCurve curve{"halfspace", 1e-6, {}};
    for (const int step : steps[i]) {
      results::CurvePoint& row = curve.rows.emplace_back();
      row.step = step;
      row.nominal_pressure =
          step * (i + 1 == steps.size() ? load_of_last : 1e6);
      row.mean_gap = 1e-6 / step;
      row.area_fraction = 0.01 * (step + static_cast<double>(i));
      row.area_fraction_corrected = not_a_number;
    }
    result->curves.push_back(std::move(curve));
    results.push_back(std::move(result));
  }
  return sample_loads(record, results);
}

// A step that has not converged on one sample, which is not the same step on
// each, leaves the others of this load and all other loads.
TEST(SampleLoads, AreOfTheSamplesWithAValue) {
  const SampleLoads table = table_of({{1, 2, 4}, {1, 3, 4}, {1, 2, 3, 4}});
  ASSERT_EQ(table.loads.size(), 4u);
  for (std::size_t step = 1; step <= 4; ++step) {
    const SampleLoad& load = table.loads[step - 1];
    EXPECT_DOUBLE_EQ(load.state, 1e6 * static_cast<double>(step));
    EXPECT_EQ(load.columns[0].known(), step == 2 || step == 3 ? 2 : 3);
  }
  EXPECT_TRUE(std::isnan(table.loads[1].columns[0].values[1]));
  EXPECT_DOUBLE_EQ(table.loads[1].columns[0].spread.mean, 0.03);
}

TEST(SampleLoads, AreShared) {
  EXPECT_EQ(table_of({{1, 2}, {1, 2}}).state.name, "nominal_pressure");
  EXPECT_EQ(table_of({{1, 2}, {1, 2}}, 2e6).state.name,
            "mean_gap_over_rms_height");
}

} // namespace asperity::reports::sample_loads_test
