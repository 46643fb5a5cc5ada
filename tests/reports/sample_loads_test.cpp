// Tests of reports/sweeps/sample_loads.hpp.
#include "reports/sweeps/sample_loads.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::sample_loads_test {

/// Samples of one key, without results.
SweepRecord record_of_samples() {
  SweepRecord record;
  record.keys.push_back({"surface.seed", {}});
  return record;
}

/// A sample with a curve, whose rows have areas and gaps.
void add_sample(const std::vector<results::CurvePoint>& rows,
                SweepRecord& record, SweptResults& results) {
  const std::size_t i = results.size();
  record.keys[0].values.push_back(std::to_string(i));
  record.points.push_back({{i}, "", ""});
  auto result = std::make_unique<SweptResult>();
  result->point = i;
  MethodSummary& method = result->summary.methods.emplace_back();
  method.name = method.kind = "halfspace";
  result->curves.push_back({"halfspace", 1e-6, rows});
  results.push_back(std::move(result));
}

results::CurvePoint row_at(int step, double pressure, double gap, double area) {
  results::CurvePoint row;
  row.step = step;
  row.nominal_pressure = pressure;
  row.mean_gap = gap;
  row.area_fraction = area;
  row.area_fraction_corrected = not_a_number;
  return row;
}

/// Samples with converged steps, by index, at nominal pressures of as many MPa
/// as the index says.
SampleLoads table_of(const std::vector<std::vector<int>>& steps,
                     double load_of_last = 1e6) {
  SweepRecord record = record_of_samples();
  SweptResults results;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<results::CurvePoint> rows;
    for (const int step : steps[i])
      rows.push_back(
          row_at(step, step * (i + 1 == steps.size() ? load_of_last : 1e6),
                 1e-6 / step, 0.01 * (step + static_cast<double>(i))));
    add_sample(rows, record, results);
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

// Faces that a tension has parted have a gap and no state at that tension, and
// a load of 0 is reached to roundoff.
TEST(SampleLoads, AreOfFacesThatHoldTheTension) {
  SweepRecord record = record_of_samples();
  SweptResults results;
  for (const double held : {-1e5, 0.0})
    add_sample({row_at(0, 1e6, 1e-8, 0.1), row_at(1, 1e-9 * held, 2e-8, 0.05),
                row_at(2, held, 3e-8 - held, held < 0.0 ? 0.01 : 0.0),
                row_at(3, 0.0, 2e-7, 0.0)},
               record, results);

  const SampleLoads table = sample_loads(record, results);

  EXPECT_EQ(table.state.name, "nominal_pressure");
  ASSERT_EQ(table.loads.size(), 3U);
  EXPECT_EQ(table.loads[1].columns[0].known(), 2);
  EXPECT_EQ(table.loads[2].state, -1e5);
  EXPECT_EQ(table.loads[2].columns[0].known(), 1);
}

// What a case asks follows contact area and gap, and has a sentence: the median
// because a few samples leak most, and how many do not at all.
TEST(SampleLoads, AnswerWhatTheCaseAsks) {
  SweepRecord record = record_of_samples();
  SweptResults results;
  for (const double share : {0.0, 0.02, 0.03, 0.4}) {
    std::vector<results::CurvePoint> rows{row_at(0, 1e6, 1e-8, 0.1),
                                          row_at(1, 2e6, 5e-9, 0.2),
                                          row_at(2, 3e6, 3e-9, 0.3)};
    for (results::CurvePoint& row : rows) {
      row[columns::plastic_area] = row.step == 0 ? share : 0.0;
      row[columns::plastic_work] = 0.01;
    }
    add_sample(rows, record, results);
  }
  results.front()->answers = {{&columns::plastic_area, "Yields", "elastic"}};

  const SampleLoads table = sample_loads(record, results);

  ASSERT_EQ(table.columns.size(), 4U);
  EXPECT_EQ(table.columns[2].name, "plastic_area");
  EXPECT_EQ(table.columns[3].name, "plastic_work");
  EXPECT_EQ(sample_answers(table),
            "Yields: 2.5 % at 1 MPa, median of 4 maps (0 % to 40 %), 1 "
            "of them elastic; all are elastic from 2 MPa on.");
}

} // namespace asperity::reports::sample_loads_test
