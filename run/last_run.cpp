#include "run/last_run.hpp"

#include "input/input_error.hpp"
#include "reports/figures/journal_figures.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "run/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

constexpr const char* held_folder = ".last-run";

/// Appends the figures of a report below a folder. Other pictures stay.
void append_figures(const fs::path& folder, std::vector<fs::path>& files) {
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if ((!entry.is_directory() || entry.is_symlink()) &&
        !figure_script_of(entry.path()).empty())
      files.push_back(entry.path());
}

/// Returns the files of the report in a folder that exist.
std::vector<fs::path> report_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const std::string& name : report_outputs())
    if (name == "figures/")
      append_figures(folder / "figures", files);
    else if (const fs::path file = name == "journal/" ? "journal" : name;
             fs::exists(fs::symlink_status(folder / file, error)))
      files.push_back(folder / file);
  return files;
}

/// Removes the folders of figures that are empty.
void remove_empty_folders(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> folders{folder / "figures"};
  for (const auto& entry :
       fs::recursive_directory_iterator(folders.front(), error))
    if (entry.is_directory() && !entry.is_symlink())
      folders.push_back(entry.path());
  for (auto empty = folders.rbegin(); empty != folders.rend(); ++empty)
    fs::remove(*empty, error); // fails if the folder is not empty
}

/// Removes what was moved out of the way of a run, except edited figures.
void remove_held(const fs::path& folder) {
  const fs::path held = folder / held_folder;
  reports::keep_edited(held / "journal", folder);
  fs::remove_all(held);
}

/// The folders of files that methods wrote beside the result, such as "fem-0".
std::vector<fs::path> folders_of_methods(const fs::path& folder,
                                         const results::Result& result) {
  std::vector<fs::path> folders;
  for (const results::MethodRecord& method : result.methods)
    for (int r = 0; r < static_cast<int>(method.realizations.size()); ++r)
      if (const fs::path path = folder / files_of_method(method.name, r);
          fs::exists(path))
        folders.push_back(path);
  return folders;
}

/// Moves the changes of a new result into its file. Returns whether it has
/// rows.
bool has_rows(const fs::path& folder) {
  if (!fs::exists(folder / "result.h5"))
    return false;
  results::settle_result(folder);
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  return std::ranges::any_of(
      result.methods, [](const results::MethodRecord& method) {
        return std::ranges::any_of(
            method.realizations,
            [](const results::Curve& curve) { return !curve.points.empty(); });
      });
}

} // namespace

std::string files_of_method(const std::string& method, int realization) {
  return fmt::format("{}-{}", method, realization);
}

LastRun::LastRun(fs::path folder, const std::vector<std::string>& new_folders)
    : folder_(std::move(folder)) {
  const fs::path last = folder_ / "result.h5";
  // Without a result, the report is that of a comparison or of a collection.
  std::vector<fs::path> files = report_files(folder_);
  const bool has_result = fs::exists(last);
  if (has_result)
    try {
      results::settle_result(folder_);
      const results::Result result =
          results::read_result(folder_, results::MapsInFile::large);
      is_complete_ = result.status == "complete";
      for (fs::path& path : folders_of_methods(folder_, result))
        files.push_back(std::move(path));
    } catch (const input::InputError& error) {
      fmt::print("the previous result cannot be read: {}\n", error.what());
    }
  if (!files.empty() || has_result)
    remove_held(folder_); // of a run that was killed
  for (const fs::path& file : files)
    move_aside(file);
  remove_empty_folders(folder_);
  if (has_result) {
    aside_ = folder_ /
             (is_complete_ ? "result.previous.h5" : "result.unfinished.h5");
    if (fs::exists(aside_))
      move_aside(aside_);
    fs::rename(last, aside_);
    fmt::print("the previous result is saved as {}\n", aside_.string());
  }
  for (const std::string& name : new_folders)
    if (!fs::exists(folder_ / name))
      new_folders_.push_back(folder_ / name);
}

void LastRun::move_aside(const fs::path& file) {
  const fs::path held =
      folder_ / held_folder / file.lexically_relative(folder_);
  fs::create_directories(held.parent_path());
  fs::rename(file, held);
  moved_.emplace_back(file, held);
}

void LastRun::end() {
  if (!moved_.empty())
    remove_held(folder_);
}

void LastRun::put_back(bool has_cache) {
  const bool keeps_new = !has_cache && has_rows(folder_);
  if (keeps_new && !is_complete_)
    return end();
  const fs::path result = folder_ / "result.h5";
  if (keeps_new) {
    const fs::path unfinished = folder_ / "result.unfinished.h5";
    fs::rename(result, unfinished);
    fmt::print("the steps computed so far are saved as {}\n",
               unfinished.string());
  }
  for (const char* name : {"result.h5", "result.journal"})
    fs::remove(folder_ / name);
  for (const fs::path& made : new_folders_)
    fs::remove_all(made);
  if (!aside_.empty()) {
    fs::rename(aside_, result);
    fmt::print("the previous result is back as {}\n", result.string());
  }
  for (const auto& [was, held] : moved_) {
    fs::create_directories(was.parent_path());
    fs::rename(held, was);
  }
  end();
}

void put_last_run_aside(const fs::path& folder) {
  LastRun(folder).end();
}

} // namespace asperity::run
