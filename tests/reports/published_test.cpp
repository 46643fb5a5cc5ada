// Tests of published values: each is compared with ours wherever a method has a
// quantity of its name, and is reported to have no counterpart where none has.
#include "input/input_error.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <pugixml.hpp>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::published_test {

const std::string reference = "quantity,value,unit,uncertainty,source\n"
                              "gamma_slope,0.4,1,0.05,\"A & B 2008, p. 3\"\n"
                              "area_excess,0.29,1,0.005,C 2005\n"
                              "height,14e-9,m,5e-10,A\n"
                              "kappa_limit,1.5,1,0,a formula\n";

class Published : public ReportFolder {
protected:
  Published() { result.reference = reference; }

  results::Result result = synthetic::rough_result(rough, 2);
};

// The theory is not compared with itself: area_excess is that of the "fem"
// alone.
TEST_F(Published, AreListedBesideTheMethods) {
  const Summary summary = summarize(result, rough);

  ASSERT_EQ(summary.published.size(), 4U);
  ASSERT_EQ(summary.published[0].ours.size(), 2U);
  EXPECT_EQ(summary.published[0].ours[0].method, "theory");
  EXPECT_EQ(summary.published[0].ours[1].method, "fem");
  EXPECT_EQ(summary.published[0].ours[1].estimate.value,
            summary.methods[1].quantities.at("gamma_slope").value);
  ASSERT_EQ(summary.published[1].ours.size(), 1U);
  EXPECT_EQ(summary.published[1].ours[0].method, "fem");
  EXPECT_TRUE(summary.published[2].ours.empty());
}

// Published values have no effect on verdicts.
TEST_F(Published, ChangeNoVerdict) {
  const Summary with = summarize(result, rough);
  result.reference.clear();
  const Summary without = summarize(result, rough);

  ASSERT_EQ(with.verdicts.size(), without.verdicts.size());
  for (std::size_t i = 0; i < with.verdicts.size(); ++i)
    EXPECT_EQ(with.verdicts[i].outcome, without.verdicts[i].outcome);
  EXPECT_TRUE(without.published.empty());
}

TEST_F(Published, OfAForeignFileAreRefusedWithTheirLine) {
  result.path = "theirs.h5";
  result.reference += "kappa,high,1,0,D\n";

  try {
    summarize(result, rough);
    FAIL() << "a word was taken for a number";
  } catch (const input::InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("theirs.h5: reference:6: value = high"),
        std::string::npos)
        << error.what();
  }
}

OurValue ours(const std::string& method, double number) {
  OurValue one{method, {}};
  one.estimate.value = number;
  one.estimate.remark = "no row";
  return one;
}

TEST(PublishedLine, HasTheDocumentedFormat) {
  EXPECT_EQ(published_line({{"gamma_slope", 0.4, "1", 0.05, "A"},
                            {ours("fem", 0.4461), ours("theory", 0.448)}}),
            "paper      gamma_slope          0.4 ± 0.05: fem 0.4461, theory "
            "0.448");
  EXPECT_EQ(published_line({{"approach", 2.5e-7, "m", 0.0, "A"},
                            {ours("fem", not_a_number)}}),
            "exact      approach             250 nm: fem not determined (no "
            "row)");
  EXPECT_EQ(published_line({{"height", 14e-9, "m", 5e-10, "A"}, {}}),
            "paper      height               14.00 ± 0.50 nm: not computed");
}

// A program finds the verdict of every method in the words of the page, the
// best of them beside the number, why there is none, and the line of the
// terminal.
TEST_F(Published, HaveVerdictsForPrograms) {
  result.reference = "quantity,value,unit,uncertainty,source,why\n"
                     "gamma_slope,0.4,1,0.5,A,\n"
                     "area_excess,0.5,1,0.01,B,\n"
                     "height,14e-9,m,5e-10,C,never stated\n"
                     "gamma_curve,0.38,1,0.1,D,\n"; // an input of the theory

  const Summary summary = summarize(result, rough);
  const auto json = nlohmann::json::parse(summary_json(summary))["published"];

  ASSERT_EQ(json.size(), 4U);
  EXPECT_EQ(json[0]["quantity"], "gamma_slope");
  EXPECT_EQ(json[0]["value"], 0.4);
  EXPECT_EQ(json[0]["uncertainty"], 0.5);
  EXPECT_EQ(json[0]["source"], "A");
  EXPECT_EQ(json[0]["verdict"], "reproduced");
  EXPECT_EQ(json[0]["ours"][1]["method"], "fem");
  EXPECT_TRUE(json[0]["ours"][1]["value"].is_number());
  EXPECT_EQ(json[0]["ours"][1]["verdict"], "reproduced");
  EXPECT_EQ(json[0]["why"], "");
  EXPECT_EQ(json[0]["line"], published_line(summary.published[0]));
  // the synthetic 0.25 differs from 0.5 by half of it
  EXPECT_EQ(json[1]["verdict"], "differs");
  EXPECT_EQ(json[1]["ours"][0]["words"], "differs by 50 %");
  EXPECT_EQ(json[2]["verdict"], "not_reproducible");
  EXPECT_EQ(json[2]["why"], "never stated");
  EXPECT_EQ(json[2]["unit"], "m");
  EXPECT_TRUE(json[2]["ours"].empty());
  EXPECT_EQ(json[3]["ours"][0]["verdict"], "input");
  EXPECT_EQ(json[3]["ours"][1]["verdict"], "reproduced");
  EXPECT_EQ(json[3]["verdict"], "reproduced");
}

// The page has one row per value with its source below, and states where none
// of our methods has a counterpart.
TEST_F(Published, AreOnThePage) {
  write(result, "no-such-gnuplot");
  pugi::xml_document page;
  page.load_string(text_of(folder / "report.html").c_str());
  const auto cell = [&](int row, int column) {
    return std::string(page.select_node(("//table[@class='published']//tr[@"
                                         "class='first'][" +
                                         std::to_string(row) + "]/td[" +
                                         std::to_string(column) + "]")
                                            .c_str())
                           .node()
                           .text()
                           .get());
  };

  EXPECT_EQ(cell(1, 1), "gamma_slope");
  EXPECT_EQ(cell(1, 2), "0.4 ± 0.05");
  EXPECT_EQ(cell(1, 3).rfind("0.4", 0), 0U) << cell(1, 3);
  EXPECT_EQ(cell(2, 3), "–"); // the theory
  EXPECT_EQ(cell(3, 2), "14.00 ± 0.50 nm");
  EXPECT_EQ(page.select_nodes("//td[@colspan='2']/small").size(), 2U);
  EXPECT_STREQ(
      page.select_node("//table[@class='published']//tr[@class='second']/td")
          .node()
          .text()
          .get(),
      "A & B 2008, p. 3");
}

} // namespace asperity::reports::published_test
