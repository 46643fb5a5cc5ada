// Tests of reports/figures/gnuplot.hpp: texts are never commands, and failures
// are reported.
#include "base/read_file.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/figures/journal_figures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "tests/message_of.hpp"

namespace asperity::reports::gnuplot_test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return read_file(path, 10'000'000);
}

class Drawing : public ::testing::Test {
protected:
  Drawing() { fs::remove_all(folder); }

  ~Drawing() override { fs::remove_all(folder); }

  DrawnFigure drawn(const std::string& script) const {
    Figure figure;
    figure.name = "trial";
    figure.data = "x,y\n1,2\n2,3\n";
    figure.script = script;
    return draw(figure, folder);
  }

  fs::path folder = fs::temp_directory_path() / "asperity-gnuplot-test";
};

// A title that would run a command, by quote, by backquote or by markup, runs
// none and is shown letter by letter, except for the shape of the quote.
TEST_F(Drawing, ShowsHostileTitlesAsTheyAre) {
  for (const std::string title :
       {"'; system('touch owned'); '", "`touch owned`", "a_b^c{d}@e~f"}) {
    const DrawnFigure figure =
        drawn("plot 'trial.csv' using 1:2 with lines title " +
              gnuplot_text(title) + "\n");

    EXPECT_EQ(figure.problem, "") << title;
    EXPECT_FALSE(fs::exists(folder / "owned")) << title;
    std::string shown = title;
    for (std::size_t at = shown.find('\''); at != std::string::npos;
         at = shown.find('\''))
      shown.replace(at, 1, "’");
    EXPECT_NE(figure.svg.find(shown), std::string::npos) << title;
  }
}

// A name that could end the quotes around it is an error in any case.
TEST_F(Drawing, RefusesNamesThatAreNoFileWords) {
  for (const std::string name :
       {"", "a.b", "a'; system('touch owned'); '", "a/../b", "A", "a b"}) {
    Figure figure;
    figure.name = name;
    EXPECT_THROW(draw(figure, folder), std::domain_error) << name;
    figure.name = "good";
    figure.maps = {{name, ""}};
    EXPECT_THROW(draw(figure, folder), std::domain_error) << name;
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Drawing, ReportsTheMessageOfGnuplot) {
  const DrawnFigure figure = drawn("plot no_such_function(x)\n");

  EXPECT_TRUE(figure.svg.empty());
  EXPECT_NE(figure.problem.find("no_such_function"), std::string::npos);
}

// gnuplot leaves neither its messages nor a temporary file in the folder.
TEST_F(Drawing, LeavesThreeFilesAndNothingElse) {
  drawn("plot 'trial.csv' using 1:2 with lines notitle\n");

  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    ++files;
    EXPECT_EQ(entry.path().stem(), "trial") << entry.path();
  }
  EXPECT_EQ(files, 3U);
}

// The drawings have the requested width, in their own units; a wide figure has
// that of two columns and 6 mm.
TEST_F(Drawing, HasTheWidthOfTheJournal) {
  Figure figure;
  figure.name = "trial";
  figure.data = "a,b\n1,2\n3,4\n";
  figure.script = "plot 'trial.csv' using 1:2 with lines notitle\n";
  const JournalFormat format = journal_format({"pdf", "svg", "png"}, "86 mm");

  EXPECT_EQ(draw_for_journal(figure, format, folder), "");
  EXPECT_NE(text_of(folder / "trial.svg").find("width=\"86mm\""),
            std::string::npos);
  const std::string png = text_of(folder / "trial.png");
  ASSERT_GT(png.size(), 24U);
  const auto width = 256 * static_cast<unsigned char>(png[18]) +
                     static_cast<unsigned char>(png[19]);
  EXPECT_EQ(width, 2031); // 86 mm * 600
  EXPECT_EQ(text_of(folder / "trial.pdf").substr(0, 5), "%PDF-");

  figure.width = 860;
  EXPECT_EQ(draw_for_journal(figure, {{"svg"}, 86e-3}, folder), "");
  EXPECT_NE(text_of(folder / "trial.svg").find("width=\"178mm\""),
            std::string::npos);
}

/// The value behind "set lmargin at screen " and the like.
double margin_in(const std::string& script, const std::string& name) {
  const std::string words = "set " + name + " at screen ";
  const std::size_t at = script.find(words);
  EXPECT_NE(at, std::string::npos) << name;
  return std::stod(script.substr(at + words.size()));
}

// The plot covers at least 60 % of the figure, for any legend and second axes,
// and the text of a PDF has the requested size.
TEST_F(Drawing, GivesMostOfAJournalFigureToThePlot) {
  const std::string title = " title 'p/E* = 0.00133, A/A_0 = 0.0947, r = 0.13'";
  const std::string curves = "plot x" + title + ", 2*x" + title + ", 3*x" +
                             title + ", 4*x title 'theory'\n";
  Figure figure;
  figure.name = "trial";
  figure.data = "x,y\n1,2\n";
  for (const char* settings :
       {"", "set key top right\n",
        "set x2tics\nset border 7\nset x2label 'u'\n", "set key maxcols 2\n"})
    for (const double width : {86e-3, 180e-3}) {
      figure.script = settings + curves;

      EXPECT_EQ(draw_for_journal(figure, {{"pdf"}, width}, folder), "");

      const std::string script = text_of(folder / "trial.gp");
      const double share =
          (margin_in(script, "rmargin") - margin_in(script, "lmargin")) *
          (margin_in(script, "tmargin") - margin_in(script, "bmargin"));
      EXPECT_GE(share, 0.6) << settings << width;
      EXPECT_LE(share, 1.0);
      EXPECT_LE(margin_in(script, "lmargin"), 0.2); // room for numbers
      EXPECT_GE(margin_in(script, "lmargin"), 15e-3 / width);
      EXPECT_NE(script.find("font 'Helvetica,8'"), std::string::npos);
      EXPECT_NE(script.find("fontscale 0.75"), std::string::npos); // of 96 dpi
    }
}

std::string refusal(const std::vector<std::string>& endings,
                    const std::string& width) {
  return tests::message_of<std::domain_error>(
      [&] { journal_format(endings, width); });
}

/// Returns the vertical position of a text in a drawing [px], counted
/// downwards. The name of a curve occurs before the legend, too.
double place_of(const std::string& svg, const std::string& text) {
  const std::size_t start = svg.rfind("translate(", svg.rfind(text));
  return start == std::string::npos
             ? std::numeric_limits<double>::quiet_NaN()
             : std::stod(svg.substr(svg.find(',', start) + 1));
}

/// Returns the horizontal place of a text in a drawing [px].
double column_of(const std::string& svg, const std::string& text) {
  const std::string words = "translate(";
  const std::size_t start = svg.rfind(words, svg.rfind(text));
  return std::stod(svg.substr(start + words.size()));
}

/// Returns the height of a drawing [px].
double height_of(const std::string& svg) {
  std::istringstream box(svg.substr(svg.find("viewBox=\"") + 9));
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  box >> left >> top >> width >> height;
  return height;
}

// A legend of several rows does not cover the label of the axis.
TEST_F(Drawing, PutsTheLegendOfAJournalFigureBelowTheLabel) {
  Figure figure;
  figure.name = "trial";
  figure.data = "x,y\n1,2\n2,3\n";
  figure.script = "set xlabel 'across'\nplot ";
  for (const char* number : {"1", "2", "3", "4"})
    figure.script +=
        fmt::format("{}*x title 'a title as wide as the plot {}'{}", number,
                    number, *number == '4' ? "\n" : ", ");

  ASSERT_EQ(draw_for_journal(figure, {{"svg"}, 86e-3}, folder), "");

  const std::string svg = text_of(folder / "trial.svg");
  const double label = place_of(svg, "across");
  EXPECT_GT(place_of(svg, "a title as wide as the plot 1"), label + 8.0);
  EXPECT_LT(place_of(svg, "a title as wide as the plot 4"), label + 48.0);
}

// gnuplot leaves a label out without a message where the margin is too narrow.
TEST_F(Drawing, LabelsTheAxesOfAJournalFigureAtEachWidth) {
  Figure figure;
  figure.name = "trial";
  figure.data = "x,y\n1,2\n";
  for (const char* settings : {"", "set key top right\n"})
    for (const double width : {60e-3, 86e-3, 120e-3, 180e-3}) {
      figure.script = std::string(settings) +
                      "set xlabel 'across'\nset ylabel 'upwards'\n"
                      "set yrange [0:0.45]\nplot x title 'a curve'\n";

      ASSERT_EQ(draw_for_journal(figure, {{"svg"}, width}, folder), "");

      const std::string svg = text_of(folder / "trial.svg");
      EXPECT_NE(svg.find("across"), std::string::npos) << settings << width;
      EXPECT_NE(svg.find("upwards"), std::string::npos) << settings << width;
      // An index reaches half a line of 11 px below the line of the label.
      EXPECT_LT(place_of(svg, "across") + 5.0, height_of(svg))
          << settings << width;
      // An exponent reaches a line above that of the label.
      EXPECT_GT(column_of(svg, "upwards"), 10.0) << settings << width;
    }
}

// Text of 8 pt takes a larger part of two columns, 178 mm, than 12 px of a
// report figure of 860 px.
TEST_F(Drawing, WidensTheMarginsOfPanelsForAJournal) {
  Figure figure;
  figure.name = "trial";
  figure.width = 860;
  figure.data = "x,y\n1,2\n";
  figure.script =
      "set multiplot layout 1,2 margins 0.1,0.9,0.2,0.95 spacing 0.08\n"
      "plot x notitle\nplot 2*x notitle\nunset multiplot\n";

  ASSERT_EQ(draw_for_journal(figure, {{"pdf"}, 86e-3}, folder), "");

  const double factor = 8.0 * 25.4e-3 / 72.0 / 178e-3 / (12.0 / 860.0);
  EXPECT_NE(
      text_of(folder / "trial.gp")
          .find(fmt::format("margins {:.4g},{:.4g},{:.4g},{:.4g} spacing "
                            "{:.4g},{:.4g}",
                            0.1 * factor, 1.0 - 0.1 * factor, 0.2 * factor,
                            1.0 - 0.05 * factor, 0.08 * factor, 0.08 * factor)),
      std::string::npos);
}

TEST(JournalFormat, ReadsUnitsAndRefusesOthers) {
  EXPECT_NEAR(journal_format({}, "8.6cm").width, 86e-3, 1e-15);
  EXPECT_NEAR(journal_format({}, "3.4 in").width, 86.36e-3, 1e-15);
  EXPECT_EQ(refusal({"pdf"}, "86mm"), "accepted");
  EXPECT_EQ(refusal({"pdf", "eps"}, "86mm"),
            "--figures eps: unknown format; the formats are pdf, svg, png");
  for (const char* width :
       {"86", "86 pt", "mm", "", "1mm", "1e9mm", "nanmm", "-86mm", "86mmm"})
    EXPECT_NE(refusal({}, width), "accepted") << width;
}

TEST(CsvTable, QuotesLabelsAndWritesNanForWhatIsNotThere) {
  CsvTable table({"curve", "gap [m]"});

  table.add("a \"b\",c", {0.25});
  table.add("d", {NAN});

  EXPECT_EQ(table.text(), "curve,gap [m]\n\"a \"\"b\"\",c\",0.25\n\"d\",nan\n");
}

} // namespace asperity::reports::gnuplot_test
