// Tests of report.html as a browser shows it, in headless Chromium where it is
// installed: pictures are there, and nothing is loaded from elsewhere.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "browser.hpp"

namespace asperity::reports::browser_test {

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

  EXPECT_GE(n_pictures(), 9);
  EXPECT_EQ(std::ssize(widths), n_pictures());
  for (const std::string& width : widths)
    EXPECT_GE(std::stoi(width), 480);
}

} // namespace asperity::reports::browser_test
