// Tests of reports/numbers/determined.hpp: a fitted number without a meaning or
// without a meaningful interval is shown nowhere, but the reason is.
#include "reports/analysis/verdict.hpp"
#include "reports/numbers/determined.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::determined_test {

std::string why(double value, double half_width) {
  return why_undetermined(value, half_width, gamma_range);
}

// The ends of the range: (0, 1].
TEST(Determined, TakesNoGammaOutsideItsRange) {
  EXPECT_EQ(why(1.0, 0.1), "");
  EXPECT_EQ(why(1.0001, 0.1),
            "the fit gives 1, but only numbers above 0 and up to 1 have a "
            "meaning");
  EXPECT_NE(why(0.0, 0.0), "");
  EXPECT_NE(why(-1.3, 3.6).find("the fit gives -1.3"), std::string::npos);
  EXPECT_EQ(why(not_a_number, 0.1), "the fit gives no finite number");
}

// The interval is value - half_width to value + half_width: 2 half_width wide.
TEST(Determined, TakesNoIntervalWiderThanTheValue) {
  EXPECT_EQ(why(0.4, 0.2), "");
  EXPECT_EQ(why(0.4, 0.201), "the 95 % interval of the fit, 0.199 to 0.601, is "
                             "wider than the value");
  EXPECT_EQ(why(0.4, not_a_number), "the fit has no confidence interval");
}

TEST(Determined, LeavesNeitherValueNorIntervalOfWhatItIsNot) {
  Estimate wide;
  wide.value = 0.4;
  wide.half_width = 0.5;
  wide.realizations = 2;
  wide.remark = "Student's t over 2 realisations";
  Estimate set = wide;
  set.is_input = true;

  const Estimate none = determined(wide, gamma_range);

  EXPECT_FALSE(none.has_value());
  EXPECT_FALSE(none.has_interval());
  EXPECT_NE(none.remark.find("wider than the value"), std::string::npos);
  EXPECT_NE(none.remark.find("over 2 realisations"), std::string::npos);
  EXPECT_EQ(determined(set, gamma_range).value, 0.4);
}

/// A "fem" whose mean gap decreases by 1.3 h_rms per e-fold of the pressure,
/// around 1 h_rms: its slope is a straight line but not a gamma.
class NoGamma : public ReportFolder {
protected:
  NoGamma() {
    auto& points = result.methods[1].realizations[0].points;
    const double height = result.surfaces[0].rms_height;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].mean_gap =
          height * (1.0 - 1.3 * std::log(points[i].nominal_pressure /
                                         points[8].nominal_pressure));
    rough.expectations = {{"gamma_slope", 0.3, 0.5, {"fem"}}};
    result.reference = "quantity,value,unit,uncertainty,source\n"
                       "gamma_slope,0.4,1,0.05,Sec. 7\n";
  }

  results::Result result = synthetic::rough_result(rough, 1);
};

TEST_F(NoGamma, IsNotAResult) {
  const Summary summary = summarize(result, rough);
  const Estimate& gamma = summary.methods[1].quantities.at("gamma_slope");
  ASSERT_FALSE(gamma.has_value());

  const auto json = nlohmann::json::parse(summary_json(summary));
  const auto& quantity = json["methods"][1]["quantities"]["gamma_slope"];
  EXPECT_TRUE(quantity["value"].is_null());
  EXPECT_TRUE(quantity["half_width_95"].is_null());
  EXPECT_NE(quantity["remark"].get<std::string>().find("the fit gives 1.3"),
            std::string::npos);
  const auto& fit = json["methods"][1]["fits"][0]["slope"]["gamma_slope"];
  EXPECT_TRUE(fit["value"].is_null());
  EXPECT_FALSE(fit["reason"].get<std::string>().empty());
  EXPECT_EQ(check_line(summary.verdicts.front())
                .find("missing    fem            gamma_slope          not "
                      "determined"),
            0U)
      << check_line(summary.verdicts.front());
  EXPECT_NE(junit_xml({&summary, 1}).find("not determined"), std::string::npos);
  EXPECT_NE(published_line(summary.published.front())
                .find("fem not determined (the fit gives 1.3"),
            std::string::npos);
}

TEST_F(NoGamma, IsNotOnThePage) {
  write(result, "no-such-gnuplot");
  const std::string page = text_of(folder / "report.html");

  EXPECT_NE(page.find(">not determined<small>the fit gives 1.3, but only "
                      "numbers above 0 and up to 1 have a meaning"),
            std::string::npos);
  EXPECT_EQ(page.find(">1.3"), std::string::npos);
}

} // namespace asperity::reports::determined_test
