#include "app/run/last_run.hpp"

#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// Removes the figures of a report and the folders that become empty.
void remove_figures(const fs::path& folder) {
  constexpr std::array<std::string_view, 5> endings{".svg", ".gp", ".csv",
                                                    ".pdf", ".png"};
  std::error_code error;
  std::vector<fs::path> folders{folder};
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_directory() && !entry.is_symlink())
      folders.push_back(entry.path());
    else if (std::ranges::find(endings, ending) != endings.end())
      fs::remove(entry.path());
  }
  for (auto empty = folders.rbegin(); empty != folders.rend(); ++empty)
    fs::remove(*empty, error); // fails if the folder is not empty
}

/// Removes the files that methods wrote beside the result, such as
/// "fem-0/block.vtu".
void remove_files_of_methods(const fs::path& folder,
                             const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (std::size_t r = 0; r < method.realizations.size(); ++r)
      fs::remove_all(folder / fmt::format("{}-{}", method.name, r));
}

} // namespace

void remove_report(const fs::path& folder) {
  for (const char* name :
       {"curves.csv", "times.csv", "summary.json", "report.html", "report.pdf",
        "methods.txt", "methods.bib", "paper.json", "output.json"})
    fs::remove(folder / name);
  remove_figures(folder / "figures");
  remove_figures(folder / "journal");
}

void put_last_run_aside(const fs::path& folder) {
  const fs::path last = folder / "result.h5";
  if (!fs::exists(last))
    return;
  bool is_complete = false;
  try {
    results::settle_result(folder);
    const results::Result result =
        results::read_result(folder, results::MapsInFile::large);
    is_complete = result.status == "complete";
    remove_files_of_methods(folder, result);
  } catch (const input::InputError& error) {
    fmt::print("the previous result cannot be read: {}\n", error.what());
  }
  remove_report(folder);
  const fs::path aside =
      folder / (is_complete ? "result.previous.h5" : "result.unfinished.h5");
  fs::rename(last, aside);
  fmt::print("the previous result is saved as {}\n", aside.string());
}

} // namespace asperity::app
