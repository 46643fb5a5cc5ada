#include "base/child_process.hpp"
#include "base/plain_text.hpp"
#include "base/temporary_folder.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

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

/// The lengths behind a key, which several channels may state [m].
std::vector<double> stated_lengths(std::string_view header,
                                   std::string_view key) {
  constexpr std::string_view blanks = " \t\r\n=:";
  std::vector<double> lengths;
  for (std::size_t at = header.find(key); at != std::string_view::npos;
       at = header.find(key, at + 1)) {
    std::string_view rest = header.substr(at + key.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    const double number =
        number_of_text(line.substr(0, line.find_first_of(" \t")));
    const std::string_view unit =
        line.substr(std::min(line.find_last_of(" \t"), line.size() - 1) + 1);
    if (std::isfinite(number))
      lengths.push_back(number * length_unit(unit).value_or(1.0));
  }
  return lengths;
}

/// Refuses a map whose sides are none of those that the header of its file
/// states in words.
/// @param own  words of the format of the file, if it is one of ours
void require_stated_lengths(std::string_view header, const Grid& grid,
                            const std::string& path,
                            const std::vector<SideWords>& own) {
  std::vector<SideWords> all{{"\\Scan Size:", true}, // Nanoscope
                             {"xLength ", true},     // Agilent
                             {"yLength ", false},
                             {":SCAN_RANGE:", true}, // Nanonis
                             {"XReal", true},        // Gwyddion
                             {"YReal", false}};
  all.insert(all.begin(), own.begin(), own.end());
  constexpr double rounding = 0.01;
  for (const auto& [key, is_along_x] : all) {
    const double side = is_along_x ? grid.length_x : grid.length_y;
    const std::vector<double> stated = stated_lengths(header, key);
    if (!stated.empty() && std::ranges::none_of(stated, [&](double length) {
          return std::abs(side - length) <= rounding * length;
        }))
      throw input::InputError(fmt::format(
          "{}: Gwyddion reads a side of {:.6g} m along {}, but the header of "
          "the file states '{}' {:.6g} m",
          path, side, is_along_x ? 'x' : 'y',
          printable(trimmed(std::string(key))), stated.front()));
  }
}

/// The bytes of a .gwy file, and which program has written it.
struct Converted {
  std::string bytes;
  std::string reader;
};

/// Converts a file to .gwy by the program Gwyddion.
Converted converted(const MapBytes& original) {
  require_file(original);
  const std::string& path = original.name();
  const fs::path program = program_on_path("gwyddion");
  if (program.empty())
    throw input::InputError(fmt::format(
        "{}: no own reader knows this format{}; it can be read where the "
        "program gwyddion is installed (Debian: apt-get install gwyddion)",
        path, name_in_brackets(path)));
  if (const auto refuse = format_of_map(original, "auto").before_conversion)
    refuse(original);
  const TemporaryFolder folder("asperity-map");
  const fs::path target = folder.path() / "converted.gwy";
  const ChildAnswer answer = run_child(
      gwyddion_command({program, "--convert-to-gwy=" + target.string(),
                        fs::absolute(path).string()},
                       folder.path()));
  if (!fs::exists(target) || !answer.end.failure.empty())
    throw input::InputError(fmt::format(
        "{}: cannot be read: no own reader knows this format{}, and Gwyddion "
        "cannot convert it ({})",
        path, name_in_brackets(path),
        answer.output.empty() ? answer.end.failure
                              : first_line(answer.output)));
  std::string bytes =
      input::read_input_file(target, 2 * input::largest_number_file);
  if (!bytes.starts_with("GWYP"))
    throw input::InputError(path + ": Gwyddion wrote no .gwy file");
  return {std::move(bytes), version_of(program, folder.path())};
}

Scan read_converted(const MapBytes& bytes, const ScanRequest& request) {
  const auto [gwy, reader] = converted(bytes);
  Scan scan = read_gwy({gwy, bytes.name()}, request);
  require_stated_lengths(bytes.beginning(), scan.map.grid, bytes.name(),
                         format_of_map(bytes, "auto").sides);
  scan.numbers.is_converted = true;
  scan.reader = reader;
  return scan;
}

std::vector<ChannelInfo> converted_channels(const MapBytes& bytes) {
  const Converted gwy = converted(bytes);
  return gwy_channels({gwy.bytes, bytes.name()});
}

} // namespace

MapFormat converted_format() {
  return {"convert",
          {"any other", "none of these",
           "as Gwyddion reports them; without a unit as `gwy`", "mask; NaN",
           "titles"},
          [](std::string_view) { return true; },
          read_converted,
          converted_channels};
}

} // namespace asperity::surfaces
