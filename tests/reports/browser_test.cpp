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
  std::string page = text_of(report);
  page.insert(page.rfind("</body>"), foreign);
  std::ofstream(folder / "foreign.html") << page;
  std::ofstream(folder / "open.html") << without_policy(page);

  const std::string dom = dom_in_chromium(folder / "foreign.html", folder);

  EXPECT_NE(dom.find("asperity.invalid"), std::string::npos);
  EXPECT_EQ(dom.find("data-foreign"), std::string::npos);
  EXPECT_EQ(requests_in(text_of(folder / "net.json")),
            std::vector<std::string>());
  EXPECT_NE(dom_in_chromium(folder / "open.html", folder)
                .find("data-foreign=\"ran\""),
            std::string::npos);
  EXPECT_FALSE(requests_in(text_of(folder / "net.json")).empty());
}

TEST_F(Browser, PrintsAPdf) {
  const std::vector<std::string> problems =
      write(folder / "pdf", "no-such-gnuplot", {.has_pdf = true});

  for (const std::string& problem : problems)
    EXPECT_EQ(problem.find("report.pdf"), std::string::npos) << problem;
  const std::string pdf = text_of(folder / "pdf/report.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_GT(pdf.size(), 20'000U);
}

// Maps need no library.
TEST_F(Browser, ReportsOnceThatTheLibraryIsMissing) {
  ::setenv("ASPERITY_CHART_JS", "/no/such/file.js", 1);
  write(folder / "without");
  ::unsetenv("ASPERITY_CHART_JS");
  const fs::path without = folder / "without/report.html";

  const nlohmann::json found = found_in_page(
      without,
      "await figure('maps-fem'); return {said: document.body.textContent.split("
      "'because Chart.js' + ' is not ').length - 1, sliders: "
      "document.querySelectorAll('input[type=range]').length, pictures: "
      "document.images.length};");

  EXPECT_EQ(found, (nlohmann::json{{"said", 1},
                                   {"sliders", 1},
                                   {"pictures", n_pictures(without)}}));
}

} // namespace asperity::reports::browser_test
