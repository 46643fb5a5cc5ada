#pragma once

// Report pages as headless Chromium shows them; tests are skipped where it is
// not installed.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports {

namespace fs = std::filesystem;

inline bool has_chromium() {
  return std::system("command -v chromium > /dev/null 2>&1") == 0;
}

// The text between `before` and the next `after`, everywhere in `text`.
inline std::vector<std::string> all_between(const std::string& text,
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
inline std::string without_policy(std::string page) {
  const std::size_t at = page.find("<meta http-equiv");
  EXPECT_NE(at, std::string::npos);
  return page.erase(at, page.find('\n', at) - at);
}

/// A script that waits for the figures and writes what `collect` returns into
/// the page, for the test to read.
inline std::string probe_script(const std::string& collect) {
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

/// The document after it was loaded, as the browser writes it. The browser may
/// use nothing but the folder and is killed after a minute.
inline std::string dom_in_chromium(const fs::path& page,
                                   const fs::path& folder) {
  const std::string dom = (folder / "dom.html").string();
  const std::string command =
      "cd " + folder.string() + " && HOME=" + folder.string() +
      " timeout --kill-after=5 60 chromium --headless --no-sandbox "
      "--disable-gpu --disable-dev-shm-usage --no-first-run "
      "--disable-background-networking --host-resolver-rules='MAP * "
      "~NOTFOUND' --user-data-dir=" +
      (folder / "browser").string() +
      " --virtual-time-budget=2000000 --window-size=1280,9000 --log-net-log=" +
      (folder / "net.json").string() + " --dump-dom file://" + page.string() +
      " < /dev/null > " + dom + " 2> browser.log";
  const int status = std::system(command.c_str());
  EXPECT_EQ(status, 0) << text_of(folder / "browser.log");
  return text_of(dom);
}

/// What the script `collect` returns in a copy of the page, which may be none
/// of ours; "no answer" if there is none.
inline nlohmann::json found_in_page(const fs::path& report,
                                    const std::string& collect) {
  const fs::path folder = report.parent_path();
  std::string page = without_policy(text_of(report));
  page.insert(page.rfind("</body>"), probe_script(collect));
  std::ofstream(folder / "probe.html") << page;
  const std::vector<std::string> found = all_between(
      dom_in_chromium(folder / "probe.html", folder), "<output>", "</output>");
  if (found.empty())
    return "no answer";
  return nlohmann::json::parse(found.front(), nullptr, false);
}

/// The pictures of a report.
inline std::ptrdiff_t n_pictures(const fs::path& report) {
  const fs::directory_iterator figures(report.parent_path() / "figures");
  return std::count_if(begin(figures), end(figures), [](const auto& file) {
    return file.path().extension() == ".svg";
  });
}

/// A report that is written once for all tests of a suite.
class Browser : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    if (!has_chromium())
      return;
    rough = synthetic::contact_case();
    result = synthetic::rough_result(rough, 2);
    write(folder);
  }

  static void TearDownTestSuite() {
    std::error_code ignored; // of a browser that is still removing its files
    fs::remove_all(folder, ignored);
    result = {};
  }

  void SetUp() override {
    if (!has_chromium())
      GTEST_SKIP() << "skipped: needs chromium";
  }

  static std::vector<std::string> write(const fs::path& to,
                                        const std::string& gnuplot = "gnuplot",
                                        const ReportExtras& extras = {}) {
    const ReportEntry entry = entry_of(result, rough);
    return write_report(std::span(&entry, 1), to, gnuplot, extras);
  }

  inline static cases::Case rough;
  inline static results::Result result;
  inline static const fs::path folder =
      fs::temp_directory_path() /
      ("asperity-browser-" + std::to_string(::getpid()));
  inline static const fs::path report = folder / "report.html";
};

} // namespace asperity::reports
