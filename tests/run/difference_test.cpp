// Tests of the comparison of two results with artificial rows.
#include "results/types/method_columns.hpp"
#include "run/difference.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace asperity::run::difference_test {

using results::CurvePoint;

/// A result of one method with two rows on a surface with h_rms = 1e-9 m.
ComparedSide side_with(const CurvePoint& first) {
  CurvePoint second = first;
  second.step = 1;
  ComparedSide side;
  side.result.emplace();
  side.result->surfaces.emplace_back();
  side.result->surfaces[0].rms_height = 1e-9;
  side.result->methods = {
      {"fem", "fem", "", {results::Curve{{first, second}, {}, 1.0}}}};
  return side;
}

CurvePoint row() {
  CurvePoint point;
  point.nominal_pressure = 1e6;
  point.mean_gap = 2e-9;
  point.area_fraction = 0.1;
  point[columns::area_fraction_fit] = std::nan("");
  point.cpu_time = 1.0;
  return point;
}

/// The difference between the row above and a changed one.
MethodDifference difference_after(void (*change)(CurvePoint&),
                                  double tolerance = 0.0) {
  CurvePoint changed = row();
  change(changed);
  const Difference difference =
      difference_of(side_with(row()), side_with(changed), tolerance);
  EXPECT_EQ(difference.methods.back().method, "fem");
  EXPECT_EQ(difference.is_any(),
            difference.methods.back().rows_that_differ > 0);
  return difference.methods.back();
}

TEST(Difference, IsNoneOfEqualRowsWhateverTheirTimes) {
  const MethodDifference same = difference_after([](CurvePoint& point) {
    point.cpu_time = 7.0;
    point[columns::transform_time] = 0.5;
    point[columns::memory] = 1e9;
  });

  EXPECT_EQ(same.rows, 2);
  EXPECT_EQ(same.rows_that_differ, 0);
  EXPECT_EQ(same.largest.relative, 0.0) << "NaN in both is no difference";
}

TEST(Difference, IsRelativeToTheLargerNumberAndTheWorstColumn) {
  const MethodDifference found = difference_after([](CurvePoint& point) {
    point.area_fraction = 0.08;
    point.nominal_pressure = 0.99e6;
  });

  EXPECT_EQ(found.rows_that_differ, 2);
  EXPECT_EQ(found.largest.column, "area_fraction");
  EXPECT_NEAR(found.largest.relative, 0.2, 1e-12);
  EXPECT_EQ(found.rows_listed[1].step, 1);
}

// A very small gap does not make a small difference large.
TEST(Difference, OfMeanGapsIsRelativeToTheRoughnessAtLeast) {
  CurvePoint closed = row();
  closed.mean_gap = 1e-15;
  CurvePoint other = closed;
  other.mean_gap = 2e-15;

  const Difference found =
      difference_of(side_with(closed), side_with(other), 0.0);

  EXPECT_NEAR(found.methods.back().largest.relative, 1e-6, 1e-12);
}

TEST(Difference, OfANumberFromNoneIsInfinite) {
  const MethodDifference found = difference_after(
      [](CurvePoint& point) { point[columns::area_fraction_fit] = 0.1; }, 1.0);

  EXPECT_EQ(found.rows_that_differ, 2);
  EXPECT_EQ(found.largest.relative, std::numeric_limits<double>::infinity());
}

TEST(Difference, ComparesTheSolverOnlyWithoutATolerance) {
  const auto change = [](CurvePoint& point) {
    point.iterations = 5;
    point.residual = 1e-9;
  };

  EXPECT_EQ(difference_after(change, 0.0).rows_that_differ, 2);
  EXPECT_EQ(difference_after(change, 1e-12).rows_that_differ, 0);
}

TEST(Difference, ReportsTheBuildWithoutCountingIt) {
  ComparedSide one = side_with(row());
  ComparedSide other = side_with(row());
  one.result->provenance = {{"commit", "abc"}, {"started", "yesterday"}};
  other.result->provenance = {{"commit", "def"}, {"started", "today"}};

  const Difference difference = difference_of(one, other, 0.0);

  ASSERT_EQ(difference.build.size(), 1U);
  EXPECT_EQ(difference.build[0].name, "commit");
  EXPECT_FALSE(difference.is_any());
  const auto json = nlohmann::json::parse(difference_json(difference, 0.0));
  EXPECT_EQ(json["is_different"], false);
  EXPECT_EQ(json["build"][0]["other"], "def");
}

} // namespace asperity::run::difference_test
