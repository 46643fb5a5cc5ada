// `asperity surface`: parameters, spectrum and predicted contact of measured
// maps and lines, or of the surface of a case.
#include "base/json.hpp"
#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/refusals.hpp"
#include "reports/analysis/summary.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/surface/surface_page.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"
#include "run/arguments/map_case.hpp"
#include "run/arguments/physics.hpp"
#include "run/cli/run_command.hpp"
#include "run/cli/surface_input.hpp"
#include "run/output_folder.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/scan.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <unistd.h>
#include <utility>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Refuses the name of a converted file before any work.
void require_known_ending(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (ending.empty() ||
      (surfaces::written_map_endings() + ",").find(ending + ",") ==
          std::string::npos)
    throw input::InputError(fmt::format("--write {}: the name must end with {}",
                                        file.string(),
                                        surfaces::written_map_endings()));
  if (fs::exists(fs::symlink_status(file)))
    try {
      require_regular_file(file, std::numeric_limits<std::uintmax_t>::max());
    } catch (const FileError& error) {
      throw input::InputError(fmt::format("--write {}", error.what()));
    }
}

bool has_same_bytes(const fs::path& one, const fs::path& other) {
  constexpr auto any = std::numeric_limits<std::uintmax_t>::max();
  return fs::file_size(one) == fs::file_size(other) &&
         read_file(one, any) == read_file(other, any);
}

/// Writes the map, unless the file is there: a file says nowhere that we wrote
/// it, and may be the measurement itself. The same map may be written again.
void write_converted(const SurfaceCommand& command,
                     const reports::SurfaceReport& report) {
  if (report.parts() != 1 || report.maps.empty())
    throw input::InputError("--write converts one map; give one map file");
  const surfaces::MapAnalysis& map = report.maps.front();
  const fs::path target = command.write;
  const fs::path made =
      fs::exists(fs::symlink_status(target))
          ? target.parent_path() /
                fmt::format(".{}.{}", ::getpid(), target.filename().string())
          : target;
  surfaces::write_map(made, map.map, map.name);
  if (made != target) {
    const bool is_same = has_same_bytes(made, target);
    fs::remove(made);
    if (!is_same)
      throw input::InputError(fmt::format(
          "--write {}: is there already, with other content; move it away, or "
          "name another file",
          command.write));
  }
  fmt::print(
      "written: {} (heights in m, {:.6g} x {:.6g} m; levelled as above, keep "
      "them as measured by --level none)\n",
      command.write, map.map.grid.length_x, map.map.grid.length_y);
}

/// Saved fields of a result and where they are in it.
struct FoundFields {
  const results::MethodRecord* method = nullptr;
  const results::Fields* fields = nullptr;
};

/// The fields of the first realisation of the method and step that the command
/// names.
FoundFields fields_of(const results::Result& result,
                      const SurfaceCommand& command) {
  std::string saved;
  FoundFields found;
  for (const results::MethodRecord& method : result.methods) {
    if (method.realizations.empty())
      continue;
    for (const results::Fields& fields : method.realizations.front().fields) {
      saved += fmt::format("{}{} {}", saved.empty() ? "" : ", ", method.name,
                           fields.step);
      const bool is_wanted =
          (command.method.empty()
               ? found.method == nullptr || found.method == &method
               : method.name == command.method) &&
          (command.step < 0 || fields.step == command.step);
      if (is_wanted)
        found = {&method, &fields};
    }
  }
  if (found.fields == nullptr)
    throw input::InputError(fmt::format(
        "{}: has no fields of {}{}; saved are, by method and step: {}",
        result.path,
        command.method.empty() ? "any method" : printable(command.method),
        command.step < 0 ? "" : fmt::format(" in step {}", command.step),
        saved.empty() ? "none" : saved));
  return found;
}

/// Writes a field of a result, or the heights below it, to a map file.
run::ExitCode write_field(const SurfaceCommand& command) {
  if (command.inputs.size() != 1 || command.write.empty())
    throw input::InputError(
        "--field writes a map of one result: surface RESULT --field pressure "
        "--write pressure.gwy");
  const std::string& path = command.inputs.front();
  results::require_readable(path);
  const results::Result result =
      results::read_result(path, results::MapsInFile::large);
  const auto [method, fields] = fields_of(result, command);
  const bool is_pressure = command.field == "pressure";
  const results::SurfaceRecord* surface =
      reports::surface_of(result, *method, 0);
  const bool is_heights = command.field == "heights";
  const results::MapView values = is_pressure          ? fields->pressure_map()
                                  : !is_heights        ? fields->gap_map()
                                  : surface == nullptr ? results::MapView()
                                                       : surface->height_map();
  if (values.empty())
    throw input::InputError(
        fmt::format("{}: the {} is not saved", result.path, command.field));
  const Grid& cell = is_heights ? surface->grid : fields->grid;
  const results::MapInCell shown = command.is_whole_cell ? results::MapInCell{}
                                   : is_heights          ? surface->map
                                                         : fields->map;
  const Grid grid = shown.grid(cell);
  const results::StoredMap shown_values = shown.of(values, cell);
  const surfaces::MapQuantity quantity{command.field, is_pressure ? "Pa" : "m"};
  const std::string title =
      is_heights
          ? "Height"
          : fmt::format("{} of {}, step {}", is_pressure ? "Pressure" : "Gap",
                        method->name, fields->step);
  surfaces::write_map(command.write,
                      {grid, results::MapView(shown_values).whole()}, title,
                      quantity);
  fmt::print("written: {} ({} [{}], p = {:.6g} Pa, {} x {} points, {:.6g} x "
             "{:.6g} m)\n",
             command.write, title, quantity.unit, fields->nominal_pressure,
             grid.points_x, grid.points_y, grid.length_x, grid.length_y);
  if (run::wants_json())
    run::emit_answer(text_of_json(
                         nlohmann::ordered_json{
                             {"written", command.write},
                             {"field", command.field},
                             {"unit", quantity.unit},
                             {"method", method->name},
                             {"step", fields->step},
                             {"nominal_pressure", fields->nominal_pressure},
                             {"points", {grid.points_x, grid.points_y}},
                             {"lengths", {grid.length_x, grid.length_y}}},
                         1) +
                     "\n");
  return run::exit_good;
}

void add_analysis(SurfaceInput input, std::optional<double> tip_radius,
                  reports::SurfaceReport& report) {
  if (auto* line = std::get_if<surfaces::LineScan>(&input.heights)) {
    report.lines.push_back(surfaces::analyse_line(std::move(*line)));
    report.lines.back().name = input.name;
    report.lines.back().origin = input.origin;
    return;
  }
  auto& map = std::get<SurfaceMap>(input.heights);
  report.maps.push_back(
      surfaces::analyse_map(std::move(map.map), map.is_periodic, tip_radius));
  report.maps.back().name = input.name;
  report.maps.back().origin = input.origin;
  report.maps.back().warnings = map.warnings;
}

reports::SurfaceReport analysed(const SurfaceCommand& command) {
  input::Refusals refusals;
  std::optional<double> tip_radius;
  if (!command.tip_radius.empty())
    refusals.of([&] {
      tip_radius = run::positive_quantity("--tip-radius", command.tip_radius,
                                          input::Dimension::length);
    });
  std::optional<double> contact_modulus;
  refusals.of(
      [&] { contact_modulus = run::contact_modulus_of(command.options); });
  reports::SurfaceReport report;
  const auto add = [&](const std::string& word) {
    SurfaceInput input = read_surface_input(word, command);
    if (!command.against.empty())
      put_against(input, read_surface_input(command.against, command));
    try {
      add_analysis(std::move(input), tip_radius, report);
    } catch (const std::domain_error& error) { // flat, or too few points
      throw input::InputError(word + ": " + error.what());
    }
  };
  for (const std::string& word : command.inputs)
    refusals.of([&] {
      run::NamedMaps maps = run::maps_among({word});
      if (maps.folders.empty())
        return add(word);
      run::read_each(maps, [&](const fs::path& file) {
        add(fs::proximate(file).string());
      });
      run::print_left_out(maps);
    });
  refusals.throw_if_any();
  for (surfaces::MapAnalysis& map : report.maps)
    for (const surfaces::MapAnalysis& other : report.maps)
      limit_by_repeat(map.range, map.map, other.map, map.is_periodic);
  report.title =
      report.parts() == 1
          ? report.name_of(0)
          : fmt::format("{} measurements of one surface", report.parts());
  require_reliable(report);
  if (contact_modulus && report.parts() != 1)
    fmt::print(stderr, "contact is predicted for one map or line scan only; "
                       "asperity run presses all of them\n");
  else if (contact_modulus)
    add_contact(report, *contact_modulus, command.gamma);
  return report;
}

run::ExitCode print_channels(const std::vector<std::string>& files) {
  nlohmann::json channels = nlohmann::json::array();
  for (const std::string& file : files) {
    int number = 0;
    for (const surfaces::ChannelInfo& channel : surfaces::list_channels(file)) {
      const std::string title = printable(channel.title);
      const std::string unit = printable(channel.unit);
      fmt::print("{}: {:>2} {:<24} {:<8} {} x {}\n", file, ++number,
                 title.empty() ? "(untitled)" : title,
                 unit.empty() ? "-" : unit, channel.points_x, channel.points_y);
      channels.push_back({{"file", file},
                          {"number", number},
                          {"channel", title},
                          {"unit", unit},
                          {"points", {channel.points_x, channel.points_y}}});
    }
  }
  if (run::wants_json())
    run::emit_answer(text_of_json(channels, 1) + "\n");
  return run::exit_good;
}

fs::path folder_of(const SurfaceCommand& command,
                   const reports::SurfaceReport& report) {
  if (!command.out.empty())
    return command.out;
  return fs::path("out") / (report.parts() == 1
                                ? reports::file_word(report.name_of(0))
                                : std::string("surface"));
}

/// Analyses the inputs, prints the results and writes the report.
/// @throws input::InputError  an input cannot be read, or an option is invalid
run::ExitCode inspect_surface(const SurfaceCommand& command) {
  if (command.lists_channels)
    return print_channels(command.inputs);
  if (!command.write.empty())
    require_known_ending(command.write);
  if (!command.field.empty())
    return write_field(command);
  const reports::ReportExtras extras = extras_of(command.forms);
  const reports::SurfaceReport report = analysed(command);
  fmt::print("{}", surface_text(report));
  if (run::wants_json())
    run::emit_answer(text_of_json(surface_json(report), 1) + "\n");
  if (!command.write.empty())
    write_converted(command, report);
  const bool has_report =
      !command.has_no_report && (!run::wants_json() || !command.out.empty());
  if (!has_report)
    return run::exit_good;
  const fs::path folder = folder_of(command, report);
  const run::OutputFolder lock(
      folder, "surface " + report.title,
      {"spectrum.txt", "surface.json", "report.html", "report.pdf", "figures/"},
      {command.inputs.begin(), command.inputs.end()});
  for (const std::string& problem :
       write_surface_report(report, folder, extras))
    fmt::print(stderr, "warning: figure {}\n", problem);
  fmt::print("report: {}\n", (folder / "report.html").string());
  return run::exit_good;
}

/// How the inputs are read.
void add_input_options(CLI::App* command, SurfaceCommand& surface) {
  command
      ->add_option("input", surface.inputs,
                   "map files, folders of them or line scans of one\n"
                   "surface, or a case")
      ->required();
  command->add_flag("--periodic", surface.is_periodic,
                    "a file continues at its edges; without this, a\n"
                    "window is used for the spectrum");
  add_case_options(command, surface.options,
                   {input::OptionGroup::map, input::OptionGroup::body});
  add_overrides(command, surface.overrides);
  command->add_flag("--channels", surface.lists_channels,
                    "list the channels of the files and end");
}

} // namespace

void add_surface(CommandLine& line) {
  auto [command, surface] = line.add<SurfaceCommand>(
      "surface",
      "Inspect measured maps, line scans or the surface\n"
      "of a case: parameters, spectrum, report.",
      inspect_surface);
  add_input_options(command, surface);
  command->add_option("--against", surface.against,
                      "map of the face that lies on this one: the sum of\n"
                      "both, which --write keeps for asperity run");
  command->add_option("--tip-radius", surface.tip_radius,
                      "radius of the tip, e.g. \"10 nm\": limits the\n"
                      "reliable range");
  command->add_option("--gamma", surface.gamma, "gamma of this theory")
      ->check(CLI::Range(1e-3, 1.0))
      ->capture_default_str();
  command->add_option("--write", surface.write,
                      "also write the levelled map to this file: .npy,\n"
                      ".h5, .gwy, .txt or .x3p");
  command
      ->add_option("--field", surface.field,
                   "with --write, the input is a result, of which this\n"
                   "map is written: pressure, gap or heights")
      ->check(CLI::IsMember({"pressure", "gap", "heights"}));
  command
      ->add_flag("--cell", surface.is_whole_cell,
                 "with --field: the whole cell that was pressed, with\n"
                 "the mirror images of a measured map")
      ->needs(command->get_option("--field"));
  command->add_option("--method", surface.method,
                      "method of this map (default: the first that has\n"
                      "saved fields)");
  command
      ->add_option("--step", surface.step,
                   "load step of this map (default: the last saved one)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--out", surface.out,
                      "output folder (default: out/<name of the file>)");
  command->add_flag("--no-report", surface.has_no_report,
                    "print the numbers only");
  add_report_forms(command, surface.forms);
  add_quiet(command, line.output);
  command->add_flag("--json", line.output.is_json,
                    "print all numbers, or with --channels the list of\n"
                    "channels, as JSON; other text goes to standard\n"
                    "error; write a report only with --out");
  add_example(command,
              "surface map.txt --contact-modulus \"2 GPa\" --figures pdf");
}

} // namespace asperity::cli
