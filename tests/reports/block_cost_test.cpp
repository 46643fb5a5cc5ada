// Verifies that the page shows the cost of a full 3-D block beside that of the
// condensed one, and that there is no such table without a full block.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::block_cost_test {

using BlockCost = ReportFolder;

results::Result with_full_block(results::Result result) {
  for (results::MethodRecord& method : result.methods)
    if (method.kind == "fem")
      for (results::CurvePoint& point : method.realizations.front().points) {
        point.unknowns = 197568;
        point.memory = 250e6;
        point.linear_iterations = 26;
        point.preconditioner_setups = 3;
      }
  return result;
}

TEST_F(BlockCost, IsOnThePageOfAFullBlock) {
  write(with_full_block(synthetic::rough_result(rough, 1)));

  const std::string html = text_of(folder / "report.html");

  EXPECT_NE(html.find("Cost of the full 3-D model"), std::string::npos);
  for (const char* number : {">197568<", ">250 MB<", ">26<", ">3<"})
    EXPECT_NE(html.find(number), std::string::npos) << number;
}

/// The cells of the row of that name.
std::vector<std::string> row_of(const std::string& html,
                                const std::string& name) {
  std::size_t place = html.find("Cost of the full 3-D model");
  place = html.find("<tr><td>" + name + "</td>", place);
  const std::size_t end = html.find("</tr>", place);
  std::vector<std::string> cells;
  while ((place = html.find("<td", place)) < end) {
    place = html.find('>', place) + 1;
    cells.push_back(html.substr(place, html.find("</td>", place) - place));
  }
  return cells;
}

// Times and iterations are summed over realisations and steps and stated per
// step; set-up times are summed; methods without a full block are listed
// beside.
TEST_F(BlockCost, IsOfAllRealisationsBesideTheOthers) {
  results::Result result = synthetic::rough_result(rough, 2);
  results::MethodRecord whole = result.methods[1];
  whole.name = "fem.whole";
  for (results::Curve& curve : whole.realizations) {
    curve.setup_cpu_time = &curve == &whole.realizations[0] ? 1.0 : 3.0;
    int step = 0;
    for (results::CurvePoint& point : curve.points) {
      point.unknowns = 12345 + step;
      point.linear_iterations = 10 + step;
      point.preconditioner_setups = 2;
      point.iterations = 4;
      point.cpu_time = 1.0 + step++;
    }
  }
  results::MethodRecord half = result.methods[1];
  half.name = half.kind = "halfspace";
  result.methods.push_back(whole);
  result.methods.push_back(half);
  write(result);

  const std::string html = text_of(folder / "report.html");

  const std::vector<std::string> expected{
      "fem.whole", "12345 to 12360", "4 s", "4", "17.5", "2", "8.5 s", "–"};
  EXPECT_EQ(row_of(html, "fem.whole"), expected); // sixteen steps per curve
  for (const char* name : {"fem", "halfspace"}) {
    const std::vector<std::string> row = row_of(html, name);
    ASSERT_EQ(row.size(), expected.size()) << name;
    EXPECT_EQ(row[1], "contact surface only");
    EXPECT_EQ(row[4], "–");
  }
}

TEST_F(BlockCost, IsAbsentWithoutAFullBlock) {
  write(synthetic::rough_result(rough, 1));

  EXPECT_EQ(text_of(folder / "report.html").find("Cost of the full 3-D model"),
            std::string::npos);
}

} // namespace asperity::reports::block_cost_test
