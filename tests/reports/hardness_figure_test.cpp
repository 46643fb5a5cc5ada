// Tests of the figure of elastic and plastic area.
#include "reports/figures/figures.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

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

// Two methods of one kind have the same colours for both areas.
TEST(PlasticAreaFigure, TellsMethodsOfOneKindApart) {
  results::Result result;
  result.contact_modulus = 1e9;
  for (const char* kind : {"theory", "halfspace"})
    for (const char* name : {".soft", ".hard", ".harder"})
      result.methods.push_back(
          {std::string(kind) + name, kind, "", {curve_of(0.25)}});
  cases::Case contact_case;

  const std::vector<Figure> found = drawn({&result, &contact_case, {}});

  ASSERT_EQ(found.size(), 1U);
  std::set<std::tuple<std::string, bool, int, int>> looks;
  for (const ChartCurve& curve : found[0].panels.front().curves)
    looks.emplace(curve.style.color, curve.style.has_markers,
                  curve.style.has_markers ? curve.style.marker : 0,
                  curve.style.has_markers ? 0 : curve.style.dash);
  EXPECT_EQ(looks.size(), 12U);
}

// Of flow and conductance: one colour, and open symbols stay open.
TEST(ChartPanel, GivesEachCurveOfALegendItsOwnStyle) {
  ChartPanel panel;
  for (int i = 0; i < 4; ++i)
    panel.add("theory", line("#222222", 1.6), 0, 3, 4);
  for (int i = 0; i < 2; ++i)
    panel.add("open", markers("#222222", 10, 1.0), 0, 3, 4);
  for (int i = 0; i < 2; ++i)
    panel.add("", line("#222222", 1.6), 0, 3, 4);

  std::vector<int> dashes, signs;
  for (const ChartCurve& curve : panel.curves)
    (curve.style.has_markers ? signs : dashes)
        .push_back(curve.style.has_markers ? curve.style.marker
                                           : curve.style.dash);
  EXPECT_EQ(dashes, (std::vector{1, 2, 3, 1, 1, 1})); // two are in no legend
  EXPECT_GT(panel.curves[3].style.width, panel.curves[0].style.width + 1.0);
  EXPECT_EQ(signs, (std::vector{10, 6}));
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
