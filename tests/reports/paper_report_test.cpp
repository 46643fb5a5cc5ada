// Tests of the report on a collection: every published number has its verdict
// in each part; a series of parts is one section; pages link to each other.
#include "reports/pages/paper_report.hpp"
#include "reports/pages/readme_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::paper_report_test {

namespace fs = std::filesystem;

const std::string readme = "# part\n\n**Claim.** The gap & the\nload.\n\n"
                           "**Figures.** 1 and 2: all & more.\n\nMore.\n";
const std::vector<std::string> figures = {"pressure-gap", "spectrum"};

std::ptrdiff_t count(const std::string& text, const std::string& word) {
  std::ptrdiff_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1))
    ++n;
  return n;
}

class PaperReport : public ReportFolder {
protected:
  PaperReport() {
    one.reference = "quantity,value,unit,uncertainty,source,why\n"
                    "epsilon,5.4968,1,0.00005,Sec. 3,\n"
                    "area_excess,0.29,1,0.005,Sec. 7,\n"
                    "rms_height,14e-9,m,5e-10,Fig. 12,never stated\n"
                    "flip,0.9,1,0.05,Sec. 9,\n"
                    "gamma_slope,0.4,1,0.5,Sec. 7,\n";
    two = one;
    two.reference = "";
    two.status = "interrupted";
  }

  /// Writes the report of each part where it is requested, then that on all.
  std::string page_of(const std::vector<std::string>& names,
                      const std::string& title = "",
                      bool is_part_drawn = false) {
    rough.title += title;
    one.case_title = two.case_title = rough.title;
    std::vector<PaperPart> parts;
    for (const std::string& name : names) {
      const results::Result& result = parts.empty() ? one : two;
      const ReportEntry entry = entry_of(result, rough);
      if (is_part_drawn)
        write_report(std::span(&entry, 1), folder / name);
      parts.push_back({name, folder / name, readme, figures, entry});
    }
    problems =
        write_paper_report(parts, "# Someone <paper>\n\nAll of it.\n", folder);
    return text_of(folder / "report.html");
  }

  results::Result one = synthetic::rough_result(rough, 2);
  results::Result two;
  std::vector<std::string> problems;
};

TEST_F(PaperReport, HasAVerdictForEveryPublishedNumber) {
  const std::string page = page_of({"polymer"});

  // The counts, epsilon of the theory, and the slope of both methods on one
  // number.
  EXPECT_EQ(count(page, ">reproduced</td>"), 4);
  EXPECT_EQ(
      count(page, " gamma_slope, <a href=\"#polymer\">Figures 1 and 2</a>"), 1);
  EXPECT_EQ(count(page, ">differs by "), 1); // the synthetic 25 %
  EXPECT_EQ(count(page, ">not reproducible: never stated</td>"), 1);
  EXPECT_EQ(
      count(page, ">not determined: no method of the case computes this</td>"),
      1);
  EXPECT_NE(page.find("Of 5 published numbers and claims, each compared with "
                      "the method that comes nearest:"),
            std::string::npos);
  EXPECT_NE(page.find("<tr><td class=\"number\">2</td><td class=\"reproduced\">"
                      "reproduced</td></tr>"),
            std::string::npos);
  EXPECT_NE(
      page.find("<tr><td class=\"number\">0</td><td class=\"input\">set by "
                "the case or fitted to it</td></tr>"),
      std::string::npos);
  EXPECT_NE(page.find("<h1>Someone &lt;paper&gt;</h1>"), std::string::npos);
  EXPECT_NE(page.find("The gap &amp; the load."), std::string::npos);
}

// A number with which a wide interval of ours agrees is not counted as
// reproduced. Two realisations whose areas are 10 % apart have a wide one.
TEST_F(PaperReport, CountsNoAgreementByAWideInterval) {
  one.reference = "quantity,value,unit,uncertainty,source\n"
                  "area_excess,0.25,1,0.005,Sec. 7\n";
  for (results::CurvePoint& point : one.methods[1].realizations[1].points)
    point.area_fraction *= 1.1;

  const std::string page = page_of({"polymer"});

  EXPECT_EQ(count(page, ">reproduced</td>"), 1); // in the counts
  EXPECT_EQ(count(page, "<td class=\"inconclusive\">inconclusive: "), 2);
  EXPECT_NE(page.find("<tr><td class=\"number\">1</td><td "
                      "class=\"inconclusive\">inconclusive: our own interval"),
            std::string::npos);
}

// paper.json has the content of the page: each number once with its verdicts,
// the parts, and the counts of the banner.
TEST_F(PaperReport, IsWrittenForPrograms) {
  const std::string page = page_of({"polymer", "atoms"});

  const auto json = nlohmann::json::parse(text_of(folder / "paper.json"));

  EXPECT_EQ(json["format"], "asperity-paper");
  EXPECT_EQ(json["title"], "Someone <paper>");
  EXPECT_EQ(json["banner"],
            "Of 5 published numbers and claims, each compared with the method "
            "that comes nearest: reproduced 2, inconclusive because our own "
            "interval is too wide 0, different by the amount stated 1, not "
            "reproducible for the reason stated 1, set by the case or fitted "
            "to it 0, without a computed value 1.");
  EXPECT_EQ(json["counts"]["numbers"], 5);
  EXPECT_EQ(json["counts"]["reproduced"], 2);
  EXPECT_EQ(json["counts"]["differs"], 1);
  EXPECT_EQ(json["counts"]["inconclusive"], 0);
  EXPECT_EQ(json["counts"]["input"], 0);
  EXPECT_EQ(json["counts"]["not_reproducible"], 1);
  EXPECT_EQ(json["counts"]["missing"], 1);
  EXPECT_EQ(json["parts"][1]["name"], "atoms");
  EXPECT_EQ(json["parts"][1]["status"], "interrupted");
  ASSERT_EQ(json["published"].size(), 5U); // atoms has no reference
  const auto& height = json["published"][2];
  EXPECT_EQ(height["part"], "polymer");
  EXPECT_EQ(height["quantity"], "rms_height");
  EXPECT_EQ(height["verdict"], "not_reproducible");
  EXPECT_EQ(height["why"], "never stated");
  EXPECT_EQ(json["published"][3]["verdict"], "missing");
}

TEST_F(PaperReport, LinksNumbersSectionsAndReports) {
  const std::string page = page_of({"polymer"}, "", true);

  EXPECT_NE(page.find("<a href=\"#polymer\">Figures 1 and 2</a>"),
            std::string::npos);
  EXPECT_NE(page.find("<h2 id=\"polymer\">Figures 1 and 2: "),
            std::string::npos);
  EXPECT_NE(page.find("<p class=\"note\">Figures 1 and 2: all &amp; more."),
            std::string::npos);
  EXPECT_NE(page.find("<a href=\"polymer/report.html\">"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "polymer/report.html"));
  EXPECT_EQ(count(page, "<img "), 2);
  EXPECT_NE(page_of({"polymer", "atoms"})
                .find("atoms is not complete (status: interrupted)"),
            std::string::npos);
}

// Parts that differ by the number at their end share a section and its figures.
TEST_F(PaperReport, JoinsASeriesOfParts) {
  const std::string apart = page_of({"size", "shape"});
  const std::string joined = page_of({"size-1", "size-2"});

  EXPECT_EQ(count(apart, "<h2 id=\"s"), 2); // beside claims and provenance
  EXPECT_EQ(count(joined, "<h2 id=\"s"), 1);
  EXPECT_EQ(count(joined, "<img "), 3); // one gap, and a spectrum each
  EXPECT_EQ(count(joined, "report.html\">"), 2);
  EXPECT_TRUE(fs::exists(folder / "figures/size/pressure-gap.svg"));
  EXPECT_TRUE(problems.empty()) << problems.front();
  EXPECT_EQ(section_of("finite-size-4"), "finite-size");
  EXPECT_EQ(section_of("zeta4"), "zeta4");
  EXPECT_EQ(section_of("-4"), "-4");
}

TEST_F(PaperReport, StatesThatARunWasQuick) {
  EXPECT_EQ(page_of({"a"}).find("A quick run"), std::string::npos);
  EXPECT_NE(page_of({"a"}, quick_mark).find("A quick run"), std::string::npos);
}

TEST_F(PaperReport, ReportsAMissingPicture) {
  const ReportEntry entry = entry_of(one, rough);
  const PaperPart part{"a", folder / "nowhere", readme, figures, entry};

  const auto undrawn = write_paper_report({&part, 1}, "", folder);

  EXPECT_EQ(undrawn.size(), 2U);
  EXPECT_EQ(count(text_of(folder / "report.html"), "could not be drawn"), 2);
}

// A figure that the result does not have is named and not omitted.
TEST_F(PaperReport, NamesAFigureThatIsMissing) {
  const PaperPart part{
      "a", folder, readme, {"adhesion-height"}, entry_of(one, rough)};

  const auto undrawn = write_paper_report({&part, 1}, "", folder);

  ASSERT_EQ(undrawn.size(), 1U);
  EXPECT_EQ(undrawn.front(), "adhesion-height: this result has no such figure");
}

TEST_F(PaperReport, ParsesAReadme) {
  EXPECT_EQ(plain_paragraphs("# A `b`\n\n\nc **d**\ne\n"),
            (std::vector<std::string>{"A b", "c d e"}));
  EXPECT_EQ(paragraph_on(readme, "Claim"), "The gap & the load.");
  EXPECT_EQ(paragraph_on(readme, "Figure"), "");
}

} // namespace asperity::reports::paper_report_test
