// Tests of reports/analysis/theory_agreement.hpp: a load at which the theory
// does not describe a method is named at the top of the report, in summary.json
// and on the terminal, with the numbers and the assumption that is violated.
#include "reports/analysis/theory_agreement.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::theory_agreement_test {

class TheoryAgreement : public ReportFolder {
protected:
  std::vector<results::CurvePoint>& rows() {
    return result.methods[1].realizations[0].points;
  }

  std::vector<Warning> said() const { return warnings_of(result, rough); }

  results::Result result = synthetic::rough_result(rough, 1);
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The synthetic "fem" has 1.25 of the theory's area and 0.02 h_rms of its gap.
TEST_F(TheoryAgreement, HasNoWarningWhereTheTheoryHolds) {
  EXPECT_TRUE(said().empty());
}

// One load of 16 differs, which a factor over all loads does not show.
TEST_F(TheoryAgreement, ReportsAnotherAreaAtOneLoad) {
  results::CurvePoint& row = rows()[6];
  row.area_fraction_corrected =
      10.0 * result.methods[0].realizations[0].points[6].area_fraction;

  ASSERT_EQ(said().size(), 1U);
  const Warning warning = said()[0];
  EXPECT_EQ(warning.kind, "theory_area");
  EXPECT_TRUE(has(warning.headline, "The contact area of fem is 10 times the "
                                    "theory's at p = "))
      << warning.headline;
  EXPECT_TRUE(has(warning.headline, "at 1 of 16 loads")) << warning.headline;
  write(result, "no-such-gnuplot");
  for (const char* file : {"report.html", "summary.json"})
    EXPECT_TRUE(has(text_of(folder / file), "The contact area of fem is 10 "
                                            "times the theory"))
        << file;
  EXPECT_TRUE(has(warning_lines(result, rough), warning.line));
}

TEST_F(TheoryAgreement, ReportsAnotherSeparation) {
  for (results::CurvePoint& row : rows())
    row.mean_gap += 0.3 * result.surfaces[0].rms_height;

  ASSERT_EQ(said().size(), 1U);
  EXPECT_EQ(said()[0].kind, "theory_gap");
  EXPECT_TRUE(has(said()[0].headline, "differs from the theory's by 0.3"))
      << said()[0].headline;
  EXPECT_TRUE(has(said()[0].consequence, "None of the assumptions"))
      << said()[0].consequence;
}

TEST_F(TheoryAgreement, NamesTheCause) {
  for (results::CurvePoint& row : rows())
    row.mean_gap += 0.3 * result.surfaces[0].rms_height;
  rough.methods = {{"fem", mechanics::FemSettings{}}};
  rough.material.layers = {{{1e-7, {}}, {2e10, 0.3}}};
  EXPECT_TRUE(has(said()[0].consequence, "below the layers"))
      << said()[0].consequence;
  EXPECT_FALSE(has(said()[0].consequence, "surface"));

  rough.material.layers.clear();
  mechanics::HalfspaceSettings slab;
  slab.thickness = mechanics::Quantity{1e-6, {}};
  rough.methods = {{"fem", slab}};
  EXPECT_TRUE(has(said()[0].consequence, "a finite thickness"))
      << said()[0].consequence;

  for (results::SurfaceRecord& surface : result.surfaces)
    surface.skewness = -2.0;
  ASSERT_EQ(said().size(), 2U);
  EXPECT_TRUE(has(said()[1].consequence, "Gaussian heights"))
      << said()[1].consequence;
}

} // namespace asperity::reports::theory_agreement_test
