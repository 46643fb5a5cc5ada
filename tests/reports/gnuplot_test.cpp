// Tests of reports/figures/gnuplot.hpp: texts are never commands, and failures
// are reported.
#include "base/read_file.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/figures/gnuplot_script.hpp"
#include "reports/figures/journal_figures.hpp"
#include "tests/message_of.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <tuple>

namespace asperity::reports::gnuplot_test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return read_file(path, 10'000'000);
}

class Drawing : public ::testing::Test {
protected:
  Drawing() { fs::remove_all(folder); }

  ~Drawing() override { fs::remove_all(folder); }

  /// A figure of one panel with a table of one curve.
  static Figure trial(const ChartPanel& panel) {
    Figure figure;
    figure.name = "trial";
    figure.data = "curve,index,x,y\na,0,1,2\na,0,2,3\n";
    figure.panels = {panel};
    return figure;
  }

  static ChartPanel one_curve(const std::string& label = "") {
    return {.curves = {curve(label, line("#222222"), 0, 3, 4)}};
  }

  fs::path folder = fs::temp_directory_path() / "asperity-gnuplot-test";
};

// A title that would run a command, by quote, by backquote or by markup, runs
// none and is shown letter by letter, except for the shape of the quote.
TEST_F(Drawing, ShowsHostileTitlesAsTheyAre) {
  for (const std::string title :
       {"'; system('touch owned'); '", "`touch owned`", "a_b^c{d}@e~f"}) {
    const DrawnFigure figure = draw(trial(one_curve(title)), folder);

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
  ChartPanel panel = one_curve();
  panel.offsets = "no_such_function(1)";

  const DrawnFigure figure = draw(trial(panel), folder);

  EXPECT_TRUE(figure.svg.empty());
  EXPECT_NE(figure.problem.find("no_such_function"), std::string::npos);
}

// gnuplot leaves neither its messages nor a temporary file in the folder.
TEST_F(Drawing, LeavesThreeFilesAndNothingElse) {
  draw(trial(one_curve()), folder);

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
  Figure figure = trial(one_curve());
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

/// A line through the origin.
ChartCurve rising(double slope, const std::string& label) {
  return {.label = label, .style = line("#222222"), .slope = slope};
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
  const std::string title = "p/E* = 0.00133, A/A_0 = 0.0947, r = 0.13";
  ChartPanel below;
  for (const double slope : {1.0, 2.0, 3.0})
    below.curves.push_back(rising(slope, title));
  below.curves.push_back(rising(4.0, "theory"));
  ChartPanel with_other_units = below;
  with_other_units.x.other = OtherUnits{"u", 2.0};
  ChartPanel narrow = below;
  narrow.has_narrow_legend = true;
  for (const ChartPanel& panel : {below, with_other_units, narrow})
    for (const double width : {86e-3, 180e-3}) {
      EXPECT_EQ(draw_for_journal(trial(panel), {{"pdf"}, width}, folder), "");

      const std::string script = text_of(folder / "trial.gp");
      const double share =
          (margin_in(script, "rmargin") - margin_in(script, "lmargin")) *
          (margin_in(script, "tmargin") - margin_in(script, "bmargin"));
      EXPECT_GE(share, 0.6) << script << width;
      EXPECT_LE(share, 1.0);
      EXPECT_LE(margin_in(script, "lmargin"), 0.2); // room for numbers
      EXPECT_GE(margin_in(script, "lmargin"), 15e-3 / width);
      EXPECT_NE(script.find("font 'Helvetica,8'"), std::string::npos);
      EXPECT_NE(script.find("fontscale 0.75"), std::string::npos); // of 96 dpi
    }
}

std::string script_of(const ChartPanel& panel) {
  Figure figure;
  figure.name = "a";
  figure.panels = {panel};
  return gnuplot_script(figure);
}

// Each kind of curve is drawn by its own style from its own columns.
TEST(GnuplotScript, DrawsEachCurveFromItsColumns) {
  ChartCurve bar = curve("", markers("#222222", 6, 0.5), 1, 5, 4);
  bar.low = 6;
  bar.high = 7;
  bar.has_x_interval = true;
  ChartCurve interval = curve("", joined(markers("#222222", 6, 0.5)), 1, 3, 4);
  interval.low = 5;
  interval.high = 6;
  ChartCurve area = interval;
  area.is_area = true;
  ChartCurve twice = curve("A_0", line("#222222", 1.5, 2), 1, 3, 4);
  twice.factor = 2.0;
  twice.is_on_second_axis = true;
  const std::string rows = "'a.csv' using ($2==1 ? $";
  for (const auto& [drawn, words] :
       {std::pair(bar, rows + "5 : NaN):4:6:7 with xerrorbars linewidth 1 "
                              "linecolor rgb '#222222' pointtype 6 pointsize "
                              "0.5 notitle"),
        std::pair(interval, rows + "3 : NaN):4:5:6 with yerrorlines "),
        std::pair(area, rows + "3 : NaN):5:6 with filledcurves "),
        std::pair(twice, rows +
                             "3 : NaN):(2*$4) axes x1y2 with lines linewidth "
                             "1.5 dashtype 2 linecolor rgb '#222222' title "
                             "'A\\_0'"),
        std::pair(level(2.5, line("#222222")), std::string("plot 2.5 with "))})
    EXPECT_NE(script_of({.curves = {drawn}}).find(words), std::string::npos)
        << words;
}

// The bands of a figure are in a file of their own, one block each.
TEST(GnuplotScript, WritesBandsToAFileOfTheirOwn) {
  Figure figure;
  figure.name = "a";
  figure.panels = {{.bands = {{"#0072B2", {{1, 2}, {3, 4}, {5, 6}}},
                              {"#D55E00", {{7, 8}, {9, 10}, {11, 12}}}}}};

  EXPECT_EQ(band_file(figure), "1,2\n3,4\n5,6\n\n\n7,8\n9,10\n11,12\n");
  EXPECT_NE(gnuplot_script(figure).find("'a-bands.csv' index 1 using 1:2 with "
                                        "filledcurves closed fillcolor rgb "
                                        "'#D55E00'"),
            std::string::npos);
}

// No setting of a panel holds for the next one.
TEST_F(Drawing, KeepsTheSettingsOfPanelsApart) {
  Figure figure = trial(one_curve());
  ChartPanel& first = figure.panels.front();
  first.title = "heading";
  first.x = {.label = "across",
             .low = 1.0,
             .high = 10.0,
             .is_log = true,
             .has_powers = true};
  first.marks = {
      {.low = 2.0, .high = 2.0, .color = "#222222", .label = "limit"}};
  figure.panels.push_back(one_curve());
  figure.grid = PanelGrid{.columns = 2};

  const std::string svg = draw(figure, folder).svg;

  for (const char* word : {"heading", "across", "limit"})
    EXPECT_EQ(svg.find(word), svg.rfind(word)) << word;
  EXPECT_NE(svg.find(" 1.2</tspan>"), std::string::npos)
      << "a tick of a linear axis";
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
  ChartPanel panel{.x = {.label = "across"}};
  for (const int number : {1, 2, 3, 4})
    panel.curves.push_back(
        rising(number, fmt::format("a title as wide as the plot {}", number)));

  ASSERT_EQ(draw_for_journal(trial(panel), {{"svg"}, 86e-3}, folder), "");

  const std::string svg = text_of(folder / "trial.svg");
  const double label = place_of(svg, "across");
  EXPECT_GT(place_of(svg, "a title as wide as the plot 1"), label + 8.0);
  EXPECT_LT(place_of(svg, "a title as wide as the plot 4"), label + 48.0);
}

// gnuplot leaves a label out without a message where the margin is too narrow.
TEST_F(Drawing, LabelsTheAxesOfAJournalFigureAtEachWidth) {
  for (const double width : {60e-3, 86e-3, 120e-3, 180e-3}) {
    const ChartPanel panel{.x = {.label = "across"},
                           .y = {.label = "upwards", .low = 0.0, .high = 0.45},
                           .curves = {rising(1.0, "a curve")}};

    ASSERT_EQ(draw_for_journal(trial(panel), {{"svg"}, width}, folder), "");

    const std::string svg = text_of(folder / "trial.svg");
    EXPECT_NE(svg.find("across"), std::string::npos) << width;
    EXPECT_NE(svg.find("upwards"), std::string::npos) << width;
    // An index reaches half a line of 11 px below the line of the label.
    EXPECT_LT(place_of(svg, "across") + 5.0, height_of(svg)) << width;
    // An exponent reaches a line above that of the label.
    EXPECT_GT(column_of(svg, "upwards"), 10.0) << width;
  }
}

// A number on the axis opposite is at the place of the same quantity: 5 of the
// upper axis above 10 of the lower one, whose numbers are twice as large, and,
// on logarithmic axes, 0.1 above 5 where the numbers are fifty times as large.
TEST_F(Drawing, PutsOtherUnitsOnTheAxesOpposite) {
  ChartPanel panel{.x = {.label = "across",
                         .low = 0.0,
                         .high = 10.0,
                         .other = {{"half as much", 0.5}}},
                   .y = {.low = 0.0, .high = 0.9},
                   .curves = {rising(0.1, "a curve")}};

  std::string svg = draw(trial(panel), folder).svg;

  EXPECT_NE(svg.find("half as much"), std::string::npos);
  EXPECT_NEAR(column_of(svg, " 5</tspan>"), column_of(svg, " 10</tspan>"), 0.1);
  panel.x.low = 2.0;
  panel.x.high = 200.0;
  panel.x.is_log = true;
  panel.x.other->factor = 0.02;
  svg = draw(trial(panel), folder).svg;
  const double ten = column_of(svg, " 10</tspan>");
  EXPECT_NEAR(column_of(svg, " 0.1</tspan>") - ten,
              std::log10(0.5) * (column_of(svg, " 100</tspan>") - ten), 0.2);
}

// The units of a journal figure are those that were asked for.
TEST_F(Drawing, HasTheUnitsThatTheJournalAsksFor) {
  Figure figure = trial(one_curve());
  figure.panels.front().x = {.label = "u [nm]", .other = {{"u / h", 0.5}}};
  figure.is_physical = true;
  for (const auto& [units, label, factor] :
       {std::tuple("", "u [nm]", "$3"), std::tuple("physical", "u [nm]", "$3"),
        std::tuple("reduced", "u / h", "0.5*$3")}) {
    EXPECT_EQ(draw_for_journal(figure, {{"pdf"}, 86e-3, units}, folder), "");

    const std::string script = text_of(folder / "trial.gp");
    EXPECT_NE(script.find(fmt::format("set xlabel '{}'", label)),
              std::string::npos)
        << units;
    EXPECT_NE(script.find(fmt::format("? {} : NaN", factor)), std::string::npos)
        << units;
    EXPECT_EQ(script.find("x2"), std::string::npos) << units;
  }
}

// Text of 8 pt takes a larger part of two columns, 178 mm, than 12 px of a
// report figure of 860 px.
TEST_F(Drawing, WidensTheMarginsOfPanelsForAJournal) {
  Figure figure = trial(one_curve());
  figure.width = 860;
  figure.panels.push_back(one_curve());
  figure.grid = PanelGrid{.columns = 2,
                          .margins = {{0.1, 0.9, 0.2, 0.95}},
                          .across = 0.08,
                          .down = 0.08};

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
