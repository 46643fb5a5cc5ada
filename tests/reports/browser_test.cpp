// Tests of report.html as a browser shows it, in headless Chromium where it is
// installed: verdicts and pictures are there, figures can be explored, and
// nothing is loaded from elsewhere.
#include "reports/explore/explore_data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;

bool has_chromium() {
  return std::system("command -v chromium > /dev/null 2>&1") == 0;
}

// The text between `before` and the next `after`, everywhere in `text`.
std::vector<std::string> all_between(const std::string& text,
                                     const std::string& before,
                                     const std::string& after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos;
       at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

/// The page without its Content-Security-Policy, so that a script of the test
/// may run in it.
std::string without_policy(std::string page) {
  const std::size_t at = page.find("<meta http-equiv");
  EXPECT_NE(at, std::string::npos);
  return page.erase(at, page.find('\n', at) - at);
}

/// A script that waits for the figures and writes what `collect` returns into
/// the page, for the test to read.
std::string probe_script(const std::string& collect) {
  return "<script>onload = async () => { const pause = () => new "
         "Promise(done => setTimeout(done, 50)); const figure = async name => "
         "{ for (let i = 0; i < 20000; ++i) { for (const [place, one] of "
         "asperity.figures) if (one.data.name === name && "
         "place.dataset.explore === 'ready') return one; await pause(); } }; "
         "let found; try { found = await (async () => {" +
         collect +
         "})(); } catch (error) { found = String(error); } "
         "document.body.innerHTML = ''; document.body.append("
         "document.createElement('output')); document.querySelector('output')."
         "textContent = JSON.stringify(found).replace(/[^ -~]|[<>&]/g, c => "
         "'\\\\u' + c.charCodeAt(0).toString(16).padStart(4, '0')); }"
         "</script>";
}

class Browser : public ReportFolder {
protected:
  void SetUp() override {
    if (!has_chromium())
      GTEST_SKIP() << "chromium is not installed; ./asperity test installs it";
    write(result);
  }

  /// The document after it was loaded, as the browser writes it. The browser
  /// may use nothing but the folder and is killed after a minute.
  std::string dom_of(const fs::path& page) const {
    const std::string dom = (folder / "dom.html").string();
    const std::string command =
        "cd " + folder.string() + " && HOME=" + folder.string() +
        " timeout --kill-after=5 60 chromium --headless --no-sandbox "
        "--disable-gpu --disable-dev-shm-usage --no-first-run "
        "--disable-background-networking --host-resolver-rules='MAP * "
        "~NOTFOUND' --user-data-dir=" +
        (folder / "browser").string() +
        " --virtual-time-budget=2000000 --window-size=1280,9000 "
        "--log-net-log=" +
        (folder / "net.json").string() + " --dump-dom file://" + page.string() +
        " < /dev/null > " + dom + " 2> browser.log";
    const int status = std::system(command.c_str());
    EXPECT_EQ(status, 0) << text_of(folder / "browser.log");
    return text_of(dom);
  }

  /// The result of the script `collect` in the page.
  nlohmann::json found_in_page(const std::string& collect) const {
    std::string page = without_policy(text_of(folder / "report.html"));
    page.insert(page.rfind("</body>"), probe_script(collect));
    std::ofstream(folder / "probe.html") << page;
    const std::vector<std::string> found =
        all_between(dom_of(folder / "probe.html"), "<output>", "</output>");
    if (found.empty())
      return "no answer";
    return nlohmann::json::parse(found.front(), nullptr, false);
  }

  results::Result result = synthetic::rough_result(rough, 2);

  std::ptrdiff_t n_pictures() const {
    const fs::directory_iterator figures(folder / "figures");
    return std::count_if(begin(figures), end(figures), [](const auto& file) {
      return file.path().extension() == ".svg";
    });
  }
};

// Three verdicts are ok and one is not, by construction, and each drawn figure
// is a picture within the page.
TEST_F(Browser, ShowsEveryVerdictAndFigure) {
  const std::string dom = dom_of(folder / "report.html");

  EXPECT_EQ(all_between(dom, "<td class=\"word ", "</td>"),
            (std::vector<std::string>{"ok\">✓ ok", "ok\">✓ ok", "ok\">✓ ok",
                                      "failed\">✗ failed"}));
  EXPECT_GE(n_pictures(), 9);
  const std::vector<std::string> pictures = all_between(dom, "<img ", ">");
  EXPECT_EQ(std::ssize(pictures), n_pictures());
  for (const std::string& picture : pictures)
    EXPECT_NE(picture.find(" src=\"data:image/"), std::string::npos);
  EXPECT_EQ(dom.find("could not be drawn"), std::string::npos);
}

// Scripts are those of the page itself, and links lead to its own sections.
TEST_F(Browser, RefersToNothingElsewhere) {
  const std::string dom = dom_of(folder / "report.html");

  for (const char* tag : {"<link", "<iframe", "<object", "<embed", "@import",
                          "url(", " srcset=", "<script src"})
    EXPECT_EQ(dom.find(tag), std::string::npos) << tag;
  for (const std::string& scheme : all_between(dom, " src=\"", ":"))
    EXPECT_EQ(scheme, "data");
  for (const std::string& target : all_between(dom, " href=\"", "\"")) {
    EXPECT_EQ(target.substr(0, 1), "#");
    EXPECT_NE(dom.find(" id=\"" + target.substr(1) + "\""), std::string::npos)
        << target;
  }
}

/// Addresses that the browser requested, without those of its own services.
std::vector<std::string> requests_in(const std::string& log) {
  std::vector<std::string> requests;
  for (const std::string& address : all_between(log, "\"url\":\"", "\"")) {
    const bool is_own = address.find("google") != std::string::npos ||
                        address.find(".gvt1.com/") != std::string::npos;
    if (address.starts_with("http") && !is_own)
      requests.push_back(address);
  }
  return requests;
}

// The page makes no request, and its policy forbids requests of anything that
// would get into it, as well as scripts that are not its own. Without the
// policy the same page does both, which shows that the test can detect it.
TEST_F(Browser, MakesNoRequestAndRunsNoForeignScript) {
  const std::string foreign =
      "<img src=\"http://asperity.invalid/picture\"/><script>document.body."
      "dataset.foreign = 'ran'</script>";
  std::string page = text_of(folder / "report.html");
  page.insert(page.rfind("</body>"), foreign);
  std::ofstream(folder / "foreign.html") << page;
  std::ofstream(folder / "open.html") << without_policy(page);

  const std::string dom = dom_of(folder / "foreign.html");

  EXPECT_NE(dom.find("asperity.invalid"), std::string::npos);
  EXPECT_EQ(dom.find("data-foreign"), std::string::npos);
  EXPECT_EQ(requests_in(text_of(folder / "net.json")),
            std::vector<std::string>());
  EXPECT_NE(dom_of(folder / "open.html").find("data-foreign=\"ran\""),
            std::string::npos);
  EXPECT_FALSE(requests_in(text_of(folder / "net.json")).empty());
}

class Exploring : public Browser {
protected:
  void SetUp() override {
    Browser::SetUp();
    if (!IsSkipped() && chart_library().empty())
      GTEST_SKIP() << "libjs-chart.js is not installed; ./asperity installs it";
  }
};

// The figure is drawn, and the values shown when hovering are those of its
// table: the separations exactly, the pressures, of which the table holds the
// logarithm, to 10 digits.
TEST_F(Exploring, ShowsTheValuesOfTheTable) {
  const nlohmann::json found = found_in_page(
      "const {parts: [part]} = await figure('pressure-gap'); const context = "
      "part.canvas.getContext('2d'); const pixels = context.getImageData(0, 0, "
      "part.canvas.width, part.canvas.height).data; return {inked: "
      "pixels.filter((c, i) => i % 4 === 3 && c > 0).length, curves: "
      "part.chart.data.datasets.map(one => ({label: one.label, x: "
      "one.data.map(p => p.x), y: one.data.map(p => p.y)})), yAxis: "
      "part.chart.scales.y.type, tip: part.configuration().options.plugins."
      "tooltip.callbacks.label({raw: part.points[0][0], dataset: {label: "
      "'theory'}})};");

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
    gaps[label].push_back(row[3]);
  }
  ASSERT_EQ(found.at("curves").size(), 3U); // theory, fem, fit
  for (const nlohmann::json& curve : found.at("curves")) {
    const std::string label = curve.at("label");
    EXPECT_EQ(curve.at("x").get<std::vector<double>>(), gaps.at(label));
    const auto y = curve.at("y").get<std::vector<double>>();
    ASSERT_EQ(y.size(), pressures.at(label).size());
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(y[i] / pressures.at(label)[i], 1.0, 1e-8);
  }
  EXPECT_EQ(found.at("tip").get<std::string>().find("theory: ("), 0U);
}

// A curve can be hidden, an axis made linear, a part enlarged, and all of that
// undone.
TEST_F(Exploring, HidesCurvesChangesAxesAndZooms) {
  const nlohmann::json found = found_in_page(
      "const {parts: [part]} = await figure('pressure-gap'); const chart = "
      "part.chart; const range = () => [chart.scales.x.min, "
      "chart.scales.x.max]; part.toggle(0); const hidden = "
      "!chart.isDatasetVisible(0) && chart.isDatasetVisible(1); "
      "part.toggle(0); const shown = chart.isDatasetVisible(0); "
      "part.setLog('y', false); const linear = chart.scales.y.type; const "
      "whole = range(); const area = chart.chartArea; part.zoom([area.left + "
      "area.width / 4, area.top + 20, area.right - area.width / 4, "
      "area.bottom - 20]); const part_of = range(); part.reset(); return "
      "{hidden, shown, linear, whole, part_of, again: range()};");

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
  const nlohmann::json found = found_in_page(
      "const {parts: [part]} = await figure('pressure-gap'); const {panel, "
      "points} = part; Object.assign(panel.y, {low: undefined, high: "
      "undefined}); panel.curves[0].low = 1; for (const point of points[0]) { "
      "point.low = point.y / 100; point.high = 100 * point.y; } "
      "part.showPoints(); const {min, max} = part.chart.scales.y; return "
      "{below: points[0].filter(point => point.low < min).length, above: "
      "points[0].filter(point => point.high > max).length, all: "
      "points[0].length};");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_GT(found.at("all"), 3);
  EXPECT_EQ(found.at("below"), 0);
  EXPECT_EQ(found.at("above"), 0);
}

// Without a mouse, the arrow keys show the values of the curves, space hides a
// curve, plus enlarges and 0 resets; in a map the arrow keys show values, too.
TEST_F(Exploring, RespondsToTheKeyboard) {
  const nlohmann::json found = found_in_page(
      "const {parts: [part]} = await figure('pressure-gap'); const {parts: "
      "[view]} = await figure('maps-fem'); const press = (one, key) => "
      "one.canvas.dispatchEvent(new KeyboardEvent('keydown', {key})); const "
      "tip = () => part.chart.tooltip.body[0].lines[0]; press(part, "
      "'ArrowRight'); const first = tip(); press(part, 'ArrowRight'); const "
      "second = tip(); press(part, 'ArrowDown'); const other = tip(); const "
      "range = () => part.chart.scales.x.max - part.chart.scales.x.min; const "
      "whole = range(); press(part, '+'); const half = range() / whole; "
      "press(part, '0'); const again = range() / whole; press(part, ' '); "
      "const hidden = !part.chart.isDatasetVisible(part.at.datasetIndex); for "
      "(let i = 0; i < 100 && !view.steps; ++i) await pause(); press(view, "
      "'ArrowRight'); return {first, second, other, half, again, hidden, map: "
      "view.words.textContent};");

  ASSERT_TRUE(found.is_object()) << found;
  const std::string first = found.at("first");
  const std::string second = found.at("second");
  EXPECT_EQ(first.find("theory: ("), 0U) << first;
  EXPECT_EQ(second.find("theory: ("), 0U) << second;
  EXPECT_NE(first, second);
  EXPECT_EQ(found.at("other").get<std::string>().find("fem: ("), 0U);
  EXPECT_NEAR(found.at("half").get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(found.at("again").get<double>(), 1.0, 1e-9);
  EXPECT_TRUE(found.at("hidden").get<bool>());
  EXPECT_EQ(found.at("map").get<std::string>().find("x [µm]: 5.2, "), 0U)
      << found.at("map");
}

// The slider changes the map, and each map holds the values of the result:
// within half of its 2047 steps.
TEST_F(Exploring, ShowsTheMapOfTheLoadOfTheSlider) {
  const nlohmann::json found = found_in_page(
      "const {parts: [view]} = await figure('maps-fem'); const state = async "
      "() => { for (let i = 0; i < 100 && view.loadText.textContent !== "
      "view.stack.frames[view.frame].title; ++i) await pause(); return {load: "
      "view.loadText.textContent, picture: view.canvas.toDataURL(), values: "
      "Array.from(view.steps, (_, i) => view.valueAt(i))}; }; const last = "
      "await state(); view.slider.value = 0; view.slider.dispatchEvent(new "
      "Event('input')); const first = await state(); return {first, last, "
      "words: view.wordsAt(0.5, 0.5)};");

  ASSERT_TRUE(found.is_object()) << found;
  EXPECT_NE(found.at("first").at("load"), found.at("last").at("load"));
  EXPECT_NE(found.at("first").at("picture"), found.at("last").at("picture"));
  EXPECT_EQ(found.at("words").get<std::string>().find("x [µm]: 5, y [µm]: 5;"),
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

TEST_F(Browser, PrintsAPdf) {
  const std::vector<ReportEntry> entries{entry_of(result, rough)};

  const std::vector<std::string> problems =
      write_report(entries, folder, "no-such-gnuplot", {.has_pdf = true});

  for (const std::string& problem : problems)
    EXPECT_EQ(problem.find("report.pdf"), std::string::npos) << problem;
  const std::string pdf = text_of(folder / "report.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_GT(pdf.size(), 20'000U);
}

TEST_F(Browser, ReportsOnceThatTheLibraryIsMissing) {
  ::setenv("ASPERITY_CHART_JS", "/no/such/file.js", 1);
  write(result);
  ::unsetenv("ASPERITY_CHART_JS");

  const std::string dom = dom_of(folder / "report.html");

  EXPECT_EQ(all_between(dom, "because Chart.js is not ", " ").size(), 1U);
  EXPECT_EQ(found_in_page("await figure('maps-fem'); return "
                          "document.querySelectorAll('input[type=range]')"
                          ".length;"),
            1)
      << "maps need no library";
  EXPECT_EQ(std::ssize(all_between(dom, "<img ", ">")), n_pictures());
}

// The browser can draw every picture of the page. A script that the test adds
// to a copy reads their widths in pixels: those of figures.hpp, at least 480; 0
// means that it cannot be decoded.
TEST_F(Browser, CanDrawEveryPicture) {
  std::string probe = without_policy(text_of(folder / "report.html"));
  probe.insert(probe.rfind("</body>"),
               "<script>onload = () => { for (const image of document.images) "
               "image.alt = 'width ' + image.naturalWidth; }</script>");
  std::ofstream(folder / "probe.html") << probe;

  const std::vector<std::string> widths =
      all_between(dom_of(folder / "probe.html"), "alt=\"width ", "\"");

  EXPECT_EQ(std::ssize(widths), n_pictures());
  for (const std::string& width : widths)
    EXPECT_GE(std::stoi(width), 480);
}

} // namespace
} // namespace asperity::reports
