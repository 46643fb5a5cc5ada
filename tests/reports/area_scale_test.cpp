// Tests of reports/analysis/area_scale.hpp: the factor between two entire
// curves is found over the stated loads.
#include "reports/analysis/area_scale.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthetic.hpp"

namespace asperity::reports::area_scale_test {

Deviation row(double pressure, double area, double theory) {
  return {pressure, 0.0, 0.0, area, theory};
}

// Theory 1, 2, 3, 4 and method 2, 3, 3, 4, all over 10: the products sum to 33
// and the squares to 30. Lighter half: 8/5; heavier: 25/25. Residuals of all:
// 0.9, 0.8, -0.3, -0.4 over 10. Tolerance: roundoff.
TEST(AreaScale, EqualsTheExplicitLeastSquares) {
  const std::vector<Deviation> rows{
      row(1.0, 0.2, 0.1),          row(2.0, 0.3, 0.2),
      row(2.5, not_a_number, 0.2), row(2.7, 0.0, 0.2),
      row(3.0, 0.3, 0.3),          row(4.0, 0.4, 0.4),
      row(5.0, 0.4, not_a_number)};

  const AreaScale all = fit_area_scale(rows, LoadRange::all);

  EXPECT_NEAR(all.factor.value, 33.0 / 30.0, 1e-15);
  EXPECT_NEAR(all.factor.standard_error,
              std::sqrt((0.81 + 0.64 + 0.09 + 0.16) / 3.0 / 30.0), 1e-14);
  EXPECT_EQ(all.rows, 4);
  EXPECT_EQ(all.pressure_low, 1.0);
  EXPECT_EQ(all.pressure_high, 4.0);
}

// Of five loads the third is in both halves: theory 1 to 5, method twice that
// up to the third, then 9 and 9. Lighter 28/14; heavier (18+36+45)/50.
TEST(AreaScale, TakesEitherHalfOfTheLoads) {
  const std::vector<Deviation> rows{row(1.0, 0.2, 0.1), row(2.0, 0.4, 0.2),
                                    row(3.0, 0.6, 0.3), row(4.0, 0.9, 0.4),
                                    row(5.0, 0.9, 0.5)};

  const AreaScale light = fit_area_scale(rows, LoadRange::lower_half);
  const AreaScale heavy = fit_area_scale(rows, LoadRange::upper_half);

  EXPECT_NEAR(light.factor.value, 2.0, 1e-15);
  EXPECT_EQ(light.pressure_high, 3.0);
  EXPECT_NEAR(heavy.factor.value, 99.0 / 50.0, 1e-15);
  EXPECT_EQ(heavy.pressure_low, 3.0);
}

TEST(AreaScale, IsNoneThroughTwoLoads) {
  const std::vector<Deviation> rows{row(1.0, 0.2, 0.1), row(2.0, 0.4, 0.2)};

  const AreaScale none = fit_area_scale(rows, LoadRange::all);

  EXPECT_TRUE(std::isnan(none.factor.value));
  EXPECT_NE(none.factor.reason, "");
}

// A summary has the factor with which the synthetic "fem" was made, where its
// area is not limited to 1, and states over which loads it was taken.
TEST(AreaScale, IsAQuantityOfAMethod) {
  const cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 2);
  for (results::MethodRecord& method : result.methods)
    for (results::Curve& curve : method.realizations)
      curve.points.resize(12);
  ASSERT_LT(result.methods[1].realizations[0].points.back().area_fraction, 1.0);

  const Summary summary = summarize(result, rough);

  const Estimate& scale = summary.methods[1].quantities.at("area_scale");
  EXPECT_NEAR(scale.value, synthetic::area_factor, 1e-12);
  EXPECT_EQ(scale.realizations, 2);
  EXPECT_EQ(scale.remark.find("over p/E* from 0.0001 to 0.0095"), 0U)
      << scale.remark;
  EXPECT_NEAR(summary.methods[1].quantities.at("area_scale_upper_half").value,
              synthetic::area_factor, 1e-12);
  EXPECT_FALSE(summary.methods[0].quantities.contains("area_scale"));
}

} // namespace asperity::reports::area_scale_test
