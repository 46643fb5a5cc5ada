// Tests of reports/analysis/comparison.hpp: values between rows, refused
// curves, and deviations.
#include "reports/analysis/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::reports::comparison_test {

using results::CurvePoint;

constexpr double rms_height = 34e-9; // m
constexpr double decay = 0.4 * rms_height;

CurvePoint row(double pressure, double gap, double area) {
  CurvePoint point;
  point.nominal_pressure = pressure;
  point.mean_gap = gap;
  point.area_fraction = area;
  return point;
}

// u = u_0 ln(p_0/p), A = 2e-9 p: linear in the coordinates of the header.
std::vector<CurvePoint> reference_rows(int count) {
  std::vector<CurvePoint> rows;
  for (int i = 0; i < count; ++i) {
    const double pressure = 1e6 * std::pow(2.0, i);
    rows.push_back(
        row(pressure, decay * std::log(1e8 / pressure), 2e-9 * pressure));
  }
  return rows;
}

// A curve that is linear in ln p is exact between rows, for few rows and many.
// Tolerance: roundoff of exp and ln at ln A = -6, 1e-14.
TEST(CurveFunction, IsExactBetweenRowsOfAnExponential) {
  for (const int count : {2, 3, 4, 7}) {
    const CurveFunction curve(reference_rows(count));
    for (const double pressure : {1e6, 1.1e6, 1.9e6, 2e6}) {
      EXPECT_NEAR(curve.gap(pressure) / decay, std::log(1e8 / pressure), 1e-13);
      EXPECT_NEAR(curve.area_fraction(pressure) / (2e-9 * pressure), 1.0,
                  1e-13);
    }
  }
}

TEST(CurveFunction, DoesNotExtrapolate) {
  const CurveFunction curve(reference_rows(4));

  EXPECT_TRUE(std::isnan(curve.gap(0.9e6)));
  EXPECT_TRUE(std::isnan(curve.gap(8.1e6)));
  EXPECT_FALSE(std::isnan(curve.gap(8e6)));
  EXPECT_TRUE(std::isnan(CurveFunction({}).gap(1e6)));
}

// Rows at 1e6, 2e6, and 1.9e7 or 2.1e7 Pa.
TEST(CurveFunction, IsUnknownBetweenRowsMoreThanADecadeApart) {
  std::vector<CurvePoint> rows = reference_rows(2);
  rows.push_back(row(1.9e7, 0.0, 0.05));
  const CurveFunction within(rows);
  rows.back().nominal_pressure = 2.1e7;
  const CurveFunction beyond(rows);

  EXPECT_TRUE(std::isfinite(within.gap(1e7)));
  EXPECT_TRUE(std::isnan(beyond.gap(1e7)));
  EXPECT_TRUE(std::isnan(beyond.area_fraction(1e7)));
  EXPECT_TRUE(std::isfinite(beyond.gap(1.5e6)));
  EXPECT_EQ(beyond.gap(2.1e7), 0.0);
}

// On an exponential a shift of u by s u_0 is a relative difference s of p to
// first order, at the ends of the other curve too, and rows beyond them do not
// count. Tolerance: u_ref is differenced over 1e-3 of ln p, where it is linear;
// roundoff of the difference, 1e-16/1e-3.
TEST(PressureDifference, IsTheShiftOverTheDecay) {
  const CurveFunction reference(reference_rows(5));
  std::vector<CurvePoint> rows = reference_rows(6);
  rows[5].mean_gap += 0.5 * decay; // beyond the last row of the reference
  for (std::size_t i = 0; i < 5; ++i)
    rows[i].mean_gap += (i == 4 ? 0.003 : -0.001) * decay;

  EXPECT_NEAR(largest_pressure_difference(rows, reference), 0.003, 1e-12);
  EXPECT_TRUE(std::isnan(largest_pressure_difference({}, reference)));
}

// In full contact the mean gap is roundoff and does not determine a pressure.
TEST(PressureDifference, LeavesOutRowsInFullContact) {
  std::vector<CurvePoint> full = reference_rows(5);
  full[3].mean_gap = full[4].mean_gap = 0.0;
  const CurveFunction reference(full);
  std::vector<CurvePoint> rows = full;
  rows[3].mean_gap = rows[4].mean_gap = 1e-25;
  rows[3].area_fraction = rows[4].area_fraction = 1.0;

  EXPECT_EQ(largest_pressure_difference(rows, reference), 0.0);
}

// Only rows with 0.3 < u/h_rms < 1.5 count, and rows outside the range of the
// reference are excluded. u/h_rms of the rows here: 0.2, 1.0, 1.4, 1.7 with
// offsets 0.5, 0.03, -0.05, 0.5 of h_rms. Tolerance: roundoff.
TEST(LargestGapDeviation, UsesOnlyItsStatedRange) {
  const std::vector<Deviation> rows{
      {1.0, 0.2 * rms_height, 0.7 * rms_height, 0.0, 0.0},
      {1.0, 1.0 * rms_height, 1.03 * rms_height, 0.0, 0.0},
      {1.0, 1.4 * rms_height, 1.35 * rms_height, 0.0, 0.0},
      {1.0, 1.2 * rms_height, not_a_number, 0.0, 0.0},
      {1.0, 1.7 * rms_height, 2.2 * rms_height, 0.0, 0.0}};

  EXPECT_NEAR(largest_gap_deviation(rows, rms_height), 0.05, 1e-13);
  EXPECT_TRUE(std::isnan(largest_gap_deviation({}, rms_height)));
}

// The excess is the mean over rows up to 15 % counted area; others are ignored.
TEST(LightLoadAreaExcess, AveragesTheLightRows) {
  const std::vector<Deviation> rows{{1.0, 0.0, 0.0, 0.02 * 1.2, 0.02},
                                    {2.0, 0.0, 0.0, 0.10 * 1.3, 0.10},
                                    {3.0, 0.0, 0.0, 0.16, 0.05},
                                    {4.0, 0.0, 0.0, 0.0, 0.01}};

  EXPECT_NEAR(light_load_area_excess(rows), 0.25, 1e-14);
}

TEST(Deviations, PutEachRowBesideTheReferenceAtItsPressure) {
  std::vector<CurvePoint> rows = reference_rows(5);
  for (CurvePoint& point : rows)
    point.mean_gap += 1e-9;
  const CurveFunction reference(reference_rows(4));

  const std::vector<Deviation> found = deviations(rows, reference);

  ASSERT_EQ(found.size(), 5U);
  EXPECT_NEAR(found[2].gap - found[2].reference_gap, 1e-9, 1e-21);
  EXPECT_TRUE(std::isnan(found[4].reference_gap));
}

} // namespace asperity::reports::comparison_test
