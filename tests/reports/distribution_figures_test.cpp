// Tests of the figures of pressures, gaps and areas: the drawn numbers are
// those of the maps, on their own grid.
#include "reports/pages/report.hpp"
#include "results/types/method_columns.hpp"
#include "tests/reports/drawn.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "synthetic.hpp"

namespace asperity::reports::distribution_figures_test {

using Rows = std::vector<std::vector<double>>;

/// The numbers of a figure's data by the name of the curve.
std::map<std::string, Rows> curves_of(const Figure& figure) {
  std::map<std::string, Rows> curves;
  std::istringstream lines(figure.data);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t end = line.find('"', 1);
    std::istringstream fields(line.substr(end + 2));
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');)
      numbers.push_back(std::strtod(field.c_str(), nullptr));
    curves[line.substr(1, end - 1)].push_back(numbers);
  }
  return curves;
}

class Distributions : public ::testing::Test {
protected:
  Distributions() {
    // another grid, coarser than that of the surface
    fields.step = 3;
    fields.grid = {100, 100, 10e-6, 10e-6};
    fields.pressure.assign(fields.grid.size(), 0.0);
    fields.gap.assign(fields.grid.size(), 0.0);
  }

  /// A result whose "fem" has this one map.
  ReportEntry entry() {
    result.methods[1].realizations[0].fields = {fields};
    return entry_of(result, rough);
  }

  cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 1);
  results::Fields fields;
};

// Pressures that are distributed as (20) with G~ = 0.64 G have r = 0.64, and
// the drawn curve is that (20). Full contact, where (20) is a Gaussian and its
// quantiles are those of erf; p is 8 standard deviations.
TEST_F(Distributions, ShowTheFitAndItsRatioToTheory) {
  const double stress =
      synthetic::contact_modulus * result.surfaces[0].rms_slope;
  const double variance = 0.64 * stress * stress / 8.0;
  const double spread = std::sqrt(2.0 * variance);
  const double mean = 8.0 * spread;
  fields.nominal_pressure = mean;
  double quantile = -5.0; // integrated with the density: dz = dshare/density
  const auto n = static_cast<double>(fields.grid.size());
  for (double& pressure : fields.pressure) {
    const double share =
        (static_cast<double>(&pressure - fields.pressure.data()) + 0.5) / n;
    for (int newton = 0; newton < 60; ++newton)
      quantile -=
          std::clamp((0.5 * std::erfc(-quantile / std::sqrt(2.0)) - share) /
                         (0.3989 * std::exp(-0.5 * quantile * quantile)),
                     -0.5, 0.5);
    pressure = mean + spread * quantile;
  }

  const ReportEntry made = entry();
  const std::vector<Figure> figures =
      drawn(figures::pressure_distribution, made);

  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "pressure-distribution-fem");
  EXPECT_NE(figures[0].panels[0].curves[0].label.find("r = 0.64"),
            std::string::npos);
  for (const auto& [name, rows] : curves_of(figures[0])) {
    if (!name.starts_with("(20)"))
      continue;
    ASSERT_EQ(rows.size(), 161U);
    for (const auto& row : rows) // to one per cent of G, 2 % of the maximum
      EXPECT_NEAR(row[2] / stress,
                  theory::pressure_density(row[1] * stress, mean, variance),
                  0.02 / (spread * std::sqrt(6.28)));
  }
}

// P_u is that of the nodes without contact: u = 1 to 3 h_rms in equal parts on
// 60 % of the surface has the density 0.3/h_rms there. What is excluded is
// stated: nodes in contact, at zero gap or with penetration.
TEST_F(Distributions, OfGapsAreOfNodesWithoutContact) {
  const double height = result.surfaces[0].rms_height;
  const std::size_t apart = fields.gap.size() * 6 / 10;
  for (std::size_t i = 0; i < fields.gap.size(); ++i) {
    const bool is_apart = i < apart;
    fields.gap[i] =
        is_apart
            ? height * (1.0 + 2.0 * (static_cast<double>(i) + 0.5) / 6000.0)
            : (i % 2 == 0 ? 0.0 : -0.1 * height);
    fields.pressure[i] = is_apart ? 0.0 : 1e6;
  }

  const ReportEntry made = entry();
  const std::vector<Figure> figures = drawn(figures::gap_distribution, made);

  ASSERT_EQ(figures.size(), 1U);
  EXPECT_NE(figures[0].panels[0].curves[0].label.find("40 % in contact"),
            std::string::npos);
  for (const auto& [name, rows] : curves_of(figures[0]))
    for (const auto& row : rows)
      if (row[1] > 1.1) {
        EXPECT_NEAR(row[2], 0.3, 0.003); // one node more or less of 150 per bin
      }
}

// Maps are drawn on their own grid and measured in the surface of the method; a
// map whose size is not that of its grid is not drawn.
TEST_F(Distributions, AreDrawnOnTheirOwnGrid) {
  fields.pressure[5] = 1e6;
  fields.gap[7] = 1e-9;
  ReportEntry made = entry();

  ASSERT_EQ(drawn(figures::maps, made).size(), 1U);
  const Figure figure = drawn(figures::maps, made)[0];
  ASSERT_FALSE(figure.maps.empty());
  for (const auto& [name, text] : figure.maps)
    EXPECT_NE(text.find(",0.05,0.15,0.25,"), std::string::npos) << name;

  fields.pressure.pop_back();
  made = entry();
  EXPECT_TRUE(drawn(figures::maps, made).empty());
  EXPECT_TRUE(drawn(figures::pressure_distribution, made).empty());
}

// The browser's maps are named by their load and are in units of E* h'
// and h_rms. The factors are typed here.
TEST_F(Distributions, HaveTheirLoadAndTheirUnitsInTheBrowser) {
  const double modulus = synthetic::contact_modulus;
  fields.nominal_pressure = 0.02 * modulus;
  fields.pressure[5] = 3.0 * modulus * result.surfaces[0].rms_slope;
  fields.gap[7] = 2.0 * result.surfaces[0].rms_height;

  const std::vector<Figure> figures = drawn(figures::maps, entry());

  const MapFrame frame = figures.at(0).stack.value().frames.at(0);
  EXPECT_EQ(frame.title, "p/E* = 0.02");
  EXPECT_NEAR(frame.maps.at(0).high, 3.0, 1e-12);
  EXPECT_NEAR(frame.maps.at(2).high, 2.0, 1e-12);
}

// Under a tension few nodes press, and the theory has no such load.
TEST_F(Distributions, OfATensileMapAreNotDrawn) {
  fields.nominal_pressure = -1e6;
  fields.pressure.assign(fields.grid.size(), -1e6);
  fields.pressure[5] = 2e6;

  const ReportEntry made = entry();
  EXPECT_TRUE(drawn(figures::pressure_distribution, made).empty());
}

// The "fem" is the theory with 1.25 times its area, here fitted 1.5 times.
TEST_F(Distributions, OfAreasAreDrawnAgainstTheTheory) {
  for (results::CurvePoint& point : result.methods[1].realizations[0].points)
    point[columns::area_fraction_fit] =
        1.5 * synthetic::contact_of(rough.surface)
                  .area_fraction(point.nominal_pressure);
  const ReportEntry made = entry();

  const std::vector<Figure> found = drawn(figures::area_theory, made);

  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].caption.find("fem counted +25 %, by Eq. (21) +50 %"),
            std::string::npos);
  const auto curves = curves_of(found[0]);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves.at("fem").size(), 16U);
  for (const auto& row : curves.at("fem")) {
    EXPECT_NEAR(row[3], 1.5 * row[1], 1e-9);
    EXPECT_NEAR(row[5], 1.5, 1e-9);
  }

  result.methods.erase(result.methods.begin());
  const ReportEntry alone = entry_of(result, rough);
  EXPECT_TRUE(drawn(figures::area_theory, alone).empty());
}

} // namespace asperity::reports::distribution_figures_test
