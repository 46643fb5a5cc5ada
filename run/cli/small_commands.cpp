// The commands that do not run a case.
#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "input/input_error.hpp"
#include "input/reader/case_schema.hpp"
#include "input/reader/case_text.hpp"
#include "input/reader/documents.hpp"
#include "input/reader/read_case.hpp"
#include "run/arguments/case_library.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/command_line.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/output.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::cli {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// Reads the map, so that a case is written only if it can be run, and prints
/// what the loads of the case follow from.
void print_map(const mechanics::SurfaceSpec& surface) {
  const surfaces::HeightMap map = surfaces::levelled_map(surface);
  const surfaces::Statistics numbers =
      surfaces::statistics(surfaces::with_edges(map, surface.edges));
  fmt::print("{}: {} x {} points, {:.4g} x {:.4g} um, h_rms = {:.4g} um, h' = "
             "{:.4g}\n",
             surface.file, map.grid.points_x, map.grid.points_y,
             1e6 * map.grid.length_x, 1e6 * map.grid.length_y,
             1e6 * numbers.rms_height, numbers.rms_slope);
}

/// Prints the location of the cache and how much of it is used.
run::ExitCode show_cache(const bool& is_to_clear) {
  methods::Cache cache(methods::cache_folder(), methods::cache_size());
  if (is_to_clear)
    cache.clear();
  const methods::Cache::Contents contents = cache.contents();
  if (run::wants_json()) {
    run::emit_answer(text_of_json(Json{{"folder", cache.folder().string()},
                                       {"entries", contents.entries},
                                       {"size [bytes]", contents.bytes},
                                       {"limit [bytes]", cache.most_bytes()}},
                                  2) +
                     "\n");
    return run::exit_good;
  }
  fmt::print("{}\n{} entries, {:.1f} MB of {:.1f} MB\n",
             cache.folder().string(), contents.entries,
             1e-6 * static_cast<double>(contents.bytes),
             1e-6 * static_cast<double>(cache.most_bytes()));
  return run::exit_good;
}

run::ExitCode list_cases(const bool&) {
  Json list = Json::array();
  for (const run::ShippedCase& shipped : run::shipped_cases()) {
    list.push_back({{"name", shipped.name}, {"title", shipped.title}});
    if (!run::wants_json())
      fmt::print("{:<24} {}\n", shipped.name, shipped.title);
  }
  if (run::wants_json())
    run::emit_answer(text_of_json(list, 2) + "\n");
  return run::exit_good;
}

struct NewCommand {
  std::string name;                   ///< folder to create
  std::string map;                    ///< "": the template
  run::CaseOptions options;           ///< of the map
  std::vector<std::string> overrides; ///< "key.path=value"
};

/// Writes the file name/case.toml: a template, or the case of a map.
run::ExitCode new_case(const NewCommand& made) {
  const fs::path file = fs::path(made.name) / "case.toml";
  if (fs::exists(file))
    throw input::InputError(file.string() +
                            " already exists; choose another name");
  const bool has_map = !made.map.empty();
  if (!has_map && !made.options.empty())
    throw input::InputError("options of maps, bodies and physics need --map; "
                            "the template states these by its keys");
  const std::string text = cases::text_with_overrides(
      has_map ? run::text_of_map(made.map, made.options, made.overrides, file)
              : cases::case_template(fs::path(made.name).filename().string()),
      made.overrides);
  cases::Case read = cases::read_case_text(text, file.string());
  read.surface.file = made.map; // its folder does not exist yet
  if (has_map)
    print_map(read.surface);
  fs::create_directories(file.parent_path());
  write_file_atomically(file, text);
  fmt::print("{}\nrun it with: asperity run {}\n", file.string(), made.name);
  return run::exit_good;
}

run::ExitCode print_schema(const bool&) {
  fmt::print("{}\n", cases::json_schema());
  return run::exit_good;
}

void add_new(CommandLine& line) {
  auto [command, made] = line.add<NewCommand>(
      "new", "Write a commented case file to start from.", new_case);
  command->add_option("name", made.name, "folder to create for case.toml")
      ->required();
  command->add_option("--map", made.map,
                      "the case presses this measured map, with loads\n"
                      "that suit it");
  add_case_options(command, made.options);
  add_overrides(command, made.overrides);
  add_quiet(command, line.output);
  add_example(command, "new my-case --map map.x3p --contact-modulus \"2 GPa\"");
}

} // namespace

void add_cache(CommandLine& line) {
  auto [command, is_to_clear] =
      line.add<bool>("cache",
                     "Show the folder of the step cache, its size\n"
                     "and the number of its entries.",
                     show_cache);
  command->add_flag("--clear", is_to_clear, "remove all entries first");
  add_quiet(command, line.output);
  add_json(command, line.output, "folder and size");
  add_example(command, "cache");
}

void add_small_commands(CommandLine& line) {
  add_new(line);
  auto [list, unused] =
      line.add<bool>("list", "List the shipped cases.", list_cases);
  add_json(list, line.output, "names and titles");
  add_example(list, "list");
  add_example(line.add<bool>("schema", "Print the JSON Schema of a case file.",
                             print_schema)
                  .first,
              "schema > case.schema.json");
}

} // namespace asperity::cli
