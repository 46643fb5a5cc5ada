// Verifies that the page lists what was skipped with reason and cost, shows an
// unknown number as a dash, and has no such section where nothing was skipped.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::skipped_test {

using SkippedSection = ReportFolder;

TEST_F(SkippedSection, IsOnThePageWhereSomethingWas) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.skipped = {
      {"fem: 16 <steps>", "in the cache", 90.0,
       std::numeric_limits<double>::quiet_NaN()},
      {"maps", "not kept", std::numeric_limits<double>::quiet_NaN(), 2.5e6}};
  write(result);

  const std::string html = text_of(folder / "report.html");

  EXPECT_NE(html.find("<h2>What was not computed"), std::string::npos);
  EXPECT_NE(html.find("<td>fem: 16 &lt;steps&gt;</td><td>in the cache</td>"
                      "<td class=\"number\">1.5 min</td>"
                      "<td class=\"number\">\u2013</td>"),
            std::string::npos);
  EXPECT_NE(html.find("<td class=\"number\">\u2013</td>"
                      "<td class=\"number\">2.5 MB</td>"),
            std::string::npos);
}

TEST_F(SkippedSection, IsAbsentWhereNothingWas) {
  write(synthetic::rough_result(rough, 1));

  EXPECT_EQ(text_of(folder / "report.html").find("What was not computed"),
            std::string::npos);
}

} // namespace asperity::reports::skipped_test
