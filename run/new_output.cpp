#include "run/new_output.hpp"

#include "input/input_error.hpp"
#include "reports/figures/journal_figures.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "run/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <utility>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

constexpr const char* result_name = "result.h5";
constexpr const char* main_files[] = {result_name, "result.journal",
                                      reports::sweep_file};

bool has_main_file(const fs::path& folder) {
  return fs::exists(folder / result_name) ||
         fs::exists(folder / reports::sweep_file);
}

/// Returns the files of a report that exist in a folder, figures among them.
/// Other pictures are not.
std::vector<fs::path> report_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const std::string& name : report_outputs())
    if (!name.ends_with('/') &&
        fs::exists(fs::symlink_status(folder / name, error)))
      files.push_back(folder / name);
  for (const auto& entry :
       fs::recursive_directory_iterator(folder / "figures", error))
    if ((!entry.is_directory() || entry.is_symlink()) &&
        !figure_script_of(entry.path()).empty())
      files.push_back(entry.path());
  return files;
}

/// Removes a folder and those in it that are empty.
void remove_empty_folders(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> folders{folder};
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.is_directory() && !entry.is_symlink())
      folders.push_back(entry.path());
  for (auto empty = folders.rbegin(); empty != folders.rend(); ++empty)
    fs::remove(*empty, error); // fails if the folder is not empty
}

/// The result of a folder; nothing if it cannot be read.
std::optional<results::Result> readable_result(const fs::path& folder) {
  try {
    if (fs::exists(folder / result_name))
      return results::read_result(folder, results::MapsInFile::large);
  } catch (const input::InputError& error) {
    fmt::print("the previous result cannot be read: {}\n", error.what());
  }
  return std::nullopt;
}

/// The folders of files that methods wrote beside the result, such as "fem-0".
std::vector<fs::path> folders_of_methods(const fs::path& folder) {
  std::vector<fs::path> folders;
  if (const auto result = readable_result(folder))
    for (const results::MethodRecord& method : result->methods)
      for (std::size_t r = 0;
           r < std::max(method.realizations.size(), result->surfaces.size());
           ++r)
        folders.push_back(folder /
                          files_of_method(method.name, static_cast<int>(r)));
  return folders;
}

/// The folders of the points of a sweep. Others beside them are the user's.
std::vector<fs::path> folders_of_points(const fs::path& folder) {
  std::vector<fs::path> folders;
  try {
    if (!fs::exists(folder / reports::sweep_file))
      return folders;
    const std::size_t n = reports::read_sweep_record(folder).points.size();
    for (std::size_t i = 0; i < n; ++i)
      folders.push_back(folder / reports::point_folder(i));
  } catch (const input::InputError& error) {
    fmt::print("the previous sweep cannot be read: {}\n", error.what());
  }
  return folders;
}

/// Whether a method writes a file of this name into its folder: the steps of a
/// full block for ParaView, the atoms of a step, and what LAMMPS exchanges.
/// @param file  relative to the folder of the method
bool is_file_of_method(const fs::path& file) {
  static const std::regex names(
      R"(block(_surface)?(_\d{4,}(\.\d{4,})?)?\.(vtu|pvtu|pvd)|)"
      R"(step-\d{4,}\.xyz|)"
      R"(lammps/(block\.data|pair\.table|step\.in|energies\.txt|)"
      R"((start|answer|contact)\.dump|lammps-version\.txt|log\.lammps|)"
      R"(step-\d{4,}\.(log|log\.out|dump)))");
  return std::regex_match(file.generic_string(), names);
}

/// Removes what a method wrote into its folder, and the folder if nothing of
/// the user's is in it.
void remove_files_of_method(const fs::path& folder) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(folder, error)))
    return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if ((!entry.is_directory() || entry.is_symlink()) &&
        is_file_of_method(entry.path().lexically_relative(folder)))
      files.push_back(entry.path());
  for (const fs::path& file : files)
    fs::remove(file);
  remove_empty_folders(folder);
}

/// Removes what belongs to the result or the sweep in a folder, and leaves
/// that.
void remove_report(const fs::path& folder) {
  reports::keep_edited(folder / "journal", folder);
  fs::remove_all(folder / "journal");
  for (const fs::path& path : folders_of_methods(folder))
    remove_files_of_method(path);
  for (const fs::path& file : report_files(folder))
    fs::remove(file);
  remove_empty_folders(folder / "figures");
  for (const fs::path& point : folders_of_points(folder))
    remove_run(point);
  remove_empty_folders(folder / "points");
}

bool is_complete(const fs::path& place) {
  const auto result = readable_result(place);
  return result && result->status == "complete";
}

/// Moves all files of a folder into another one, the result or the sweep first:
/// where it is missing, only its report was still to be moved.
void move_files(const fs::path& from, const fs::path& to) {
  const bool is_whole = has_main_file(from);
  for (const char* name : main_files) {
    if (fs::exists(from / name))
      fs::rename(from / name, to / name);
    else if (is_whole)
      fs::remove(to / name);
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (!entry.is_directory())
      files.push_back(entry.path());
  for (const fs::path& file : files) {
    const fs::path target = to / file.lexically_relative(from);
    fs::create_directories(target.parent_path());
    fs::rename(file, target);
  }
  fs::remove_all(from);
}

} // namespace

std::string files_of_method(const std::string& method, int realization) {
  return fmt::format("{}-{}", method, realization);
}

void remove_output(const fs::path& folder) {
  remove_report(folder);
  for (const char* name : main_files)
    fs::remove(folder / name);
}

void remove_run(const fs::path& folder) {
  fs::remove_all(folder / NewOutput::hidden_folder);
  remove_output(folder);
  for (const char* name : {"log.txt", ".lock"})
    fs::remove(folder / name);
  remove_empty_folders(folder);
}

fs::path latest_output(const fs::path& folder) {
  const fs::path hidden = folder / NewOutput::hidden_folder;
  return has_main_file(hidden) ? hidden : folder;
}

NewOutput::NewOutput(fs::path folder, bool resume, const char* main_file)
    : folder_(std::move(folder)), place_(folder_ / hidden_folder) {
  const fs::path hidden = place_;
  if (fs::exists(hidden) && !has_main_file(hidden))
    move_files(hidden, folder_); // a run was killed when it did so
  else if (is_complete(hidden))
    replace();
  if (resume && fs::exists(hidden / main_file))
    return;
  fs::remove_all(hidden);
  const bool has_output =
      has_main_file(folder_) || !report_files(folder_).empty();
  const bool continues = resume && fs::exists(folder_ / main_file);
  place_ = has_output && !continues ? hidden : folder_;
  fs::create_directories(place_);
}

void NewOutput::replace() {
  if (place_ == folder_)
    return;
  results::settle_result(place_);
  remove_report(folder_);
  move_files(place_, folder_);
  place_ = folder_;
}

void NewOutput::drop() {
  const auto result = readable_result(place_);
  const auto has_steps = [](const results::MethodRecord& method) {
    return std::ranges::any_of(
        method.realizations,
        [](const results::Curve& curve) { return !curve.points.empty(); });
  };
  if (result && std::ranges::any_of(result->methods, has_steps))
    return;
  if (place_ != folder_)
    fs::remove_all(place_);
  else if (result)
    remove_output(folder_);
}

} // namespace asperity::run
