#include "base/child_process.hpp"
#include "base/plain_text.hpp"
#include "base/temporary_folder.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/scan_formats.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::surfaces {
namespace {

namespace fs = std::filesystem;

ChildCommand gwyddion_command(std::vector<std::string> words,
                              const fs::path& folder) {
  ChildCommand command;
  command.words = std::move(words);
  command.folder = folder;
  // Settings and plug-ins of the user must not change what is read.
  command.environment = {"HOME=" + folder.string(), "PATH=/usr/bin:/bin",
                         "LC_ALL=C.UTF-8"};
  command.limits = {.wall_time = 60.0,
                    .cpu_time = 60.0,
                    .memory = std::size_t{8} * 1024 * input::mebibyte,
                    .file_size = 2 * input::largest_number_file};
  return command;
}

/// "Gwyddion 2.62" of "Gwyddion 2.62 (2022-11-03)".
std::string version_of(const std::string& program, const fs::path& folder) {
  const ChildAnswer answer =
      run_child(gwyddion_command({program, "--version"}, folder));
  const std::size_t second =
      answer.output.find(' ', answer.output.find(' ') + 1);
  return printable(answer.output.substr(0, second), 40);
}

std::string first_line(const std::string& text) {
  return printable(text.substr(0, text.find('\n')), 200);
}

/// Converts a file to .gwy and returns the bytes.
std::string converted(const std::string& program, const std::string& path,
                      const fs::path& folder) {
  const fs::path target = folder / "converted.gwy";
  const ChildAnswer answer = run_child(
      gwyddion_command({program, "--convert-to-gwy=" + target.string(),
                        fs::absolute(path).string()},
                       folder));
  if (!fs::exists(target) || !answer.end.failure.empty())
    throw input::InputError(fmt::format(
        "{}: cannot be read: no own reader knows this format{}, and Gwyddion "
        "cannot convert it ({})",
        path, name_in_brackets(path),
        answer.output.empty() ? answer.end.failure
                              : first_line(answer.output)));
  return input::read_input_file(target, 2 * input::largest_number_file);
}

} // namespace

FileContent read_converted_file(const std::string& path,
                                const ScanRequest& request, Asked asked) {
  const fs::path program = program_on_path("gwyddion");
  if (program.empty())
    throw input::InputError(fmt::format(
        "{}: no own reader knows this format{}; it can be read where the "
        "program gwyddion is installed (Debian: apt-get install gwyddion)",
        path, name_in_brackets(path)));
  const TemporaryFolder folder("asperity-map");
  const std::string bytes = converted(program, path, folder.path());
  if (!bytes.starts_with("GWYP"))
    throw input::InputError(path + ": Gwyddion wrote no .gwy file");
  FileContent content = read_gwy_file(bytes, path, request, asked);
  content.scan.reader = version_of(program, folder.path());
  return content;
}

} // namespace asperity::surfaces
