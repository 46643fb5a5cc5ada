// Verifies that the page lists what was skipped with the reason, and has no
// such section where nothing was skipped.
#include <gtest/gtest.h>

#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::skipped_test {

using SkippedSection = ReportFolder;

TEST_F(SkippedSection, IsOnThePageWhereSomethingWas) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.skipped = {{"fem: 16 <steps>", "in the cache"}};
  write(result);

  const std::string html = text_of(folder / "report.html");

  EXPECT_NE(html.find("<h2>What was not computed"), std::string::npos);
  EXPECT_NE(
      html.find("<td>fem: 16 &lt;steps&gt;</td><td>in the cache</td></tr>"),
      std::string::npos);
}

TEST_F(SkippedSection, IsAbsentWhereNothingWas) {
  write(synthetic::rough_result(rough, 1));

  EXPECT_EQ(text_of(folder / "report.html").find("What was not computed"),
            std::string::npos);
}

} // namespace asperity::reports::skipped_test
