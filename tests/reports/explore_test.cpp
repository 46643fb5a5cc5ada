// Tests of reports/explore: the browser gets the panels of a figure as they are
// on paper, packed maps are unpacked unchanged, and no text of a result can end
// the element of the page that holds it.
#include "base/special_numbers.hpp"
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

nlohmann::json json_of_panels(const std::vector<ChartPanel>& panels) {
  const std::string data = explore_data("a", "", "x,y\n", panels, std::nullopt);
  return data.empty() ? nlohmann::json()
                      : nlohmann::json::parse(data).at("panels");
}

TEST(PlainLabel, ConvertsMarkup) {
  EXPECT_EQ(plain_label("A_0 m^4,  h_{rms} 10^{-2}"), "A₀ m⁴, h_rms 10^-2");
  EXPECT_EQ(plain_label(as_markup("a_b^c{d}@e&f~g\\")), "a_b^c{d}@e&f~g\\");
}

// In other units every place is multiplied by the factor of its axis, so that
// the numbers of 2 E* are those of 6 MPa with E* = 3 MPa; a second change
// restores the panel.
TEST(ExploreData, OffersOtherUnits) {
  ChartCurve bars = curve("a", markers("#222222", 7, 1.0), 0, 4, 3);
  bars.low = 5;
  bars.high = 6;
  bars.has_x_interval = true;
  ChartPanel panel{
      .x = {.label = "u / h_{rms}", .low = 0.5, .other = {{"u [nm]", 20.0}}},
      .y = {.label = "p / E*",
            .high = 4.0,
            .is_log = true,
            .other = {{"p [MPa]", 3.0}}},
      .curves = {bars, {.slope = 2.0, .intercept = 1.0}},
      .marks = {{.low = 1.0, .high = 2.0}},
      .bands = {{"#0072B2", {{4, 1}, {5, 2}, {6, 3}}}}};
  const nlohmann::json reduced = json_of_panels({panel}).at(0);
  const nlohmann::json physical = reduced.at("other");

  EXPECT_EQ(physical.at("x").at("label"), "u [nm]");
  EXPECT_EQ(physical.at("x").at("low"), 10.0);
  EXPECT_EQ(physical.at("y").at("high"), 12.0);
  EXPECT_TRUE(physical.at("y").at("log").get<bool>());
  EXPECT_EQ(physical.at("curves").at(0).at("xFactor"), 20.0);
  EXPECT_EQ(physical.at("curves").at(0).at("factor"), 3.0);
  // y = 1 + 2 x in E* is 3 + 6 x MPa, and x is 1/20 of the number in nm.
  EXPECT_EQ(physical.at("curves").at(1).at("intercept"), 3.0);
  EXPECT_NEAR(physical.at("curves").at(1).at("slope").get<double>(), 0.3,
              1e-15);
  EXPECT_EQ(physical.at("marks").at(0).at("high"), 40.0);
  EXPECT_EQ(physical.at("bands").at(0).at("corners").dump(),
            "[[80.0,3.0],[100.0,6.0],[120.0,9.0]]");
  use_other_units(panel);
  EXPECT_EQ(panel.y.other->label, "p / E*");
  use_other_units(panel);
  nlohmann::json again = json_of_panels({panel}).at(0);
  EXPECT_NEAR(again.at("curves").at(0).at("factor").get<double>(), 1.0, 1e-15);
  EXPECT_EQ(again.at("marks"), reduced.at("marks"));
  EXPECT_EQ(again.at("bands"), reduced.at("bands"));
}

// Columns are counted from 0; an edge of the plot is null.
TEST(ExploreData, HoldsCurvesMarksAndAxes) {
  ChartCurve intervals =
      curve("b", joined(markers("#0072B2", 8, 0.6)), 3, 3, 4);
  intervals.low = 5;
  intervals.high = 6;
  intervals.is_on_second_axis = true;
  const nlohmann::json panel =
      json_of_panels({{.x = {.ticks = {{0.0, "soft, thick"}, {1.0, "A_0"}}},
                       .second = ChartAxis{.is_log = true},
                       .curves = {intervals, level(2.5, line("#888888"))},
                       .marks = {{.low = -infinity, .high = 2.0}}}})
          .at(0);

  EXPECT_EQ(panel.at("x").at("ticks").dump(),
            "[[0.0,\"soft, thick\"],[1.0,\"A₀\"]]");
  EXPECT_TRUE(panel.at("second").at("log").get<bool>());
  const nlohmann::json& found = panel.at("curves").at(0);
  EXPECT_EQ(found.at("index"), 3);
  EXPECT_EQ(found.at("x"), 2);
  EXPECT_EQ(found.at("low"), 4);
  EXPECT_EQ(found.at("marker"), 8);
  EXPECT_TRUE(found.at("second").get<bool>());
  EXPECT_EQ(panel.at("curves").at(1).at("intercept"), 2.5);
  EXPECT_TRUE(panel.at("marks").at(0).at("low").is_null());
  EXPECT_EQ(panel.at("marks").at(0).at("high"), 2.0);
}

// A figure of which a part cannot be shown has no chart at all, because a chart
// with a missing curve would mislead.
TEST(ExploreData, IsEmptyIfAPartCannotBeShown) {
  const ChartPanel good{.curves = {level(0.0, line("#222222"))}};
  ChartPanel image = good;
  image.image = ChartImage{};
  ChartPanel bars = good;
  bars.curves.push_back({.y = 2, .is_per_row = true});
  ASSERT_EQ(json_of_panels({good, good}).size(), 2U);
  EXPECT_TRUE(json_of_panels({}).is_null());
  for (const ChartPanel& panel : {image, bars, ChartPanel{}})
    EXPECT_TRUE(json_of_panels({good, panel}).is_null());
}

// A case whose loads are in SI units has MPa and nm first; one with loads in E*
// has them second.
TEST(ExploreData, ShowsThePhysicalUnitsOfACaseInSiUnits) {
  cases::Case rough = synthetic::contact_case();
  const results::Result result = synthetic::rough_result(rough, 1);
  const auto labels = [&] {
    const ReportEntry entry = entry_of(result, rough);
    const Figure figure = figures_of(std::span(&entry, 1)).front().figures[0];
    const nlohmann::json panel =
        nlohmann::json::parse(explore_data(figure)).at("panels").at(0);
    return std::vector<std::string>{
        panel.at("x").at("label"), panel.at("y").at("label"),
        panel.at("other").at("y").at("label"),
        panel.at("curves").at(0).at("factor").dump()};
  };

  rough.load.targets = {{1e-3, mechanics::ReferenceUnit::contact_modulus}};
  EXPECT_EQ(labels(),
            (std::vector<std::string>{"mean separation u / h_rms",
                                      "nominal pressure p / E*",
                                      "nominal pressure p [MPa]", "1.0"}));
  rough.load.targets = {{1e6, mechanics::ReferenceUnit::si}};
  EXPECT_EQ(labels(),
            (std::vector<std::string>{
                "mean separation u [nm]", "nominal pressure p [MPa]",
                "nominal pressure p / E*",
                nlohmann::json(1e-6 * synthetic::contact_modulus).dump()}));
}

TEST(PressureAxis, IsLogarithmicWhereLoadsAreSpacedSo) {
  EXPECT_TRUE(is_spaced_logarithmically({8.0, 1.0, 2.0, 4.0, 4.0}));
  EXPECT_TRUE(is_spaced_logarithmically({1.0, 1.5, 2.3, 4.0, 9.0, 20.0}));
  EXPECT_FALSE(is_spaced_logarithmically({1.0, 2.0, 3.0, 4.0}));
  EXPECT_FALSE(is_spaced_logarithmically({1.0, 1000.0}));
  EXPECT_FALSE(is_spaced_logarithmically({}));
}

// Every figure of a report on a rough surface can be explored.
TEST(ExploreData, HoldsEveryFigureOfAReport) {
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
  std::vector<ChartPanel> panels(1);
  panels[0].curves.emplace_back().label =
      "</script><script>alert(1)</script><!-- &amp; ]]>";

  const std::string data =
      explore_data("a", "<b>\"quoted\"</b>", "x,y\n", panels, std::nullopt);

  EXPECT_EQ(data.find_first_of("<>&"), std::string::npos);
  const auto json = nlohmann::json::parse(data);
  EXPECT_EQ(json.at("title"), "<b>\"quoted\"</b>");
  EXPECT_EQ(json.at("panels").at(0).at("curves").at(0).at("label"),
            panels[0].curves[0].label);
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
