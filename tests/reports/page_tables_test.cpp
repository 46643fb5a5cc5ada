// Tests of the tables that only some results have: cost of a full 3-D block
// beside the condensed one, stiffness and centre of pressure, what was skipped.
// They are on the page and in summary.json, and nowhere without a cause.
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::page_tables_test {

/// The cells of the row of that name behind a heading.
std::vector<std::string> row_of(const std::string& html,
                                const std::string& heading,
                                const std::string& name) {
  std::size_t place = html.find(heading);
  place = html.find("<tr><td>" + name + "</td>", place);
  const std::size_t end = html.find("</tr>", place);
  std::vector<std::string> cells;
  while ((place = html.find("<td", place)) < end) {
    place = html.find('>', place) + 1;
    cells.push_back(html.substr(place, html.find("</td>", place) - place));
  }
  return cells;
}

using PageTables = ReportFolder;

// Times and iterations are summed over realisations and steps and stated per
// step; set-up times are summed; methods without a full block are listed
// beside.
TEST_F(PageTables, HaveTheCostOfAllRealisationsOfABlock) {
  results::Result result = synthetic::rough_result(rough, 2);
  results::MethodRecord whole = result.methods[1];
  whole.name = "fem.whole";
  for (results::Curve& curve : whole.realizations) {
    curve.setup_cpu_time = &curve == &whole.realizations[0] ? 1.0 : 3.0;
    int step = 0;
    for (results::CurvePoint& point : curve.points) {
      point[columns::unknowns] = 12345 + step;
      point[columns::memory] = 250e6;
      point[columns::linear_iterations] = 10 + step;
      point[columns::preconditioner_setups] = 2;
      point.iterations = 4;
      point.cpu_time = 1.0 + step++;
    }
  }
  results::MethodRecord half = result.methods[1];
  half.name = half.kind = "halfspace";
  result.methods.push_back(whole);
  result.methods.push_back(half);
  write(result, "no-such-gnuplot");

  const std::string html = text_of(folder / "report.html");
  const std::string heading = "Cost of the full 3-D model";
  const std::vector<std::string> expected{"fem.whole", "12345 to 12360", "4 s",
                                          "4",         "17.5",           "2",
                                          "8.5 s",     "250 MB"};
  EXPECT_EQ(row_of(html, heading, "fem.whole"), expected); // 16 steps a curve
  for (const char* name : {"fem", "halfspace"}) {
    const std::vector<std::string> row = row_of(html, heading, name);
    ASSERT_EQ(row.size(), expected.size()) << name;
    EXPECT_EQ(row[1], "contact surface only");
    EXPECT_EQ(row[4], "–");
  }
  const auto json =
      nlohmann::json::parse(text_of(folder / "summary.json"))["block_costs"];
  EXPECT_EQ(json[1]["unknowns"], 12360.0);
  EXPECT_TRUE(json[0]["unknowns"].is_null());
}

// A lever that is roundoff of the side is 0.
TEST_F(PageTables, HaveStiffnessAndWhatWasSkipped) {
  results::Result result = synthetic::rough_result(rough, 1);
  results::CurvePoint& point =
      result.methods[1].realizations.front().points.front();
  point[columns::normal_stiffness] = 2e5;
  point[columns::tangential_stiffness] = 1.5e5;
  point[columns::pressure_centre.x] = 3e-8;
  point[columns::pressure_centre.y] = 1e-22;
  result.skipped = {{"fem: 16 <steps>", "in the cache"}};
  write(result, "no-such-gnuplot");

  const std::string html = text_of(folder / "report.html");

  EXPECT_EQ(row_of(html, "Stiffness and centre of the contact", "fem"),
            (std::vector<std::string>{"fem", "0.0001", "200 000", "150 000",
                                      "0.75", "0.03", "0"}));
  EXPECT_EQ(
      row_of(html, "<h2>What was not computed", "fem: 16 &lt;steps&gt;"),
      (std::vector<std::string>{"fem: 16 &lt;steps&gt;", "in the cache"}));
}

// A surface method has the stiffness of a standing contact, of no block.
TEST_F(PageTables, AreAbsentWithoutACause) {
  results::Result result = synthetic::rough_result(rough, 1);
  for (results::MethodRecord& method : result.methods)
    for (results::CurvePoint& point : method.realizations.front().points)
      point[columns::pressure_centre.x] = point[columns::pressure_centre.y] =
          0.0;
  result.methods[1]
      .realizations.front()
      .points.front()[columns::normal_stiffness] = 2e5;
  write(result, "no-such-gnuplot");

  const std::string html = text_of(folder / "report.html");
  for (const char* heading :
       {"Cost of the full 3-D model", "Stiffness and centre of the contact",
        "What was not computed"})
    EXPECT_EQ(html.find(heading), std::string::npos) << heading;
}

} // namespace asperity::reports::page_tables_test
