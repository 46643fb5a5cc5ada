// Tests of reports/pages/agreement.hpp: a result of another program, compared
// with ours, has a number for each difference, in the page and in both files.
#include "reports/pages/agreement.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::agreement_test {

constexpr double shift = 0.03;  // of the foreign mean gap, in h_rms
constexpr double excess = 0.01; // of the foreign area and pressure

class AgreementOfTwo : public ReportFolder {
protected:
  AgreementOfTwo() : ours(synthetic::rough_result(rough, 2)), theirs(ours) {
    theirs.case_text.clear(); // as in a file of another program
    results::MethodRecord foreign = ours.methods[1];
    foreign.name = "mybem";
    foreign.kind = "bem";
    for (std::size_t r = 0; r < foreign.realizations.size(); ++r) {
      results::Curve& curve = foreign.realizations[r];
      for (results::CurvePoint& point : curve.points) {
        point.mean_gap += shift * ours.surfaces[r].rms_height;
        point.area_fraction *= 1.0 + excess;
        point[columns::certified_gap_error] =
            1e-3 * ours.surfaces[r].rms_height;
      }
      for (results::Fields& fields : curve.fields)
        for (double& pressure : fields.pressure)
          pressure *= 1.0 + excess;
    }
    theirs.methods = {foreign};
  }

  std::vector<Agreement> agreements() {
    cases = {rough, case_of(theirs)};
    entries = {entry_of(ours, cases[0]), entry_of(theirs, cases[1])};
    const std::vector<Series> series = series_of(entries);
    return agreements_of(entries, series);
  }

  results::Result ours;
  results::Result theirs;
  std::vector<cases::Case> cases;
  std::vector<ReportEntry> entries;
};

// For a method that is ours except for known changes, the differences are these
// changes, at every load of each realisation. Tolerance: roundoff.
TEST_F(AgreementOfTwo, IsMeasured) {
  const std::vector<Agreement> found = agreements();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].problem, "");
  EXPECT_NE(found[0].method.find("mybem"), std::string::npos);
  const std::size_t loads = ours.methods[1].realizations[0].points.size();
  ASSERT_EQ(found[0].rows.size(), 2 * loads);
  int fields = 0;
  for (const AgreementRow& row : found[0].rows) {
    EXPECT_NEAR(row.gap_difference, shift, 1e-9);
    EXPECT_NEAR(row.area_difference, excess, 1e-9);
    EXPECT_NEAR(row.certified_error, 1e-3, 1e-12);
    if (std::isfinite(row.pressure_difference)) {
      EXPECT_NEAR(row.pressure_difference, excess, 1e-9);
      ++fields;
    }
  }
  EXPECT_EQ(fields,
            static_cast<int>(ours.methods[1].realizations[0].fields.size() +
                             ours.methods[1].realizations[1].fields.size()));
  EXPECT_GT(fields, 0);
}

// Page, JSON and CSV contain them; the deviation from the theory is drawn with
// the theory of our result, and the difference of the maps is a figure.
TEST_F(AgreementOfTwo, IsShown) {
  agreements();
  EXPECT_TRUE(write_report(entries, folder).empty());
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("Agreement of the methods"), std::string::npos);
  EXPECT_NE(html.find(">3.0e-02<"), std::string::npos);
  EXPECT_NE(html.find(">1.0e-02<"), std::string::npos);
  EXPECT_NE(html.find("less that of fem"), std::string::npos);
  EXPECT_NE(text_of(folder / "figures/gap-deviation.csv").find("mybem"),
            std::string::npos);
  EXPECT_NE(text_of(folder / "comparison.json")
                .find("\"gap_difference [h_rms]\": 0.0"),
            std::string::npos);
  EXPECT_NE(text_of(folder / "comparison.csv").find("mybem"),
            std::string::npos);
}

// Results of runs that were interrupted before the first step of any method
// have a report, alone and together, without a comparison.
TEST_F(AgreementOfTwo, IsNoneOfRunsWithoutSteps) {
  for (results::Result* result : {&ours, &theirs})
    for (results::MethodRecord& method : result->methods)
      method.realizations.clear();
  write(ours);
  EXPECT_NE(text_of(folder / "report.html").find("</html>"), std::string::npos);
  for (const Agreement& agreement : agreements())
    EXPECT_TRUE(agreement.rows.empty());
  write_report(entries, folder);
  EXPECT_NE(text_of(folder / "report.html").find("</html>"), std::string::npos);
  EXPECT_EQ(text_of(folder / "comparison.json"), "[]\n");
}

// What cannot be compared is named and has no number.
TEST_F(AgreementOfTwo, IsRefusedWithAReason) {
  theirs.contact_modulus *= 2.0;
  EXPECT_EQ(agreements().at(0).problem, "another E*");
  theirs.contact_modulus = ours.contact_modulus;
  for (results::SurfaceRecord& surface : theirs.surfaces)
    surface.rms_height *= 1.1;
  EXPECT_EQ(agreements().at(0).problem, "another surface");
  theirs.surfaces.clear();
  EXPECT_EQ(agreements().at(0).problem, "no surface is recorded");
  EXPECT_TRUE(
      std::isnan(agreements().at(0).largest(&AgreementRow::gap_difference)));
  theirs.surfaces = ours.surfaces;
  for (results::Curve& curve : theirs.methods[0].realizations)
    for (results::CurvePoint& point : curve.points)
      point.nominal_pressure *= 1e6;
  EXPECT_EQ(agreements().at(0).problem,
            "no load lies within the loads of the reference");
}

} // namespace asperity::reports::agreement_test
