// Tests of the figure of the leak rate: each direction is a series, and sealed
// contacts are drawn and counted.
#include "reports/analysis/at_load.hpp"
#include "reports/figures/figures.hpp"
#include "studies/flow/flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::studies::flow_figure_test {

using namespace reports;

/// Rows of a step for each realisation: leak rates along x and along y.
using Leaks = std::vector<std::pair<double, double>>;

results::Result leaking(const std::vector<Leaks>& steps) {
  results::Result result;
  result.contact_modulus = 1e9;
  results::MethodRecord method{"halfspace", "halfspace", "", {}};
  method.realizations.resize(steps.front().size());
  for (std::size_t s = 0; s < steps.size(); ++s)
    for (std::size_t r = 0; r < steps[s].size(); ++r) {
      results::CurvePoint row;
      row.step = static_cast<int>(s);
      row.nominal_pressure = 1e6 * static_cast<double>(s + 1);
      row[columns::leak_rate.x] = steps[s][r].first;
      row[columns::leak_rate.y] = steps[s][r].second;
      method.realizations[r].points.push_back(row);
    }
  result.methods.push_back(std::move(method));
  return result;
}

Figure figure_of(const std::vector<Leaks>& steps) {
  const results::Result result = leaking(steps);
  cases::Case sealed;
  sealed.studies.ask(FlowStudy{});
  const ReportEntry entry{&result, &sealed, {}};
  return flow_pages().figures({{&entry, 1}}).at(0);
}

/// The fourth column, by curve and load.
std::map<std::pair<std::string, std::string>, double>
numbers_of(const Figure& figure) {
  std::map<std::pair<std::string, std::string>, double> numbers;
  std::istringstream rows(figure.data);
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    const std::size_t name_end = row.find('"', 1);
    std::istringstream words(row.substr(name_end + 2));
    std::string index, pressure, number;
    std::getline(words, index, ',');
    std::getline(words, pressure, ',');
    std::getline(words, number, ',');
    numbers[{row.substr(1, name_end - 1), pressure}] = std::stod(number);
  }
  return numbers;
}

// Grooves: sealed along x from the second load on. The rate falls with the
// load; the mean of the open directions would rise from 1e-14 to 1e-12.
TEST(LeakRateFigure, HasASeriesForEachDirection) {
  const Figure figure = figure_of({{{1e-16, 1e-12}}, {{0.0, 9e-13}}});

  const auto numbers = numbers_of(figure);

  EXPECT_EQ(numbers.at({"halfspace, Reynolds, along x", "1"}), 1e-16);
  EXPECT_EQ(numbers.at({"halfspace, Reynolds, along y", "1"}), 1e-12);
  EXPECT_EQ(numbers.at({"halfspace, Reynolds, along y", "2"}), 9e-13);
  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x", "2"}), 0U);
  // At the bottom axis, below the least rate.
  const double axis = figure.panels.front().y.low.value();
  EXPECT_LT(axis, 1e-16);
  EXPECT_EQ(numbers.at({"halfspace, Reynolds, along x, sealed", "2"}), axis);
  EXPECT_NE(figure.caption.find("1 of 2 of halfspace along x"),
            std::string::npos)
      << figure.caption;
  for (const ChartCurve& curve : figure.panels.front().curves)
    EXPECT_EQ(curve.style.marker == 2,
              curve.label.find("sealed") != std::string::npos)
        << curve.label;
}

// Of three realisations one is sealed, then two: the median counts them as 0.
TEST(LeakRateFigure, CountsSealedRealisationsAsZero) {
  const Figure figure = figure_of({{{1e-12, 1e-12}, {3e-12, 1e-12}, {0, 1e-12}},
                                   {{0, 1e-12}, {2e-12, 1e-12}, {0, 1e-12}}});

  const auto numbers = numbers_of(figure);

  EXPECT_EQ(numbers.at({"halfspace, Reynolds, along x", "1"}), 1e-12);
  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x", "2"}), 0U);
  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x, sealed", "1"}), 1U);
  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x, sealed", "2"}), 1U);
  EXPECT_NE(figure.caption.find("3 of 6 of halfspace along x"),
            std::string::npos)
      << figure.caption;
}

// A realisation whose step failed has no number: the others are no median.
TEST(LeakRateFigure, HasNoMedianOfTheOthers) {
  const Figure figure =
      figure_of({{{1e-12, 1e-12}, {3e-12, 1e-12}},
                 {{1e-13, 1e-13}, {std::nan(""), std::nan("")}}});

  const auto numbers = numbers_of(figure);

  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x", "1"}), 1U);
  EXPECT_EQ(numbers.count({"halfspace, Reynolds, along x", "2"}), 0U);
  EXPECT_EQ(figure.caption.find("sealed"), std::string::npos);
}

// The logarithm of the flow factor has no mean if one of two is sealed; that of
// the other alone would be one of a leaking surface.
TEST(FlowAtLoad, HasNoValueIfARealisationIsSealed) {
  results::Result result = leaking({{{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}});
  std::vector<results::Curve>& curves = result.methods.front().realizations;
  const double factors[2][2] = {{1e-2, 1e-4}, {0.0, 1e-4}};
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t r = 0; r < 2; ++r)
      curves[r].points[s][columns::flow_factor.x] =
          curves[r].points[s][columns::flow_factor.y] = factors[s][r];
  const std::string open = "log10_flow_factor@p=1e-3 E*";
  const std::string sealed = "log10_flow_factor@p=2e-3 E*";
  MethodSummary summary;
  cases::Case pressed; // without a formula of its scales
  pressed.surface.kind = mechanics::SurfaceKind::measured;

  add_quantities_at_load(result, pressed, result.methods.front(), nullptr,
                         std::vector{open, sealed}, summary);

  EXPECT_NEAR(summary.quantities.at(open).value, -3.0, 1e-12);
  EXPECT_FALSE(summary.quantities.at(sealed).has_value());
  EXPECT_EQ(summary.quantities.at(sealed).remark,
            "1 of 2 realisations are sealed at p/E* = 0.002 in a direction, "
            "where the leak rate is 0 and has no logarithm");
}

// The sentence of the report has the medians and the number of tight ones.
TEST(FlowAnswer, IsOfAllRealisations) {
  FlowStudy study;
  study.viscosity = 1e-3;
  study.pressure_drop = 1e4;
  cases::Case sealed;
  sealed.studies.ask(std::move(study));
  const auto answer = [&](const std::vector<Leaks>& steps) {
    const results::Result result = leaking(steps);
    return flow_pages().answer({&result, &sealed, {}});
  };

  EXPECT_EQ(answer({{{1e-12, 2e-12}}, {{0.0, 1e-12}}}),
            "A fluid of 1 mPa s at 10 kPa: tight along x from 2 MPa on (1e-12 "
            "m³/s at 1 MPa), 1e-12 m³/s along y at 2 MPa.");
  EXPECT_EQ(answer({{{0.0, 0.0}}}),
            "A fluid of 1 mPa s at 10 kPa: tight along x and y from 1 MPa on.");
  EXPECT_EQ(
      answer({{{0.0, 2e-12}, {1e-12, 4e-12}, {2e-12, 6e-12}},
              {{0.0, 1e-12}, {0.0, 2e-12}, {1e-13, 3e-12}}}),
      "A fluid of 1 mPa s at 10 kPa: tight along x from 2 MPa on, 2 of 3 "
      "realisations tight (1e-12 m³/s at 1 MPa, 1 of 3 realisations tight), "
      "2e-12 m³/s along y at 2 MPa, median of 3 realisations.");
}

// All are sealed at all loads: the figure says so.
TEST(LeakRateFigure, IsDrawnOfSealedContactsAlone) {
  const Figure figure = figure_of({{{0.0, 0.0}}});

  EXPECT_FALSE(figure.panels.front().y.is_log);
  EXPECT_EQ(
      numbers_of(figure).at({"halfspace, Reynolds, along x, sealed", "1"}),
      0.0);
}

} // namespace asperity::studies::flow_figure_test
