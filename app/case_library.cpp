#include "app/case_library.hpp"

#include "cases/case_error.hpp"
#include "cases/nearest.hpp"
#include "cases/read_case.hpp"
#include "cases/reference.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace asperity::app {
namespace {

std::filesystem::path library_folder() {
  return std::filesystem::path(ASPERITY_SOURCE_FOLDER) / "cases";
}

std::set<std::string> shipped_names() {
  std::set<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(library_folder()))
    if (std::filesystem::exists(entry.path() / "case.toml"))
      names.insert(entry.path().filename().string());
  return names;
}

} // namespace

std::filesystem::path find_case(const std::string& word) {
  const std::filesystem::path path(word);
  if (std::filesystem::is_directory(path) &&
      std::filesystem::exists(path / "case.toml"))
    return path / "case.toml";
  if (std::filesystem::is_regular_file(path))
    return path;
  const std::set<std::string> names = shipped_names();
  if (names.contains(word))
    return library_folder() / word / "case.toml";
  throw cases::CaseError(
      word +
      " is neither a case file, nor a folder with a case.toml, nor a "
      "shipped case; nearest shipped case: " +
      cases::nearest(word, {names.begin(), names.end()}) +
      " ('asperity list' shows all)");
}

std::string reference_text_of(const cases::Case& read) {
  const std::filesystem::path path =
      std::filesystem::path(read.path).parent_path() / "reference.csv";
  if (!std::filesystem::exists(path))
    return "";
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf()))
    throw cases::CaseError(path.string() + " cannot be read");
  cases::read_reference_text(text.str(), path.string());
  return text.str();
}

std::vector<ShippedCase> shipped_cases() {
  std::vector<ShippedCase> found;
  for (const std::string& name : shipped_names())
    found.push_back({name, cases::read_case(
                               (library_folder() / name / "case.toml").string())
                               .title});
  return found;
}

} // namespace asperity::app
