// Tests of reports/explore: the curves in the browser are those of the gnuplot
// script, packed maps are unpacked unchanged, and no text of a result can end
// the element of the page that holds it.
#include "reports/explore/chart_of_script.hpp"
#include "reports/explore/explore_data.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <zlib.h>

#include "synthetic.hpp"

namespace asperity::reports::explore_test {

const std::string header = "curve,index,p/(E* h') [1],log10 p/E* [1],u [1]";

std::optional<Chart> chart_of_plot(const std::string& plot) {
  return chart_of_script(plot, header);
}

TEST(ChartOfScript, ReadsACurveWithItsStyle) {
  const auto chart = chart_of_plot(
      "plot 'a.csv' using ($2==-1 ? $3 : NaN):(2*$5) with linespoints "
      "pointtype 8 pointsize 0.6 linewidth 1.5 dashtype 2 linecolor rgb "
      "'#0072B2' title 'theory, A_0 \\_'\n");

  ASSERT_TRUE(chart);
  const ChartCurve& curve = chart->panels.at(0).curves.at(0);
  EXPECT_EQ(curve.index, -1);
  EXPECT_EQ(curve.x, 3);
  EXPECT_EQ(curve.y, 5);
  EXPECT_EQ(curve.factor, 2.0);
  EXPECT_TRUE(curve.has_line && curve.has_markers);
  EXPECT_EQ(curve.marker, 8);
  EXPECT_EQ(curve.dash, 2);
  EXPECT_EQ(curve.width, 1.5);
  EXPECT_EQ(curve.color, "#0072B2");
  EXPECT_EQ(curve.label, "theory, A₀ _");
}

TEST(ChartOfScript, ReadsIntervalsAxesAndMarks) {
  const auto chart = chart_of_plot(
      "set xlabel 'u / h_{rms}'\nset ylabel 'log_{10}  p / E*'\nset xrange "
      "[0.5:*]\nset yrange [-3:1]\nset arrow from 1, graph 0.02 to 2, graph "
      "0.02 nohead linewidth 2.5 linecolor rgb '#222222'\nset object 1 "
      "rectangle from 0.3, graph 0 to 1.5, graph 1 behind fillcolor rgb "
      "'#0072B2' fillstyle solid 0.06 noborder\nplot 'a.csv' using ($2==0 ? "
      "$5 : NaN):4:3:5 with xerrorbars linecolor rgb '#0072B2' notitle\n");

  ASSERT_TRUE(chart);
  const ChartPanel& panel = chart->panels.at(0);
  EXPECT_EQ(panel.x.label, "u / h_rms");
  EXPECT_EQ(panel.x.low, 0.5);
  EXPECT_FALSE(panel.x.high);
  EXPECT_EQ(panel.y.label, "p / E*"); // its column is a logarithm
  EXPECT_TRUE(panel.y.is_log && panel.y.is_log10);
  EXPECT_NEAR(panel.y.low.value(), 1e-3, 1e-18);
  EXPECT_NEAR(panel.y.high.value(), 10.0, 1e-14);
  ASSERT_EQ(panel.marks.size(), 2U);
  EXPECT_EQ(panel.marks[0].height, 0.02);
  EXPECT_EQ(panel.marks[1].high, 1.5);
  EXPECT_TRUE(panel.curves.at(0).has_x_interval);
  EXPECT_EQ(panel.curves.at(0).low, 3);
}

// A band has the corners of its own block, on the axes of the chart.
TEST(ChartOfScript, ReadsBands) {
  const std::string script =
      "plot 'a-bands.csv' index 1 using 1:2 with filledcurves closed "
      "fillcolor rgb '#0072B2' fillstyle transparent solid 0.18 noborder "
      "notitle, 'a.csv' using ($2==0 ? $5 : NaN):4 with lines";
  const std::string polygons = "1,1\n2,2\n3,3\n\n\n4,-1\n5,0\n6,2\n";

  const auto chart = chart_of_script(script, header, polygons);

  ASSERT_TRUE(chart);
  const ChartBand& band = chart->panels.at(0).bands.at(0);
  EXPECT_EQ(band.color, "#0072B2");
  ASSERT_EQ(band.corners.size(), 3U);
  EXPECT_EQ(band.corners[2].first, 6.0);
  EXPECT_NEAR(band.corners[0].second, 0.1, 1e-16); // the column is a logarithm
  EXPECT_FALSE(chart_of_script(script, header, "1,1\n2,2\n"));
  EXPECT_FALSE(chart_of_script(script, header, "\n\n\na,b\n"));
}

// Named ticks, a logarithmic second axis, lines over the full height with their
// names, and ranges that end at the edge are read.
TEST(ChartOfScript, ReadsNamesLinesAndEdges) {
  const auto chart = chart_of_plot(
      "set xtics ('soft, thick' 0, 'hard' 1)\nset logscale y2\nset arrow from "
      "3, graph 0 to 3, graph 1 nohead dashtype 3 linecolor rgb '#8a5a00' "
      "back\nset label 'tip radius' at 3, graph 0.03 rotate by 90\nset object "
      "rectangle from graph 0, graph 0 to first 2, graph 1 behind fillcolor "
      "rgb '#59636e' fillstyle solid 0.1\nplot 'a.csv' using ($2==0 ? $3 : "
      "NaN):5 axes x1y2 with lines title 'a'\n");

  ASSERT_TRUE(chart);
  const ChartPanel& panel = chart->panels.at(0);
  ASSERT_EQ(panel.x.ticks.size(), 2U);
  EXPECT_EQ(panel.x.ticks[0], std::pair(0.0, std::string("soft, thick")));
  EXPECT_TRUE(panel.second.value().is_log);
  EXPECT_FALSE(panel.y.is_log);
  ASSERT_EQ(panel.marks.size(), 2U);
  EXPECT_EQ(panel.marks[0].low, 3.0);
  EXPECT_EQ(panel.marks[0].high, 3.0);
  EXPECT_EQ(panel.marks[0].label, "tip radius");
  EXPECT_TRUE(std::isinf(panel.marks[1].low));
  EXPECT_EQ(panel.marks[1].high, 2.0);
}

// Intervals of y and areas between two columns of the table are read.
TEST(ChartOfScript, ReadsIntervalsOfYAndAreas) {
  const auto chart = chart_of_plot(
      "plot 'a.csv' using ($2==0 ? $3 : NaN):3:5 with filledcurves linecolor "
      "rgb '#0072B2' fillstyle transparent solid 0.2 noborder title '95 %', "
      "'a.csv' using ($2==0 ? $3 : NaN):4:3:5 with yerrorlines title 'b'\n");

  ASSERT_TRUE(chart);
  const std::vector<ChartCurve>& curves = chart->panels.at(0).curves;
  EXPECT_TRUE(curves.at(0).is_area);
  EXPECT_EQ(curves.at(0).low, 3);
  EXPECT_EQ(curves.at(0).high, 5);
  EXPECT_EQ(curves.at(0).label, "95 %");
  EXPECT_FALSE(curves.at(1).is_area || curves.at(1).has_x_interval);
  EXPECT_TRUE(curves.at(1).has_line && curves.at(1).has_markers);
  EXPECT_EQ(curves.at(1).high, 5);
}

// Settings remain valid from panel to panel until they are unset.
TEST(ChartOfScript, ReadsEveryPanel) {
  const auto chart = chart_of_plot(
      "set multiplot layout 1,2\nset logscale x\nset yrange [0:1]\nplot x with "
      "lines, \\\n  2.5 with lines title 'two, and a half'\nunset "
      "yrange\nunset logscale x\nplot 0 with lines\nunset multiplot\n");

  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->panels.size(), 2U);
  EXPECT_TRUE(chart->panels[0].x.is_log);
  EXPECT_EQ(chart->panels[0].y.high, 1.0);
  EXPECT_EQ(chart->panels[0].curves.at(0).slope, 1.0);
  EXPECT_EQ(chart->panels[0].curves.at(1).intercept, 2.5);
  EXPECT_EQ(chart->panels[0].curves.at(1).label, "two, and a half");
  EXPECT_FALSE(chart->panels[1].x.is_log);
  EXPECT_FALSE(chart->panels[1].y.high);
}

// A figure of which a part is not understood has no chart at all, because a
// chart with a missing curve would mislead.
TEST(ChartOfScript, RefusesWhatItDoesNotUnderstand) {
  const std::string good = "plot 0 with lines";
  ASSERT_TRUE(chart_of_plot(good));
  for (const char* part :
       {", 'm.csv' matrix using 1:2:3 with image notitle",
        ", sin(x) with lines", ", 'a.csv' using 1:2 with lines",
        ", 0 with boxes", ", 0",
        ", 'a.csv' using ($2==0 ? $3 : NaN):9 with lines",
        ", 'a.csv' using ($2==0 ? $3 : NaN):0 with lines",
        ", 'a.csv' using ($2==0 ? $3 : NaN):x with lines",
        ", 'a.csv' using ($2==0 ? $3 : NaN):3 with filledcurves",
        ", 'a.csv' using ($2==0 ? $3 : NaN):3:4 with lines", ", ",
        ", 'a.csv' using", "\nreplot"})
    EXPECT_FALSE(chart_of_plot(good + part)) << part;
  EXPECT_FALSE(chart_of_plot("set xlabel 'x'"));
  EXPECT_FALSE(chart_of_plot(""));
}

// Every figure of a report on a rough surface can be explored.
TEST(ChartOfScript, UnderstandsEveryFigureOfAReport) {
  const cases::Case rough = synthetic::contact_case();
  const results::Result result = synthetic::rough_result(rough, 3);
  const ReportEntry entry = entry_of(result, rough);

  int n_figures = 0;
  for (const FigureGroup& group : figures_of(std::span(&entry, 1)))
    for (const Figure& figure : group.figures) {
      EXPECT_FALSE(explore_data(figure).empty()) << figure.name;
      ++n_figures;
    }

  EXPECT_GE(n_figures, 11);
}

std::string unpacked(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrst"
                              "uvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int n_bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | static_cast<unsigned>(letters.find(c));
    n_bits += 6;
    if (n_bits >= 8) {
      n_bits -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(n_bits) & 255U);
    }
  }
  std::string plain(1 << 20, '\0');
  uLongf size = plain.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()),
                       bytes.size()),
            Z_OK);
  return plain.substr(0, size);
}

TEST(Packed, Unpacks) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 1000U}) {
    std::string text;
    for (std::size_t i = 0; i < size; ++i)
      text += static_cast<char>(i * i % 251);
    EXPECT_EQ(unpacked(packed(text)), text) << size;
  }
}

/// Follows the description of packed_map().
std::vector<int> steps_of(const PackedMap& map, std::size_t columns) {
  const std::string bytes = unpacked(map.data);
  const std::size_t count = bytes.size() / 2;
  std::vector<int> steps;
  for (std::size_t i = 0; i < count; ++i) {
    const int code = static_cast<unsigned char>(bytes[i]) +
                     256 * static_cast<unsigned char>(bytes[count + i]);
    int step = code % 2 == 0 ? code / 2 : -(code + 1) / 2;
    if (i % columns != 0)
      step += steps[i - 1];
    if (i >= columns)
      step += steps[i - columns];
    if (i % columns != 0 && i >= columns)
      step -= steps[i - columns - 1];
    steps.push_back(step);
  }
  return steps;
}

// Each value is within half a step of the packed one; only the smallest value
// is step 0, also beside a value that is far smaller than a step.
TEST(PackedMap, IsWithinHalfAStep) {
  std::vector<double> values{0.0,          1e-9, 3.0, -0.0, 2.9, 0.1,
                             std::nan(""), 1.5,  0.7, 3.0,  0.0, 1.0};

  const PackedMap map = packed_map(values, 4);

  EXPECT_EQ(map.low, 0.0);
  EXPECT_EQ(map.high, 3.0);
  const std::vector<int> steps = steps_of(map, 4);
  ASSERT_EQ(steps.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      EXPECT_EQ(steps[i], map_steps + 1);
      continue;
    }
    EXPECT_EQ(steps[i] == 0, values[i] <= 0.0) << i;
    if (values[i] != 1e-9) {
      EXPECT_NEAR(steps[i] * 3.0 / map_steps, values[i], 1.5001 / map_steps);
    }
  }
}

TEST(PackedMap, HoldsWhatIsDegenerate) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(steps_of(packed_map({5.0, 5.0}, 2), 2), (std::vector<int>{0, 0}));
  EXPECT_EQ(steps_of(packed_map({infinity, std::nan("")}, 1), 1),
            (std::vector<int>{map_steps + 1, map_steps + 1}));
  EXPECT_EQ(steps_of(packed_map({-largest, 0.0, largest}, 3), 3),
            (std::vector<int>{0, 1024, map_steps}));
  EXPECT_TRUE(steps_of(packed_map({}, 0), 1).empty());
}

TEST(ExploreData, CannotEndItsElement) {
  Chart chart;
  chart.panels.emplace_back().curves.emplace_back().label =
      "</script><script>alert(1)</script><!-- &amp; ]]>";

  const std::string data =
      explore_data("a", "<b>\"quoted\"</b>", "x,y\n", chart, std::nullopt);

  EXPECT_EQ(data.find_first_of("<>&"), std::string::npos);
  const auto json = nlohmann::json::parse(data);
  EXPECT_EQ(json.at("title"), "<b>\"quoted\"</b>");
  EXPECT_EQ(json.at("panels").at(0).at("curves").at(0).at("label"),
            chart.panels[0].curves[0].label);
  EXPECT_EQ(unpacked(json.at("table")), "x,y\n");
}

TEST(InlineScript, CannotEndItsElement) {
  const std::string script =
      inline_script("'</script>' + \"<!--\" + a[b[0]]>c");

  EXPECT_EQ(script.find("</script"), std::string::npos);
  EXPECT_EQ(script.find("<!--"), std::string::npos);
  EXPECT_EQ(script.find("]]>"), script.rfind("]]>")); // the end of CDATA
}

// The SHA-256 of the empty text, as RFC 6234 and W3C's CSP 2 print it.
TEST(ScriptPermission, IsTheHashInBase64) {
  EXPECT_EQ(script_permission(""),
            "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
}

TEST(StackFrames, AreTheFirstTheLastAndSomeBetween) {
  EXPECT_TRUE(stack_frames(0).empty());
  EXPECT_EQ(stack_frames(3), (std::vector<std::size_t>{0, 1, 2}));
  const std::vector<std::size_t> chosen = stack_frames(100);
  EXPECT_EQ(chosen.size(), 12U);
  EXPECT_EQ(chosen.front(), 0U);
  EXPECT_EQ(chosen.back(), 99U);
}

} // namespace asperity::reports::explore_test
