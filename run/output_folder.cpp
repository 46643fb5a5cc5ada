#include "run/output_folder.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/new_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

bool has_figure_ending(const fs::path& file) {
  constexpr std::array<std::string_view, 5> endings{".svg", ".gp", ".csv",
                                                    ".pdf", ".png"};
  return std::ranges::find(endings, file.extension().string()) != endings.end();
}

/// Returns whether a regular file has this text in its first 64 KiB.
bool has_text(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return false;
  constexpr std::size_t most = std::size_t{1} << 16U; // [B]
  std::string head(most, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), std::ssize(head));
  return std::string_view(head)
             .substr(0, static_cast<std::size_t>(stream.gcount()))
             .find(text) != std::string_view::npos;
}

/// Returns whether one of our commands has written into this folder. Each
/// writes one of these files before others.
bool is_own_folder(const fs::path& folder) {
  constexpr std::pair<const char*, std::string_view> marks[] = {
      {"result.h5", "asperity-result"},
      {"summary.json", "\"asperity-summary\""},
      {"methods.txt", " with Asperity "},
      {"paper.json", "\"asperity-paper\""},
      {"sweep.json", "\"asperity-sweep\""},
      {"sweep.csv", ",status,method,quantity,value,half_width_95,"},
      {"loads.csv", "sample,method,nominal_pressure [Pa],is_unloading,"},
      {"bench.json", "\"asperity-bench\""},
      {"runs/last-run.log", ""}, // of a bench that was interrupted
      {"surface.json", "\"asperity-surface\""},
      {"spectrum.txt", " (limits: "},
      {"board.json", "\"is_as_submitted\""},
      {"stress.csv", "seed,instance,outcome,check,"}};
  return std::ranges::any_of(marks, [&](const auto& mark) {
    return has_text(folder / mark.first, mark.second);
  });
}

[[noreturn]] void refuse(const fs::path& output, const std::string& what) {
  throw input::InputError(
      fmt::format("{}: {}, but this command writes it; move it away, or name "
                  "another --out",
                  output.string(), what));
}

/// Requires a regular file, or a folder if the name ends with '/'. A result may
/// be a link, because results are renamed and never written through.
void require_kind(const fs::path& output, bool is_folder) {
  const fs::file_status status = fs::symlink_status(output);
  if (fs::is_symlink(status) && output.extension() != ".h5")
    refuse(output, "is a symbolic link");
  if (is_folder && !fs::is_directory(status))
    refuse(output, "is no folder");
  if (is_folder)
    return;
  try {
    require_regular_file(output, std::numeric_limits<std::uintmax_t>::max());
  } catch (const FileError& error) {
    throw input::InputError(std::string(error.what()) +
                            "; move it away, or name another --out");
  }
}

/// The first file in a folder of outputs that is not ours; empty: none.
fs::path foreign_file_in(const fs::path& folder) {
  const bool has_figures =
      folder.filename() == "figures" || folder.filename() == "journal";
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (!entry.is_directory() &&
        (!has_figures || (has_figure_ending(entry.path()) &&
                          figure_script_of(entry.path()).empty())))
      return entry.path();
  return {};
}

/// Whether a file lies in a folder, or is the one that it is compared with.
bool is_or_lies_in(const fs::path& file, const fs::path& output) {
  std::error_code error;
  if (fs::equivalent(file, output, error))
    return true;
  for (fs::path at = fs::weakly_canonical(file, error);
       fs::is_directory(output, error) && at != at.parent_path();
       at = at.parent_path())
    if (fs::equivalent(at, output, error))
      return true;
  return false;
}

} // namespace

const OutputNames& report_outputs() {
  static const OutputNames names{
      "curves.csv",       "times.csv",   "summary.json",    "report.html",
      "report.pdf",       "methods.txt", "methods.bib",     "paper.json",
      "sweep.csv",        "loads.csv",   "comparison.json", "comparison.csv",
      "certificate.json", "figures/",    "journal/"};
  return names;
}

OutputNames result_outputs() {
  OutputNames names = report_outputs();
  names.insert(names.end(), {"result.h5", "result.journal",
                             NewOutput::hidden_folder + std::string("/")});
  return names;
}

OutputNames run_outputs(const cases::Case& contact_case) {
  OutputNames names = result_outputs();
  const int realizations = std::max(contact_case.surface.realizations, 1);
  for (const cases::MethodSpec& method : contact_case.methods)
    for (int r = 0; r < realizations; ++r)
      names.push_back(fmt::format("{}-{}/", method.name, r));
  return names;
}

OutputNames sweep_outputs() {
  OutputNames names = result_outputs();
  names.insert(names.end(), {reports::sweep_file, "points/"});
  return names;
}

std::vector<fs::path> input_files(const cases::Case& contact_case) {
  std::vector<fs::path> files{contact_case.path, contact_case.surface.file,
                              contact_case.mesh.file};
  if (contact_case.material.variation)
    files.emplace_back(contact_case.material.variation->file);
  std::erase_if(files, [](const fs::path& file) { return file.empty(); });
  return files;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error))
      files.push_back(entry.path());
  return files;
}

fs::path figure_script_of(const fs::path& file) {
  if (!has_figure_ending(file))
    return {};
  std::string name = file.stem().string();
  for (;;) {
    fs::path script = file.parent_path() / (name + ".gp");
    if (has_text(script, "# gnuplot " + script.filename().string() + "\n"))
      return script;
    const std::size_t dash = name.rfind('-'); // NAME-MAP.csv
    if (dash == std::string::npos)
      return {};
    name.resize(dash);
  }
}

void require_own_outputs(const fs::path& folder, const OutputNames& names,
                         const std::vector<fs::path>& inputs) {
  const bool is_own = is_own_folder(folder);
  for (const std::string& name : names) {
    const bool is_folder = name.ends_with('/');
    const fs::path output =
        folder / (is_folder ? name.substr(0, name.size() - 1) : name);
    if (!fs::exists(fs::symlink_status(output)))
      continue;
    require_kind(output, is_folder);
    for (const fs::path& input : inputs)
      if (is_or_lies_in(input, output))
        refuse(output, fmt::format("holds the input {}", input.string()));
    const bool is_made_case = // plan --slurm has written no more than this
        name == reports::maps_file && has_text(output, reports::maps_mark);
    const fs::path foreign = is_own || is_made_case ? fs::path()
                             : is_folder            ? foreign_file_in(output)
                                                    : output;
    if (!foreign.empty())
      refuse(foreign, "is there already, and Asperity did not write it");
  }
}

OutputFolder::OutputFolder(const fs::path& folder, const std::string& purpose,
                           const OutputNames& names,
                           const std::vector<fs::path>& inputs)
    : lock_(folder, purpose) {
  require_own_outputs(folder, names, inputs);
}

void require_own_file(const std::string& option, const fs::path& file,
                      const std::string& own_text) {
  std::error_code error;
  if (fs::is_regular_file(file, error) && !has_text(file, own_text))
    throw input::InputError(fmt::format(
        "{} {}: is there already, and Asperity did not write it; move it away, "
        "or name another file",
        option, file.string()));
}

} // namespace asperity::run
