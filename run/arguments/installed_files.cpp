#include "run/arguments/installed_files.hpp"

#include <stdexcept>
#include <string>
#include <system_error>

namespace asperity::run {
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
