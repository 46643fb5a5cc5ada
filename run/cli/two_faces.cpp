#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "run/arguments/map_case.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/run_command.hpp"
#include "run/cli/surface_input.hpp"
#include "run/output_folder.hpp"
#include "surfaces/formats/map_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* sum_mark = "Sum of two faces, by Asperity";
constexpr std::size_t longest_line = 4096;

/// A comment of the case that is made.
std::string source_line(const std::string& file) {
  const fs::path path = run::path_of_map(file);
  return fmt::format("# {} (SHA-256 {})\n",
                     printable(path.string(), longest_line),
                     content_hash(read_file(path, input::largest_number_file)));
}

/// Writes a sum, unless a file of somebody else has its name.
void write_sum(const SurfaceInput& sum, const fs::path& file) {
  run::require_own_file("--against", file, sum_mark);
  fs::create_directories(file.parent_path());
  surfaces::write_map(file, std::get<SurfaceMap>(sum.heights).map, sum_mark);
}

} // namespace

run::NamedCases read_faces(const RunCommand& command) {
  const std::vector<std::string> files{command.cases.front(), command.against};
  const auto wrong = std::ranges::find_if_not(files, run::is_map_file);
  if (command.cases.size() != 1 || wrong != files.end())
    throw input::InputError(
        "--against lays one map on another: asperity run A --against B, with "
        "two map files" +
        (wrong == files.end()
             ? ""
             : "; there is no map file " + printable(*wrong, longest_line)));
  run::NamedMaps one{{run::path_of_map(files.front())}, {}, {}};
  run::read_maps(one, command.overrides, command.options); // all refusals
  SurfaceCommand reading;
  reading.options = command.options;
  reading.overrides = command.overrides;
  SurfaceInput sum = read_surface_input(files.front(), reading);
  put_against(sum, read_surface_input(files.back(), reading));
  for (const std::string& warning : std::get<SurfaceMap>(sum.heights).warnings)
    fmt::print(stderr, "warning: {}\n", warning);

  const std::string name =
      fmt::format("{}-against-{}", fs::path(files.front()).stem().string(),
                  fs::path(files.back()).stem().string());
  const fs::path file =
      fs::absolute(folder_of(name, command.out, 1) / (name + ".gwy"));
  write_sum(sum, file);
  run::NamedMaps made{{file.lexically_normal()}, {}, {}};
  made.origin = fmt::format("# {}: h(x, y) = h_1(x, y) + h_2(L - x, y) of\n"
                            "{}{}# {}\n",
                            sum_mark, source_line(files.front()),
                            source_line(files.back()),
                            printable(sum.origin, longest_line));
  run::CaseOptions options = command.options;
  for (const input::CaseOption& option : input::case_options())
    if (option.group == input::OptionGroup::map)
      options.place(option.name) = option.name == "--level" ? "none" : "";
  std::vector<std::string> overrides = command.overrides;
  std::erase_if(overrides, [](const std::string& entry) {
    return entry.starts_with("surface.") && !entry.starts_with("surface.edges");
  });
  return run::read_maps(made, overrides, options);
}

} // namespace asperity::cli
