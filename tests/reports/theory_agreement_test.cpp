// Tests of reports/pages/theory_agreement.hpp: a surface that the theory does
// not describe is named as such at the top of the report, with the numbers.
#include "reports/pages/report.hpp"
#include "reports/pages/theory_agreement.hpp"

#include <gtest/gtest.h>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::theory_agreement_test {

class TheoryAgreement : public ReportFolder {
protected:
  std::vector<results::CurvePoint>& rows() {
    return result.methods[1].realizations[0].points;
  }

  std::vector<std::string> sentences() const {
    return theory_disagreements(entry_of(result, rough));
  }

  results::Result result = synthetic::rough_result(rough, 1);
};

// The synthetic "fem" has 1.25 of the theory's area and 0.02 h_rms of its gap.
TEST_F(TheoryAgreement, HasNoWarningWhereTheTheoryHolds) {
  EXPECT_TRUE(sentences().empty());
}

TEST_F(TheoryAgreement, ReportsAnotherArea) {
  for (results::CurvePoint& row : rows())
    row.area_fraction_corrected = std::min(1.0, 10.0 * row.area_fraction);

  const auto said = sentences();

  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].find("The theory does not describe the contact area on "
                         "this surface: that of fem is "),
            0U)
      << said[0];
  EXPECT_NE(said[0].find("% of contact and fem "), std::string::npos);
  write(result, "no-such-gnuplot");
  EXPECT_NE(text_of(folder / "report.html")
                .find("<p class=\"notice\">The theory does not describe the "
                      "contact area"),
            std::string::npos);
}

TEST_F(TheoryAgreement, ReportsAnotherSeparation) {
  for (results::CurvePoint& row : rows())
    row.mean_gap += 0.3 * result.surfaces[0].rms_height;

  const auto said = sentences();

  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("describe the separation on this surface: that of "
                         "fem is up to 0.3"),
            std::string::npos)
      << said[0];
}

} // namespace asperity::reports::theory_agreement_test
