// What a user asked is answered in sentences, the same on the page, on the
// terminal and in summary.json, with intervals that hold what they say.
#include "base/shown_number.hpp"
#include "reports/pages/answers.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::answers_test {

class Answers : public ReportFolder {
protected:
  pugi::xml_document page() const {
    pugi::xml_document document;
    document.load_string(text_of(folder / "report.html").c_str());
    return document;
  }

  nlohmann::json summary() const {
    return nlohmann::json::parse(text_of(folder / "summary.json"));
  }

  results::Result result = synthetic::rough_result(rough, 1);
};

TEST_F(Answers, AreTheSameOnThePageAndInTheSummary) {
  write(result);
  const nlohmann::json answers = summary()["answers"];
  ASSERT_FALSE(answers.empty());
  std::string words;
  for (const nlohmann::json& answer : answers)
    words += answer.get<std::string>() + " ";
  std::string shown;
  const auto document = page();
  for (const auto& paragraph : document.select_nodes("//p[@class='answer']"))
    shown += paragraph.node().text().get() + std::string(" ");
  EXPECT_EQ(shown, words);
  EXPECT_EQ(words.rfind("At ", 0), 0U) << words;
  EXPECT_NE(words.find("of the area touches and the mean gap is"),
            std::string::npos);
}

// The half-width of the area is the correction of the counted area, and that of
// the gap its certified bound.
TEST_F(Answers, HaveIntervalsFromTheGridAndTheCertificate) {
  results::MethodRecord& method = result.methods.back();
  ASSERT_NE(method.kind, "theory");
  results::CurvePoint& row = method.realizations.front().points[3];
  row[columns::certified_gap_error] = 2e-9;
  const AskedIntervals intervals(result, rough, method);
  EXPECT_DOUBLE_EQ(intervals.of(row).area,
                   std::abs(row.area_fraction - row.area_fraction_corrected));
  EXPECT_GT(intervals.of(row).area, 0.0);
  EXPECT_DOUBLE_EQ(intervals.of(row).gap, 2e-9);
  EXPECT_EQ(parts_sentence(intervals.parts()),
            "The intervals contain: grid of the area, solver.");
}

// Of a map, the short waves count, and what is not known is said.
TEST_F(Answers, HaveIntervalsFromTheShortWavesOfAMap) {
  rough.surface.kind = mechanics::SurfaceKind::measured;
  const results::MethodRecord& method = result.methods.back();
  const AskedIntervals intervals(result, rough, method);
  const std::string words = parts_sentence(intervals.parts());
  EXPECT_NE(words.find("short waves"), std::string::npos);
  EXPECT_NE(words.find("; not: level and form, place and size of the map"),
            std::string::npos)
      << words;
  const results::CurvePoint& row = method.realizations.front().points[3];
  const double grid = std::abs(row.area_fraction - row.area_fraction_corrected);
  EXPECT_GT(intervals.of(row).area, 1.02 * grid);
  EXPECT_LT(intervals.of(row).area - grid, 0.5 * row.area_fraction);
}

// An octave that is missing takes area away where nothing is left to add, and
// changes a gap that the theory does not have in proportion.
TEST_F(Answers, HaveIntervalsFromTheShortWavesNearFullContact) {
  rough.surface.kind = mechanics::SurfaceKind::measured;
  const AskedIntervals intervals(result, rough, result.methods.back());
  results::CurvePoint row =
      result.methods.back().realizations.front().points[3];
  row.area_fraction = row.area_fraction_corrected = 0.95;
  const auto gap_error = [&](double mean_gap) {
    row.mean_gap = mean_gap;
    return intervals.of(row).gap;
  };

  EXPECT_GT(intervals.of(row).area, 0.05);
  EXPECT_GT(gap_error(0.0), 0.0);
  EXPECT_EQ(gap_error(0.0), gap_error(1e-15));
  EXPECT_NEAR(gap_error(2e-6) / gap_error(1e-6), 2.0, 1e-12);
}

// Where a node has yielded, the area is not corrected, but it is counted.
TEST_F(Answers, SayTheCountedAreaWhereNoneIsCorrected) {
  for (results::MethodRecord& method : result.methods)
    for (results::Curve& curve : method.realizations)
      for (std::size_t i = 1; i < curve.points.size(); ++i)
        curve.points[i].area_fraction_corrected =
            std::numeric_limits<double>::quiet_NaN();
  write(result);
  const nlohmann::json answers = summary()["answers"];
  ASSERT_FALSE(answers.empty());
  for (const nlohmann::json& answer : answers)
    EXPECT_EQ(answer.get<std::string>().find("–"), std::string::npos) << answer;
}

// In complete contact the gap of the continuum is smaller than atoms.
TEST_F(Answers, KnowNoGapBelowAPicometre) {
  results::MethodRecord& method = result.methods.back();
  for (results::CurvePoint& row : method.realizations.front().points)
    row.mean_gap = 3e-14;
  write(result);
  const std::string answer = summary()["answers"][0];
  EXPECT_NE(answer.find("the mean gap is below 0.001 nm;"), std::string::npos)
      << answer;
}

// Gaps without contact have no intervals that could contain something.
TEST_F(Answers, SayThatNothingTouches) {
  results::MethodRecord& method = result.methods.back();
  double smallest = std::numeric_limits<double>::infinity();
  for (results::CurvePoint& row : method.realizations.front().points) {
    row.nominal_pressure = row.area_fraction = 0.0;
    smallest = std::min(smallest, row.mean_gap);
  }
  write(result);
  EXPECT_EQ(summary()["answers"][0], "Nothing touches down to a mean gap of " +
                                         quantity_text(smallest, "m", 3) + ".");
  EXPECT_EQ(text_of(folder / "report.html").find("The intervals contain"),
            std::string::npos);
}

TEST_F(Answers, StandWithoutVerdictsIfThereIsNoExpectation) {
  rough.expectations.clear();
  result.case_text = "";
  write(result);
  EXPECT_TRUE(page().select_nodes("//p[contains(@class, 'banner')]").empty());
  EXPECT_FALSE(
      page().select_nodes("//details[@id='constants']//table").empty());
  EXPECT_EQ(text_of(folder / "report.html").find("no expectations"),
            std::string::npos);
}

} // namespace asperity::reports::answers_test
