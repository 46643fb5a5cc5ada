#include "run/arguments/case_library.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "input/reader/collection.hpp"
#include "input/reader/read_case.hpp"
#include "input/sweeps/sweep.hpp"
#include "input/types/reference.hpp"
#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

// Returns the names of the sub-folders with a case.toml.
std::set<std::string> cases_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "case.toml"))
      names.insert(entry.path().filename().string());
  return names;
}

bool is_collection(const fs::path& folder) {
  return fs::is_directory(folder) && !fs::exists(folder / "case.toml") &&
         !cases_in(folder).empty();
}

std::set<std::string> shipped_collections() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(shipped_cases_folder()))
    if (is_collection(entry.path()))
      names.insert(entry.path().filename().string());
  return names;
}

std::vector<std::string> shipped_words() {
  const std::set<std::string> single = cases_in(shipped_cases_folder());
  std::vector<std::string> words(single.begin(), single.end());
  for (const std::string& collection : shipped_collections()) {
    words.push_back(collection);
    for (const std::string& part :
         cases_in(shipped_cases_folder() / collection))
      words.push_back(collection + "/" + part);
  }
  return words;
}

// Throws unless reports can draw a figure of this name.
void require_figure(const cases::ShownFigure& figure) {
  if (!reports::is_figure_name(figure.name))
    input::throw_mistake(
        figure.place,
        fmt::format("figures.{} has \"{}\", but no figure has this name; "
                    "nearest: {}",
                    figure.part, figure.name,
                    input::nearest(figure.name, reports::figure_names())));
}

FoundCases collection_in(const fs::path& folder, const std::string& name) {
  const std::set<std::string> folders = cases_in(folder);
  cases::Collection collection{{folders.begin(), folders.end()}, {}};
  if (fs::exists(folder / "collection.toml"))
    collection =
        cases::read_collection(folder / "collection.toml", collection.parts);
  FoundCases found{name, folder, {}, {}};
  for (const std::string& part : collection.parts)
    found.cases.push_back({folder / part / "case.toml", name + "/" + part});
  for (const cases::ShownFigure& figure : collection.figures) {
    require_figure(figure);
    found.figures[figure.part].push_back(figure.name);
  }
  return found;
}

FoundCases single(const fs::path& file, const std::string& name) {
  return {"", file.parent_path(), {{file, name}}, {}};
}

} // namespace

bool is_folder_of_cases(const fs::path& folder) {
  return fs::exists(folder / "case.toml") || is_collection(folder);
}

bool is_shipped(const std::string& word) {
  const std::vector<std::string> words = shipped_words();
  return std::ranges::find(words, word) != words.end();
}

FoundCases find_cases(const std::string& word) {
  const fs::path path(word);
  if (fs::is_directory(path) && fs::exists(path / "case.toml"))
    return single(path / "case.toml", "");
  if (fs::is_regular_file(path))
    return single(path, "");
  if (is_collection(path))
    return collection_in(path, fs::canonical(path).filename().string());
  const std::vector<std::string> words = shipped_words();
  const fs::path shipped = shipped_cases_folder() / word;
  if (std::find(words.begin(), words.end(), word) != words.end())
    return is_collection(shipped) ? collection_in(shipped, word)
                                  : single(shipped / "case.toml", word);
  if (fs::exists(fs::symlink_status(path)) && !fs::is_directory(path))
    input::read_input_file(path, input::largest_text_file); // refuses it
  // A far word is no hint.
  const std::string near = input::nearest(word, words);
  const bool is_near =
      2 * static_cast<std::size_t>(input::edit_distance(word, near)) <=
      word.size();
  throw input::InputError(
      (fs::is_directory(path)
           ? word + " is a folder without a case.toml, and no shipped case"
           : "there is no file, folder or shipped case " + word) +
      (is_near ? "; nearest shipped case: " + near : "") +
      " ('asperity list' shows all)");
}

std::string reference_text_of(const cases::Case& read) {
  const fs::path path = fs::path(read.path).parent_path() / "reference.csv";
  if (!fs::exists(path))
    return "";
  std::string text = input::read_input_file(path, input::largest_text_file);
  cases::read_reference_text(text, path.string());
  return text;
}

std::string text_of_file(const fs::path& file) {
  return fs::exists(file)
             ? input::read_input_file(file, input::largest_number_file)
             : "";
}

std::vector<std::string> quick_overrides(const fs::path& file) {
  std::vector<std::string> overrides;
  std::istringstream lines(text_of_file(file.parent_path() / "quick.set"));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != '#')
      overrides.push_back(line);
  return overrides;
}

namespace {

// Returns the title of the case or sweep `word`. An unfinished case does not
// hide the others.
std::string title_of(const std::string& word) {
  const std::string file =
      (shipped_cases_folder() / word / "case.toml").string();
  try {
    return cases::is_sweep(file) ? cases::read_sweep(file).title
                                 : cases::read_case(file).title;
  } catch (const input::InputError&) {
    return fmt::format("(cannot be read; see 'asperity describe {}')", word);
  }
}

} // namespace

std::vector<ShippedCase> shipped_cases() {
  std::vector<ShippedCase> found;
  for (const std::string& word : shipped_words())
    found.push_back({word, is_collection(shipped_cases_folder() / word)
                               ? "collection of all the parts below"
                               : title_of(word)});
  return found;
}

namespace {

namespace fs = std::filesystem;

fs::path installed(const char* folder) {
  std::error_code error; // without /proc there is no installation to be found
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share" / folder;
}

fs::path in_source_tree(const char* folder) {
  return fs::path(ASPERITY_SOURCE_FOLDER) / folder;
}

} // namespace

fs::path shipped_cases_folder() {
  const fs::path beside = installed("asperity/cases");
  const fs::path source = in_source_tree("cases");
  for (const fs::path& folder : {beside, source})
    if (fs::is_directory(folder))
      return folder;
  throw std::runtime_error("the shipped cases are missing; looked in " +
                           beside.string() + " and " + source.string());
}

fs::path documentation_folder() {
  for (const fs::path& folder :
       {installed("doc/asperity"), in_source_tree("docs")})
    if (fs::exists(folder / "index.md"))
      return folder;
  return {};
}

} // namespace asperity::run
