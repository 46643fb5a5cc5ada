// Claim: where a whole block was solved the page shows what it cost beside the
// condensed one; where none was there is no such table.
#include <gtest/gtest.h>

#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports {
namespace {

using BlockCost = ReportFolder;

results::Result with_whole_block(results::Result result) {
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

TEST_F(BlockCost, StandsOnThePageOfAWholeBlock) {
  write(with_whole_block(synthetic::rough_result(rough, 1)));

  const std::string html = text_of(folder / "report.html");

  EXPECT_NE(html.find("What the whole block cost"), std::string::npos);
  for (const char* number : {">197568<", ">250 MB<", ">26<", ">3<"})
    EXPECT_NE(html.find(number), std::string::npos) << number;
}

TEST_F(BlockCost, IsNotThereWithoutOne) {
  write(synthetic::rough_result(rough, 1));

  EXPECT_EQ(text_of(folder / "report.html").find("What the whole block cost"),
            std::string::npos);
}

} // namespace
} // namespace asperity::reports
