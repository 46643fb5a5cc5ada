// Tests of the figures of report.html that can be explored, in headless
// Chromium: values, curves, axes, keys and the loads of maps.
#include "reports/explore/explore_data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "browser.hpp"

namespace asperity::reports::exploring_test {

/// What is asked of the page, one after the other: a probe leaves the page as
/// it was, but for the last two.
constexpr std::pair<const char*, const char*> probes[] = {
    {"pictures",
     "return Array.from(document.images, image => image.naturalWidth);"},
    {"values",
     "const {parts: [part]} = await figure('pressure-gap'); const context = "
     "part.canvas.getContext('2d'); const pixels = context.getImageData(0, 0, "
     "part.canvas.width, part.canvas.height).data; return {inked: "
     "pixels.filter((c, i) => i % 4 === 3 && c > 0).length, curves: "
     "part.chart.data.datasets.map(one => ({label: one.label, x: "
     "one.data.map(p => p.x), y: one.data.map(p => p.y)})), yAxis: "
     "part.chart.scales.y.type, tip: part.configuration().options.plugins."
     "tooltip.callbacks.label({raw: part.points[0][0], datasetIndex: 0, "
     "dataset: {label: 'theory'}})};"},
    {"slider",
     "const {parts: [view]} = await figure('maps-fem'); const state = async "
     "() => { for (let i = 0; i < 100 && view.loadText.textContent !== "
     "view.stack.frames[view.frame].title; ++i) await pause(); return {load: "
     "view.loadText.textContent, picture: view.canvas.toDataURL(), values: "
     "Array.from(view.steps, (_, i) => view.valueAt(i))}; }; const last = "
     "await state(); view.slider.value = 0; view.slider.dispatchEvent(new "
     "Event('input')); const first = await state(); return {first, last, "
     "words: view.wordsAt(0.5, 0.5)};"},
    {"zoom",
     "const {parts: [part]} = await figure('pressure-gap'); const chart = "
     "part.chart; const range = () => [chart.scales.x.min, "
     "chart.scales.x.max]; part.toggle(0); const hidden = "
     "!chart.isDatasetVisible(0) && chart.isDatasetVisible(1); "
     "part.toggle(0); const shown = chart.isDatasetVisible(0); "
     "part.setLog('y', false); const linear = chart.scales.y.type; const "
     "whole = range(); const area = chart.chartArea; part.zoom([area.left + "
     "area.width / 4, area.top + 20, area.right - area.width / 4, "
     "area.bottom - 20]); const part_of = range(); part.reset(); return "
     "{hidden, shown, linear, whole, part_of, again: range()};"},
    {"keyboard",
     "const {parts: [part]} = await figure('pressure-gap'); const {parts: "
     "[view]} = await figure('maps-fem'); const press = (one, key) => "
     "one.canvas.dispatchEvent(new KeyboardEvent('keydown', {key})); const "
     "tip = () => part.chart.tooltip.body[0].lines[0]; press(part, "
     "'ArrowRight'); const first = tip(); press(part, 'ArrowRight'); const "
     "second = tip(); press(part, 'ArrowDown'); const other = tip(); const "
     "range = () => part.chart.scales.x.max - part.chart.scales.x.min; const "
     "whole = range(); press(part, '+'); const half = range() / whole; "
     "press(part, '0'); const again = range() / whole; press(part, ' '); "
     "const hidden = !part.chart.isDatasetVisible(part.at.datasetIndex); "
     "press(part, ' '); for (let i = 0; i < 100 && !view.steps; ++i) await "
     "pause(); press(view, "
     "'ArrowRight'); return {first, second, other, half, again, hidden, map: "
     "view.words.textContent};"},
    {"units",
     "const shown = await figure('pressure-gap'); const {parts: [part]} = "
     "shown; const before = part.points[0][0].y; const choice = "
     "shown.bar.querySelector('select'); choice.value = '1'; "
     "choice.dispatchEvent(new Event('change')); const width = "
     "part.canvas.clientWidth; return {label: "
     "part.chart.options.scales.y.title.text, factor: part.points[0][0].y / "
     "before, names: choice.textContent, pixels: shown.picture().width / "
     "width};"},
    {"intervals",
     "const {parts: [part]} = await figure('pressure-gap'); const {panel, "
     "points} = part; Object.assign(panel.y, {low: undefined, high: "
     "undefined}); panel.curves[0].low = 1; for (const point of points[0]) { "
     "point.low = point.y / 100; point.high = 100 * point.y; } "
     "part.showPoints(); const {min, max} = part.chart.scales.y; return "
     "{below: points[0].filter(point => point.low < min).length, above: "
     "points[0].filter(point => point.high > max).length, all: "
     "points[0].length};"},
    {"path",
     "const {parts: [part]} = await figure('pressure-gap'); for (const path of "
     "part.points) path.push({...path[0]}); part.showPoints(); const {min, "
     "max} = part.chart.scales.x; return {outside: "
     "part.points.flat().filter(point => point.x < min || point.x > "
     "max).length, all: part.points.flat().length};"},
};

class Exploring : public Browser {
protected:
  /// One start of the browser answers all probes.
  static void SetUpTestSuite() {
    Browser::SetUpTestSuite();
    if (!has_chromium() || chart_library().empty())
      return;
    std::string collect = "const found = {};";
    for (const auto& [name, script] : probes)
      collect += std::string("try { found.") + name +
                 " = await (async () => {" + script +
                 "})(); } catch (error) { found." + name +
                 " = String(error); } ";
    found_ = found_in_page(report, collect + "return found;");
  }

  void SetUp() override {
    Browser::SetUp();
    if (!IsSkipped() && chart_library().empty())
      GTEST_SKIP() << "skipped: needs libjs-chart.js";
  }

  static const nlohmann::json& found_of(const std::string& probe) {
    return found_.is_object() ? found_.at(probe) : found_;
  }

  inline static nlohmann::json found_;
};

// The browser can draw every picture of the page: the widths in pixels are
// those of figures.hpp, at least 480; 0 means that it cannot be decoded.
TEST_F(Exploring, CanDrawEveryPicture) {
  const nlohmann::json& found = found_of("pictures");

  ASSERT_TRUE(found.is_array()) << found;
  EXPECT_GE(n_pictures(report), 9);
  EXPECT_EQ(std::ssize(found), n_pictures(report));
  for (const nlohmann::json& width : found)
    EXPECT_GE(width.get<int>(), 480);
}

// The figure is drawn, and the values shown when hovering are those of its
// table.
TEST_F(Exploring, ShowsTheValuesOfTheTable) {
  const nlohmann::json& found = found_of("values");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_GT(found.at("inked").get<int>(), 1000);
  EXPECT_EQ(found.at("yAxis"), "logarithmic");
  std::map<std::string, std::vector<double>> gaps;
  std::map<std::string, std::vector<double>> pressures;
  std::istringstream table(text_of(folder / "figures" / "pressure-gap.csv"));
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    const std::string label = line.substr(1, line.find('"', 1) - 1);
    std::istringstream numbers(line.substr(label.size() + 3));
    std::vector<double> row;
    for (std::string word; std::getline(numbers, word, ',');)
      row.push_back(std::stod(word));
    pressures[label].push_back(row[1]);
    gaps[label].push_back(row[2]);
  }
  ASSERT_EQ(found.at("curves").size(), 3U); // theory, fem, fit
  for (const nlohmann::json& curve : found.at("curves")) {
    const std::string label = curve.at("label");
    EXPECT_EQ(curve.at("x").get<std::vector<double>>(), gaps.at(label));
    EXPECT_EQ(curve.at("y").get<std::vector<double>>(), pressures.at(label));
  }
  EXPECT_EQ(found.at("tip").get<std::string>().find(
                "theory: mean separation u / h_rms = "),
            0U)
      << found.at("tip");
}

// A curve can be hidden, an axis made linear, a part enlarged, and all of that
// undone.
TEST_F(Exploring, HidesCurvesChangesAxesAndZooms) {
  const nlohmann::json& found = found_of("zoom");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_TRUE(found.at("hidden").get<bool>());
  EXPECT_TRUE(found.at("shown").get<bool>());
  EXPECT_EQ(found.at("linear"), "linear");
  const double whole = found.at("whole")[1].get<double>();
  EXPECT_NEAR(found.at("part_of")[0].get<double>(), 0.25 * whole, 0.02 * whole);
  EXPECT_NEAR(found.at("part_of")[1].get<double>(), 0.75 * whole, 0.02 * whole);
  EXPECT_EQ(found.at("again"), found.at("whole"));
}

// The range of an axis without a given range contains the intervals of its
// points.
TEST_F(Exploring, ShowsEntireIntervals) {
  const nlohmann::json& found = found_of("intervals");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_GT(found.at("all"), 3);
  EXPECT_EQ(found.at("below"), 0);
  EXPECT_EQ(found.at("above"), 0);
}

// The largest x of a path that comes back is in its middle.
TEST_F(Exploring, ShowsPathsThatComeBack) {
  const nlohmann::json& found = found_of("path");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_GT(found.at("all"), 3);
  EXPECT_EQ(found.at("outside"), 0);
}

// In other units the axes have other names, and the numbers are those of the
// table times the factor; a picture for print has 600 pixels per inch.
TEST_F(Exploring, ChangesUnitsAndDrawsForPrint) {
  const nlohmann::json& found = found_of("units");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_EQ(found.at("label"), "nominal pressure p [MPa]");
  EXPECT_NEAR(found.at("factor").get<double>(), 1e-6 * result.contact_modulus,
              1e-6 * result.contact_modulus * 1e-9);
  EXPECT_NE(found.at("names").get<std::string>().find("p / E*"),
            std::string::npos);
  EXPECT_NEAR(found.at("pixels").get<double>(), 6.25, 0.02);
}

// Without a mouse, the arrow keys show the values of the curves, space hides a
// curve, plus enlarges and 0 resets; in a map the arrow keys show values, too.
TEST_F(Exploring, RespondsToTheKeyboard) {
  const nlohmann::json& found = found_of("keyboard");

  ASSERT_TRUE(found.is_object()) << found;
  const std::string first = found.at("first");
  const std::string second = found.at("second");
  EXPECT_EQ(first.find("theory: mean separation u / h_rms = "), 0U) << first;
  EXPECT_EQ(second.find("theory: "), 0U) << second;
  EXPECT_NE(first, second);
  EXPECT_EQ(found.at("other").get<std::string>().find("fem: "), 0U);
  EXPECT_NEAR(found.at("half").get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(found.at("again").get<double>(), 1.0, 1e-9);
  EXPECT_TRUE(found.at("hidden").get<bool>());
  EXPECT_EQ(found.at("map").get<std::string>().find("x = 5.2 µm, "), 0U)
      << found.at("map");
}

// The slider changes the map, and each map holds the values of the result:
// within half of its 2047 steps.
TEST_F(Exploring, ShowsTheMapOfTheLoadOfTheSlider) {
  const nlohmann::json& found = found_of("slider");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_NE(found.at("first").at("load"), found.at("last").at("load"));
  EXPECT_NE(found.at("first").at("picture"), found.at("last").at("picture"));
  EXPECT_EQ(found.at("words").get<std::string>().find("x = 5 µm, y = 5 µm;"),
            0U)
      << found.at("words");
  const auto& maps = result.methods.at(1).realizations.at(0).fields;
  const double unit = result.contact_modulus * result.surfaces[0].rms_slope;
  for (const auto& [name, fields] :
       {std::pair("first", &maps.front()), std::pair("last", &maps.back())}) {
    const auto values = found.at(name).at("values").get<std::vector<double>>();
    ASSERT_EQ(values.size(), fields->pressure.size());
    const double largest = *std::ranges::max_element(fields->pressure) / unit;
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(values[i] > 0.0, fields->pressure[i] > 0.0) << name << i;
      // A pressure below half a step is shown as one step, not as none.
      ASSERT_NEAR(values[i], fields->pressure[i] / unit, 1.001 * largest / 2047)
          << name << " " << i;
    }
  }
}

} // namespace asperity::reports::exploring_test
