// Tests of reports/analysis/verdict.hpp: the verdicts, and that each output of
// them is well-formed. Golden tests where the format itself is documented.
#include "base/special_numbers.hpp"
#include "reports/analysis/verdict.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <pugixml.hpp>

namespace asperity::reports::verdict_test {

MethodSummary method_with(const std::string& name, double gamma) {
  MethodSummary method;
  method.name = name;
  method.kind = "fem";
  Estimate estimate;
  estimate.value = gamma;
  estimate.half_width = 0.02;
  estimate.realizations = 3;
  method.quantities["gamma_slope"] = estimate;
  Estimate none;
  none.remark = "the heights are not in the result";
  method.quantities["gamma_curve"] = none;
  return method;
}

cases::Expectation expect(const std::string& quantity, double low,
                          double high) {
  return {quantity, low, high, {"fem"}};
}

Verdict verdict_on(const cases::Expectation& expectation, double gamma) {
  const std::vector<MethodSummary> methods{method_with("fem", gamma)};
  return judge({&expectation, 1}, methods).front();
}

Verdict verdict_of(double gamma, double low, double high) {
  return verdict_on(expect("gamma_slope", low, high), gamma);
}

/// The band 0.35..0.45 for a number without an interval.
Outcome outcome_without_interval(double number) {
  MethodSummary method = method_with("fem", number);
  method.quantities["gamma_slope"].half_width = not_a_number;
  const cases::Expectation expectation = expect("gamma_slope", 0.35, 0.45);
  return judge({&expectation, 1}, {&method, 1}).front().outcome;
}

TEST(Judge, TakesTheEndsOfTheBandAndNothingBeyond) {
  EXPECT_EQ(outcome_without_interval(0.35), Outcome::ok);
  EXPECT_EQ(outcome_without_interval(0.45), Outcome::ok);
  EXPECT_EQ(outcome_without_interval(0.4501), Outcome::failed);
  EXPECT_EQ(outcome_without_interval(0.3499), Outcome::failed);
  EXPECT_EQ(verdict_of(0.5, -infinity, 0.6).outcome, Outcome::ok);
}

// What the interval of ± 0.02 leaves open is undecided, on either side of
// either end of 0.35..0.45.
TEST(Judge, LeavesUndecidedWhatReachesOverAnEnd) {
  EXPECT_EQ(verdict_of(0.431, 0.35, 0.45).outcome, Outcome::undecided);
  EXPECT_EQ(verdict_of(0.469, 0.35, 0.45).outcome, Outcome::undecided);
  EXPECT_EQ(verdict_of(0.369, 0.35, 0.45).outcome, Outcome::undecided);
  EXPECT_EQ(verdict_of(0.331, 0.35, 0.45).outcome, Outcome::undecided);
  EXPECT_EQ(verdict_of(0.429, 0.35, 0.45).outcome, Outcome::ok);
  EXPECT_EQ(verdict_of(0.471, 0.35, 0.45).outcome, Outcome::failed);
  EXPECT_EQ(verdict_of(0.461, -infinity, 0.45).outcome, Outcome::undecided);
  EXPECT_EQ(verdict_of(0.4, 0.39, 0.41).outcome, Outcome::undecided);
}

// Undecided does not pass unless the case says so.
TEST(Judge, PassesTheUndecidedOnlyWhereTheCaseDoes) {
  cases::Expectation strict = expect("gamma_slope", 0.35, 0.45);
  cases::Expectation lenient = strict;
  lenient.passes_if_undecided = true;
  Summary summary;

  summary.verdicts = {verdict_on(strict, 0.44)};
  EXPECT_FALSE(summary.all_ok());
  EXPECT_NE(junit_xml({&summary, 1}).find("failures=\"1\""), std::string::npos);
  EXPECT_EQ(check_line(summary.verdicts[0]),
            "undecided  fem            gamma_slope          0.44 ± 0.02 in "
            "0.35..0.45; its interval crosses a limit of the band: not passed");

  summary.verdicts = {verdict_on(lenient, 0.44)};
  EXPECT_TRUE(summary.all_ok());
  EXPECT_NE(junit_xml({&summary, 1}).find("failures=\"0\""), std::string::npos);
  EXPECT_NE(junit_xml({&summary, 1}).find("undecided"), std::string::npos);

  summary.verdicts = {verdict_on(lenient, 0.5)};
  EXPECT_FALSE(summary.all_ok());
}

// Without an expectation, or if none could be evaluated, nothing was checked.
TEST(Judge, ReportsThatNothingWasChecked) {
  Summary summary;
  EXPECT_NE(why_nothing_checked(summary).find("states no expectation"),
            std::string::npos);
  EXPECT_NE(junit_xml({&summary, 1}).find("skipped=\"1\""), std::string::npos);

  summary.verdicts = {verdict_of(0.4, 0.35, 0.45)};
  EXPECT_EQ(why_nothing_checked(summary), "");
  EXPECT_EQ(summary.n_judged(), 1);

  summary.verdicts[0].outcome = Outcome::skipped;
  EXPECT_NE(why_nothing_checked(summary).find("concern fem, which the result "
                                              "does not have"),
            std::string::npos);
}

// A run from which a method was excluded does not fail because of it; a run
// that was interrupted may.
TEST(Judge, SkipsAnExcludedMethod) {
  const std::vector<MethodSummary> methods{method_with("fem", 0.4)};
  std::vector<cases::Expectation> expectations{expect("gamma_slope", 0.0, 1.0)};
  expectations.front().methods = {"md"};
  Summary complete;
  Summary cut_short;

  complete.verdicts = judge(expectations, methods, true);
  cut_short.verdicts = judge(expectations, methods, false);

  EXPECT_EQ(complete.verdicts.front().outcome, Outcome::skipped);
  EXPECT_TRUE(complete.all_ok());
  EXPECT_FALSE(cut_short.all_ok());
  EXPECT_NE(junit_xml({&complete, 1}).find("<skipped"), std::string::npos);
}

TEST(Judge, CountsMissingNumbersWithTheReason) {
  const std::vector<MethodSummary> methods{method_with("fem", 0.4)};
  std::vector<cases::Expectation> expectations{
      expect("gamma_curve", 0.0, 1.0), expect("approach_error", 0.0, 1.0),
      expect("gamma_slope", 0.0, 1.0)};
  expectations.back().methods = {"md"};

  const std::vector<Verdict> verdicts = judge(expectations, methods);

  for (const Verdict& verdict : verdicts)
    EXPECT_EQ(verdict.outcome, Outcome::missing);
  EXPECT_EQ(verdicts[0].estimate.remark, "the heights are not in the result");
  EXPECT_EQ(verdicts[1].estimate.remark,
            "the method does not compute this quantity");
  EXPECT_EQ(verdicts[2].estimate.remark, "the method is not in the result");
}

TEST(CheckLine, HasTheDocumentedFormat) {
  EXPECT_EQ(check_line(verdict_of(0.4123, 0.35, 0.45)),
            "ok         fem            gamma_slope          0.4123 ± 0.02 in "
            "0.35..0.45");
  EXPECT_EQ(check_line(verdict_of(0.5, -infinity, 0.45)),
            "failed     fem            gamma_slope          0.5 ± 0.02 <= "
            "0.45");
}

Summary nasty_summary() {
  Summary summary;
  summary.case_name = "a<b>&\"c\"";
  summary.case_title = "bell \a and \xC3\xA4";
  summary.status = "complete";
  summary.provenance = {{"commit", "abc"}, {"dirty", "no"}};
  summary.methods = {method_with("fem", 0.5)};
  const std::vector<cases::Expectation> expectations{
      expect("gamma_slope", 0.35, 0.45), expect("gamma_slope", 0.4, 0.6),
      expect("gamma_curve", 0.3, 0.5)};
  summary.verdicts = judge(expectations, summary.methods);
  return summary;
}

// A strict parser reads it back, with names unchanged and counts correct.
TEST(JunitXml, IsWellFormedWhateverTheNames) {
  const std::vector<Summary> summaries{nasty_summary()};

  pugi::xml_document document;
  const auto outcome = document.load_string(junit_xml(summaries).c_str());

  ASSERT_TRUE(outcome) << outcome.description();
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_STREQ(suite.attribute("name").value(), "a<b>&\"c\"");
  EXPECT_EQ(suite.attribute("tests").as_int(), 3);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("errors").as_int(), 1);
  EXPECT_EQ(document.select_nodes("//testcase").size(), 3U);
  EXPECT_EQ(document.select_nodes("//failure[@message]").size(), 1U);
}

// Each test case has its value, its band and its part of the CPU time, and one
// without a value has no number.
TEST(JunitXml, CarriesValuesBandsAndTimes) {
  Summary summary = nasty_summary();
  summary.methods[0].cost.cpu_time = 6.0;

  pugi::xml_document document;
  document.load_string(junit_xml({&summary, 1}).c_str());

  const auto number = [&](int test, const std::string& name) {
    const std::string path = "//testcase[" + std::to_string(test) +
                             "]/properties/property[@name='" + name + "']";
    const auto found = document.select_node(path.c_str());
    return found ? found.node().attribute("value").as_double() : -1.0;
  };
  EXPECT_EQ(number(1, "value"), 0.5);
  EXPECT_EQ(number(1, "half_width_95"), 0.02);
  EXPECT_EQ(number(1, "low"), 0.35);
  EXPECT_EQ(number(1, "high"), 0.45);
  EXPECT_EQ(number(3, "value"), -1.0) << "a value that does not exist";
  EXPECT_EQ(number(3, "low"), 0.3);
  for (const auto& test : document.select_nodes("//testcase"))
    EXPECT_EQ(test.node().attribute("time").as_double(), 2.0);
  EXPECT_EQ(
      document.select_node("//testsuite").node().attribute("time").as_double(),
      6.0);
}

// The JSON can be parsed, a number that does not exist is null, and the
// documented names are there.
TEST(SummaryJson, HasNullForMissingNumbers) {
  const auto json = nlohmann::json::parse(summary_json(nasty_summary()));

  EXPECT_EQ(json["format"], "asperity-summary");
  EXPECT_EQ(json["all_ok"], false);
  EXPECT_EQ(json["expectations"][0]["verdict"], "failed");
  EXPECT_EQ(json["expectations"][1]["verdict"], "ok");
  EXPECT_TRUE(json["expectations"][2]["value"].is_null());
  EXPECT_EQ(json["methods"][0]["quantities"]["gamma_slope"]["value"], 0.5);
  EXPECT_EQ(json["provenance"]["commit"], "abc");
}

TEST(SummaryJson, GoldenOfAnEstimate) {
  const auto json =
      nlohmann::ordered_json::parse(summary_json(nasty_summary()));

  EXPECT_EQ(
      json["methods"][0]["quantities"]["gamma_slope"].dump(),
      R"({"value":0.5,"half_width_95":0.02,"realizations":3,"remark":""})");
}

TEST(Summary, IsNotOkWhileAnythingIsMissing) {
  Summary summary = nasty_summary();
  std::erase_if(summary.verdicts,
                [](const Verdict& v) { return v.outcome == Outcome::failed; });

  EXPECT_FALSE(summary.all_ok());
  std::erase_if(summary.verdicts,
                [](const Verdict& v) { return v.outcome == Outcome::missing; });
  EXPECT_TRUE(summary.all_ok());
}

} // namespace asperity::reports::verdict_test
