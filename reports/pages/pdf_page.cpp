#include "reports/pages/pdf_page.hpp"

#include "base/atomic_file.hpp"
#include "base/child_process.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;

constexpr const char* weasyprint = "weasyprint";
constexpr double most_seconds = 300.0;

std::vector<std::string> words_for(const fs::path& program,
                                   const fs::path& folder) {
  if (program.filename() == weasyprint)
    return {program, folder / "page.html", folder / "page.pdf"};
  std::vector<std::string> words{
      program,
      "--headless",
      "--disable-gpu",
      "--disable-dev-shm-usage",
      "--no-first-run",
      "--disable-background-networking",
      "--host-resolver-rules=MAP * ~NOTFOUND",
      "--user-data-dir=" + (folder / "browser").string(),
      "--no-pdf-header-footer",
      "--print-to-pdf=" + (folder / "page.pdf").string()};
  if (::geteuid() == 0)
    words.emplace_back("--no-sandbox"); // which the superuser cannot have
  words.push_back("file://" + (folder / "page.html").string());
  return words;
}

/// A folder that is removed at the end.
struct WorkFolder {
  explicit WorkFolder(fs::path made) : path(std::move(made)) {
    fs::create_directories(path);
  }

  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  fs::path path;
};

} // namespace

const char* const no_pdf_program =
    "report.pdf is printed by chromium or weasyprint, but neither is installed "
    "(Debian packages of these names); without --pdf, report.html is complete";

fs::path pdf_program() {
  for (const char* name :
       {"chromium", "chromium-browser", "google-chrome", weasyprint})
    if (fs::path found = program_on_path(name); !found.empty())
      return found;
  return {};
}

std::string print_page(const std::string& html, const fs::path& pdf,
                       const fs::path& program) {
  const WorkFolder folder(fs::absolute(pdf).parent_path() /
                          fmt::format(".print-{}", ::getpid()));
  write_file_atomically(folder.path / "page.html", html);
  ChildCommand command{.words = words_for(program, folder.path),
                       .folder = folder.path,
                       .limits = {.wall_time = most_seconds}};
  command.environment.push_back("HOME=" + folder.path.string());
  try {
    const ChildAnswer answer = run_child(command);
    if (!answer.end.failure.empty())
      return fmt::format("{} ended with {}", program.string(),
                         answer.end.failure);
  } catch (const std::system_error& error) {
    return error.what();
  }
  std::error_code error;
  fs::rename(folder.path / "page.pdf", pdf, error);
  return error ? program.string() + " wrote no PDF" : "";
}

std::string print_report(const std::string& html, const fs::path& folder) {
  const fs::path program = pdf_program();
  const std::string problem =
      program.empty() ? no_pdf_program
                      : print_page(html, folder / "report.pdf", program);
  return problem.empty() ? "" : "report.pdf: " + problem;
}

} // namespace asperity::reports
