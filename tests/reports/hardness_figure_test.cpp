// Tests of the figure of elastic and plastic area.
#include "reports/figures/figures.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::reports::hardness_figure_test {

results::Curve curve_of(double plastic) {
  results::Curve curve;
  for (int step = 0; step < 3; ++step) {
    results::CurvePoint point;
    point.step = step;
    point.nominal_pressure = 1e6 * (step + 1);
    point.area_fraction = 0.5;
    point[columns::plastic_area] = plastic;
    point.is_unloading = step == 2;
    curve.points.push_back(point);
  }
  return curve;
}

std::vector<Figure> drawn(const ReportEntry& entry) {
  return figures::plastic_area.draw({.entries = {&entry, 1}});
}

// Means over two realisations under first load; the last step is not drawn.
TEST(PlasticAreaFigure, HasBothAreasOfNumbersAndTheory) {
  results::Result result;
  result.contact_modulus = 1e9;
  result.methods.push_back({"theory", "theory", "", {curve_of(0.125)}});
  result.methods.push_back(
      {"halfspace", "halfspace", "", {curve_of(0.0), curve_of(0.25)}});
  cases::Case contact_case;

  const std::vector<Figure> found = drawn({&result, &contact_case, {}});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].data, "curve,index,p/E* [1],A/A_0 elastic [1],"
                           "A/A_0 plastic [1]\n"
                           "\"theory\",0,0.001,0.375,0.125\n"
                           "\"theory\",0,0.002,0.375,0.125\n"
                           "\"halfspace\",1,0.001,0.375,0.125\n"
                           "\"halfspace\",1,0.002,0.375,0.125\n");
  EXPECT_EQ(found[0].panels.front().curves.size(), 4U);
}

TEST(PlasticAreaFigure, NeedsAHardness) {
  results::Result result;
  result.contact_modulus = 1e9;
  result.methods.push_back(
      {"halfspace", "halfspace", "", {curve_of(not_a_number)}});
  cases::Case contact_case;

  EXPECT_TRUE(drawn({&result, &contact_case, {}}).empty());
}

} // namespace asperity::reports::hardness_figure_test
