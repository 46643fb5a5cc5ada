// Claims about report.html as a browser sees it, in headless Chromium where it
// is installed: verdicts and pictures are there, and nothing comes from
// elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;

bool has_chromium() {
  return std::system("command -v chromium > /dev/null 2>&1") == 0;
}

// What stands between `before` and the next `after`, everywhere in `text`.
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

class Browser : public ReportFolder {
protected:
  void SetUp() override {
    if (!has_chromium())
      GTEST_SKIP() << "chromium is not installed; ./asperity test installs it";
    write(synthetic::rough_result(rough, 2));
  }

  /// The document after it was loaded, as the browser writes it out again. The
  /// browser may use nothing but the folder and is killed after a minute.
  std::string dom_of(const fs::path& page) const {
    const std::string dom = (folder / "dom.html").string();
    const std::string command =
        "cd " + folder.string() + " && HOME=" + folder.string() +
        " timeout --kill-after=5 60 chromium --headless --no-sandbox "
        "--disable-gpu --disable-dev-shm-usage --no-first-run "
        "--disable-background-networking --host-resolver-rules='MAP * "
        "~NOTFOUND' --user-data-dir=" +
        (folder / "browser").string() + " --dump-dom file://" + page.string() +
        " < /dev/null > " + dom + " 2> browser.log";
    const int status = std::system(command.c_str());
    EXPECT_EQ(status, 0) << text_of(folder / "browser.log");
    return text_of(dom);
  }

  std::ptrdiff_t n_pictures() const {
    const fs::directory_iterator figures(folder / "figures");
    return std::count_if(begin(figures), end(figures), [](const auto& file) {
      return file.path().extension() == ".svg";
    });
  }
};

// Claim: three verdicts are ok and one is not, by construction, and each
// drawn figure is a picture within the page.
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

TEST_F(Browser, RunsNoScriptAndLoadsNothing) {
  const std::string dom = dom_of(folder / "report.html");

  for (const char* tag : {"<script", "<link", "<iframe", "<object", "<embed",
                          "@import", "url(", " href=", " srcset="})
    EXPECT_EQ(dom.find(tag), std::string::npos) << tag;
  for (const std::string& scheme : all_between(dom, " src=\"", ":"))
    EXPECT_EQ(scheme, "data");
}

// Claim: the browser can draw every picture it was given. A script that the
// test adds to a copy asks for their widths in pixels: those of figures.hpp,
// at least 480; 0 is what cannot be decoded.
TEST_F(Browser, CanDrawEveryPicture) {
  std::string probe = text_of(folder / "report.html");
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
