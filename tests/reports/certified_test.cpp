// Tests of reports/analysis/certified.hpp and of its table.
#include "reports/analysis/certified.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::certified_test {

using CertifiedSteps = ReportFolder;

/// The finite elements of two realisations; step i of realisation r has the
/// bound (r + 1) (i + 1) 1e-6 h_rms, and the last one did not converge.
results::Result with_bounds(results::Result result) {
  for (std::size_t r = 0; r < 2; ++r) {
    double bound = 0.0;
    auto& points = result.methods[1].realizations[r].points;
    for (results::CurvePoint& point : points) {
      bound += static_cast<double>(r + 1) * 1e-6;
      point[columns::certified_gap_error] =
          bound * result.surfaces[r].rms_height;
    }
    points.back().status = results::StepStatus::not_converged;
    points.front().nominal_pressure = 0.0;
  }
  return result;
}

// The largest bound of all realisations is relative to their own rms height;
// steps that did not converge or have no load do not count.
TEST_F(CertifiedSteps, AreCountedWithTheLargestBound) {
  const results::Result result = with_bounds(synthetic::rough_result(rough, 2));
  const auto& points = result.methods[1].realizations[1].points;

  const Certified found = certified_of(result, result.methods[1]);

  const int steps = 2 * (static_cast<int>(points.size()) - 2);
  EXPECT_EQ(found.steps, steps);
  EXPECT_EQ(found.bounds.steps, steps);
  EXPECT_NEAR(found.bounds.largest,
              2e-6 * static_cast<double>(points.size() - 1), 1e-18);
  EXPECT_EQ(found.bounds.pressure, points[points.size() - 2].nominal_pressure);
}

// The largest estimate is counted likewise, and shown in columns of its own: a
// method that has estimates only is not "as submitted".
TEST_F(CertifiedSteps, EstimatesAreNoBounds) {
  results::Result result = synthetic::rough_result(rough, 1);
  std::vector<results::CurvePoint>& points =
      result.methods[1].realizations[0].points;
  points[1][columns::estimated_gap_error] =
      0.04 * result.surfaces[0].rms_height;
  points[2][columns::estimated_gap_error] =
      0.02 * result.surfaces[0].rms_height;

  const Certified found = certified_of(result, result.methods[1]);

  EXPECT_EQ(found.bounds.steps, 0);
  EXPECT_EQ(found.estimates.steps, 2);
  EXPECT_NEAR(found.estimates.largest, 0.04, 1e-12);
  EXPECT_EQ(found.estimates.pressure, points[1].nominal_pressure);
  write(result);
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find(fmt::format("<td class=\"number\">2 of {}</td>"
                                  "<td class=\"number\">4.0e-02</td>",
                                  points.size())),
            std::string::npos);
  EXPECT_EQ(html.find("as submitted"), std::string::npos);
  EXPECT_NE(text_of(folder / "summary.json")
                .find("\"largest_gap_error_estimate [h_rms]\": 0.04"),
            std::string::npos);
}

// A method without bounds is shown as submitted beside certified ones, and a
// result without any bound has no such table.
TEST_F(CertifiedSteps, AreInTheReport) {
  results::Result result = with_bounds(synthetic::rough_result(rough, 2));
  result.methods.push_back(result.methods[1]);
  result.methods.back().name = "foreign";
  for (results::Curve& curve : result.methods.back().realizations)
    for (results::CurvePoint& point : curve.points)
      point[columns::certified_gap_error] = results::not_given;
  EXPECT_EQ(certified_of(result, result.methods.back()).bounds.steps, 0);
  EXPECT_TRUE(
      std::isnan(certified_of(result, result.methods.back()).bounds.largest));
  write(result);
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("Errors of the mean gap"), std::string::npos);
  EXPECT_NE(html.find("<td>foreign</td><td class=\"number\">as submitted</td>"),
            std::string::npos);
  EXPECT_NE(html.find(">28 of 28<"), std::string::npos);
  EXPECT_NE(html.find(">3.0e-05<"), std::string::npos);
  EXPECT_NE(text_of(folder / "summary.json").find("\"certified_steps\": 28"),
            std::string::npos);

  write(synthetic::rough_result(rough, 1));
  EXPECT_EQ(text_of(folder / "report.html").find("Errors of the mean gap"),
            std::string::npos);
}

} // namespace asperity::reports::certified_test
