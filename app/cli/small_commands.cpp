// The commands that do not run a case.
#include "app/cache/cache.hpp"
#include "app/cli/commands.hpp"
#include "app/run/case_library.hpp"
#include "base/atomic_file.hpp"
#include "cases/reader/case_schema.hpp"
#include "cases/reader/documents.hpp"
#include "cases/text/case_error.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::app {

namespace fs = std::filesystem;

ExitCode show_cache(bool is_to_clear) {
  Cache cache(cache_folder(), cache_size());
  if (is_to_clear)
    cache.clear();
  const Cache::Contents contents = cache.contents();
  fmt::print("{}\n{} entries, {:.1f} MB of {:.1f} MB\n",
             cache.folder().string(), contents.entries,
             1e-6 * static_cast<double>(contents.bytes),
             1e-6 * static_cast<double>(cache.most_bytes()));
  return exit_good;
}

ExitCode list_cases() {
  for (const ShippedCase& shipped : shipped_cases())
    fmt::print("{:<24} {}\n", shipped.name, shipped.title);
  return exit_good;
}

ExitCode new_case(const std::string& name) {
  const fs::path file = fs::path(name) / "case.toml";
  if (fs::exists(file))
    throw cases::CaseError(file.string() +
                           " already exists; choose another name");
  fs::create_directories(file.parent_path());
  write_file_atomically(
      file, cases::case_template(fs::path(name).filename().string()));
  fmt::print("{}\nrun it with: asperity run {}\n", file.string(), name);
  return exit_good;
}

ExitCode print_schema() {
  fmt::print("{}\n", cases::json_schema());
  return exit_good;
}

} // namespace asperity::app
