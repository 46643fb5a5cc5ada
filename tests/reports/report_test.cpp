// Tests of reports/pages/report.hpp: the folder has the documented content, the
// page is self-contained, states every verdict, and is written without gnuplot,
// too.
#include "input/input_error.hpp"
#include "reports/explore/explore_data.hpp"
#include "reports/pages/html_report.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/pages/report.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <pugixml.hpp>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::report_test {

namespace fs = std::filesystem;

using Report = ReportFolder;

TEST_F(Report, HoldsPageFiguresScriptsAndData) {
  const std::vector<std::string> problems =
      write(synthetic::rough_result(rough, 3));

  EXPECT_TRUE(problems.empty()) << problems.front();
  EXPECT_TRUE(fs::exists(folder / "summary.json"));
  for (const char* name :
       {"pressure-gap", "gap-deviation", "area-pressure", "area-coefficient",
        "area-theory", "pressure-distribution-fem", "gap-distribution-fem",
        "surface", "spectrum", "maps-fem", "cost"})
    for (const char* ending : {".svg", ".csv", ".gp"})
      EXPECT_GT(
          fs::file_size(folder / "figures" / (std::string(name) + ending)), 40U)
          << name << ending;
  EXPECT_LT(fs::file_size(folder / "report.html"), 5'000'000U);
}

// The page is well-formed and refers to nothing outside itself: the only
// addresses are the names of the pictures' XML namespaces, and comments of the
// packaged library.
TEST_F(Report, IsSelfContained) {
  write(synthetic::rough_result(rough, 2));
  const std::string html = text_of(folder / "report.html");

  pugi::xml_document document;
  const auto outcome = document.load_string(html.c_str());

  ASSERT_TRUE(outcome) << outcome.description() << " at " << outcome.offset;
  std::string own = html;
  const std::string library = inline_script(chart_library());
  if (const std::size_t at = own.find(library); at != std::string::npos)
    own.erase(at, library.size());
  for (std::size_t at = own.find("://"); at != std::string::npos;
       at = own.find("://", at + 1))
    EXPECT_EQ(own.substr(at - 4, 18), "http://www.w3.org/");
  EXPECT_TRUE(
      document
          .select_nodes("//script/@src | //@srcset | //link | //iframe | "
                        "//object | //embed")
          .empty());
  for (const auto& link : document.select_nodes("//a/@href")) {
    const std::string target = link.attribute().value();
    EXPECT_EQ(target.front(), '#');
    EXPECT_NE(html.find(" id=\"" + target.substr(1) + "\""), std::string::npos)
        << target;
  }
  for (const auto& image : document.select_nodes("//img/@src")) {
    const std::string picture = image.attribute().value();
    EXPECT_EQ(picture.rfind("data:image/svg", 0), 0U);
    // A dark page inverts its pictures, but not the colours of maps.
    EXPECT_EQ(picture.find("%3Cimage") == picture.npos,
              picture.find("hue-rotate") == picture.npos);
  }
}

// Each verdict is written in the page beside method and quantity, and the
// banner counts those that are not met: one of four, by construction.
TEST_F(Report, StatesEveryVerdict) {
  write(synthetic::rough_result(rough, 2));
  pugi::xml_document document;
  document.load_string(text_of(folder / "report.html").c_str());

  std::vector<std::string> words;
  for (const auto& cell :
       document.select_nodes("//td[contains(@class, 'word')]"))
    words.emplace_back(cell.node().text().get());

  EXPECT_EQ(words,
            (std::vector<std::string>{"✓ ok", "✓ ok", "✓ ok", "✗ failed"}));
  const std::string banner =
      document.select_node("//p[contains(@class, 'banner')]")
          .node()
          .text()
          .get();
  EXPECT_EQ(banner, "1 of 4 expectations are not met.");
  EXPECT_STREQ(document.select_node("//h1").node().text().get(),
               rough.title.c_str());
}

// The first table has one row per method with its description below.
TEST_F(Report, DescribesEveryMethod) {
  write(synthetic::rough_result(rough, 1), "no-such-gnuplot");
  pugi::xml_document document;
  document.load_string(text_of(folder / "report.html").c_str());

  std::vector<std::string> words;
  for (const auto& row :
       document.select_nodes("(//table)[1]/tbody/tr/td[position() = 1]"))
    words.emplace_back(row.node().text().get());

  EXPECT_EQ(words, (std::vector<std::string>{
                       "theory", "Persson's theory of the formula", "fem",
                       "condensed Q1 block, penalty"}));
}

TEST_F(Report, IsWrittenWithoutGnuplotAndReportsIt) {
  const std::vector<std::string> problems =
      write(synthetic::rough_result(rough, 1), "no-such-gnuplot");

  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems.front().find("no-such-gnuplot"), std::string::npos);
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("no-such-gnuplot cannot be started"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "figures" / "pressure-gap.csv"));
}

TEST_F(Report, ShowsFailedStepsInterruptedRunsAndDirtySources) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.status = "interrupted";
  result.provenance.emplace_back("dirty", "yes");
  results::CurvePoint& failed = result.methods[1].realizations[0].points[3];
  failed.status = results::StepStatus::not_converged;
  failed.note = "residual stands at <1e-4>";
  result.methods[1].realizations[0].points[4].note = "finished another way";

  write(result);

  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("The run is not complete (status: interrupted)"),
            std::string::npos);
  EXPECT_NE(html.find("do not quote these numbers"), std::string::npos);
  EXPECT_NE(html.find("fem: 1 of 16 steps did not converge"),
            std::string::npos);
  EXPECT_NE(html.find("residual stands at &lt;1e-4&gt;"), std::string::npos);
  const std::size_t remarks = html.find("Steps with remarks");
  ASSERT_NE(remarks, std::string::npos);
  EXPECT_NE(html.find("finished another way", remarks), std::string::npos);
  EXPECT_EQ(html.find("residual stands", remarks), std::string::npos);
}

// The page states once what the note of a step reports as not determined, with
// the number of steps, and not what else the note says.
TEST_F(Report, ListsWhatIsNotDetermined) {
  results::Result result = synthetic::rough_result(rough, 1);
  for (const std::size_t step : {0u, 1u, 2u})
    result.methods[1].realizations[0].points[step].note =
        "mean over 5 samples; area_fraction_fit is not determined: too few";

  write(result, "no-such-gnuplot");

  pugi::xml_document document;
  document.load_string(text_of(folder / "report.html").c_str());
  const auto row =
      document.select_node("//details[@id = 'undetermined']//tbody/tr");
  EXPECT_STREQ(row.node().child("td").text().get(), "fem");
  EXPECT_STREQ(row.node().child("td").next_sibling().text().get(),
               "area_fraction_fit is not determined: too few");
  EXPECT_STREQ(row.node().last_child().text().get(), "3");
}

// A converged step whose note concerns observables alone is not a step with a
// note: it is counted in that table and not listed.
TEST_F(Report, ListsNoStepForItsObservablesAlone) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.methods[1].realizations[0].points[1].note =
      "area_fraction_fit is not determined: too few";

  write(result, "no-such-gnuplot");

  const std::string html = text_of(folder / "report.html");
  const std::size_t first = html.find("is not determined: too few");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(html.find("is not determined: too few", first + 1),
            std::string::npos);
}

// A map without a histogram, because the sum of its pressures exceeds a double,
// has no figure but a reason; the report and the other figures are complete.
TEST_F(Report, IsWrittenWithoutAFigureThatCannotBeComputed) {
  results::Result result = synthetic::rough_result(rough, 1);
  for (results::Fields& fields : result.methods[1].realizations[0].fields)
    fields.pressure.assign(fields.pressure.size(), 1e308);

  const std::vector<std::string> problems = write(result);

  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front(), "pressure-distribution: pressure = inf, but must "
                              "be finite");
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("This figure could not be drawn: pressure = inf, but "
                      "must be finite. "),
            std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "figures" / "area-pressure.svg"));
}

// A curve whose fits cannot be computed is reported without them, with the
// reason.
TEST_F(Report, IsWrittenWithoutQuantitiesThatCannotBeComputed) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.contact_modulus = -1.0;

  write(result);

  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("fem: an analysis failed: fits: "), std::string::npos);
}

// The case is read from the text in the result itself.
TEST_F(Report, ReadsTheCaseFromTheResult) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.case_text = text_of("cases/polymer/case.toml");
  // The case is not the one of the result, which has another grid.
  EXPECT_THROW(write_report(std::span(&result, 1), folder), input::InputError);
  for (const auto& [old_text, new_text] :
       {std::pair("points = 512", "points = 128"),
        std::pair("\"0.0078125 length\"", "\"0.03125 length\"")})
    boost::algorithm::replace_first(result.case_text, old_text, new_text);

  write_report(std::span(&result, 1), folder);

  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("H = 0.95, roll-off at 2.22 µm"), std::string::npos);
  EXPECT_NE(html.find("<td>fem.hard</td><td>kappa<small>"), std::string::npos);
}

// The histogram has as many rows as occupied bins, not one per bin from 0 to a
// load that is a million times that of full contact.
TEST_F(Report, DrawsALoadFarBeyondFullContact) {
  results::Result result = synthetic::rough_result(rough, 1);
  for (results::MethodRecord& method : result.methods)
    for (results::Fields& fields : method.realizations.front().fields)
      for (double& pressure : fields.pressure)
        pressure += 1e9 * result.contact_modulus;

  write(result);

  EXPECT_LT(fs::file_size(folder / "figures" / "pressure-distribution-fem.csv"),
            std::size_t{1} << 20);
}

// Figures of exact shapes do not overwrite each other's files.
TEST_F(Report, KeepsTheFiguresOfExactShapesApart) {
  results::Result result = synthetic::rough_result(rough, 1);
  rough.surface.kind = mechanics::SurfaceKind::wave_1d;
  rough.surface.amplitude = 34e-9 * std::numbers::sqrt2;
  rough.surface.wavelength = synthetic::length;
  const std::vector<ReportEntry> entries{entry_of(result, rough),
                                         entry_of(result, rough)};

  write_report(entries, folder);

  for (const char* one : {"1-polymer", "2-polymer"})
    EXPECT_TRUE(fs::exists(folder / "figures" / one / "exact-gap.svg")) << one;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1))
    ++found;
  return found;
}

// Each method and program that was used is cited once, and nothing else.
TEST_F(Report, CitesWhatWasUsed) {
  results::Result result = synthetic::rough_result(rough, 1);
  result.provenance = {{"program", "asperity 0.1.0"},
                       {"deal.II", "deal.II 9.4.1, Trilinos 13.2"}};
  write(result, "no-such-gnuplot");
  const std::string text = text_of(folder / "methods.txt");
  EXPECT_NE(text.find(" was pressed against a rigid "), std::string::npos);
  const std::string sources = text_of(folder / "methods.bib");

  EXPECT_NE(text.find("deal.II 9.4.1 [arndt2021]"), std::string::npos) << text;
  for (const char* key :
       {"yang2008", "persson2001", "polonsky1999", "arndt2021", "frigo2005"}) {
    EXPECT_NE(text.find(std::string("[") + key + "]"), std::string::npos);
    EXPECT_EQ(count(sources, std::string("{") + key + ","), 1U) << key;
  }
  for (const char* key :
       {"thompson2022", "yang2006", "persson2002", "johnson1985"})
    EXPECT_EQ(count(sources, key), 0U) << key;
  EXPECT_EQ(count(text, "["), count(text, "]"));
  EXPECT_EQ(count(sources, "{"), count(sources, "}"));
}

// No text of a result file ends the element that holds it, in a heading, a
// table, a figure or the data of a script.
TEST_F(Report, ShowsHostileNamesAsTheyAre) {
  const std::string hostile =
      "</script></title><script>alert(1)</script><!-- ]]>&amp;\"'";
  results::Result result = synthetic::rough_result(rough, 1);
  result.case_title = hostile;
  rough.title = hostile;
  result.methods[1].name = hostile;
  result.provenance.emplace_back("program", hostile);

  write(result);

  const std::string html = text_of(folder / "report.html");
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("</script></title>"), std::string::npos);
  EXPECT_NE(html.find("\\u003c/script\\u003e"), std::string::npos)
      << "the name of the method is in the data of the figures";
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(html.c_str()));
  EXPECT_STREQ(document.select_node("//h1").node().text().get(),
               hostile.c_str());
}

// The print version is unfolded and has no scripts; a missing program for
// printing is reported before anything is printed.
TEST_F(Report, HasAVersionForPrint) {
  const results::Result result = synthetic::rough_result(rough, 1);
  const ReportEntry entry = entry_of(result, rough);

  const nlohmann::ordered_json summary = page_summary(entry);

  const std::string page = page_text(
      text_of("reports/report.html.mustache"),
      report_page(std::span(&entry, 1), std::span(&summary, 1), {}), {}, true);

  EXPECT_EQ(count(page, "<script"), 0U);
  EXPECT_GT(count(page, "<details"), 3U);
  EXPECT_EQ(count(page, "<details id="), 0U); // others are left out of prints
  EXPECT_NE(print_page(page, folder / "report.pdf", "/no/such/program"), "");
  EXPECT_FALSE(fs::exists(folder / "report.pdf"));
}

TEST_F(Report, ComparesSeveralResults) {
  const results::Result first = synthetic::rough_result(rough, 2);
  results::Result second = synthetic::rough_result(rough, 1);
  second.case_name = "other/case";
  const std::vector<ReportEntry> entries{entry_of(first, rough),
                                         entry_of(second, rough)};

  const std::vector<std::string> problems = write_report(entries, folder);

  EXPECT_TRUE(problems.empty()) << problems.front();
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("2 results compared"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "figures" / "2-other-case" / "maps-fem.svg"));
  const std::string data = text_of(folder / "figures" / "pressure-gap.csv");
  EXPECT_NE(data.find("\"polymer: fem\""), std::string::npos);
  EXPECT_NE(data.find("\"other/case: fem\""), std::string::npos);
}

} // namespace asperity::reports::report_test
