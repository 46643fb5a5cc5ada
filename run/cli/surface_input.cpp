#include "run/cli/surface_input.hpp"

#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_text.hpp"
#include "mechanics/limits.hpp"
#include "run/arguments/map_case.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/arguments/physics.hpp"
#include "surfaces/build.hpp"
#include "surfaces/measured_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// The case that `asperity run MAP` would run, with the options as overrides.
cases::Case case_of_file(const std::string& file,
                         const SurfaceCommand& command) {
  std::vector<std::string> overrides{"surface.level=" + command.level};
  if (command.is_periodic)
    overrides.emplace_back("surface.edges=periodic");
  if (!command.channel.empty())
    overrides.push_back("surface.channel=" +
                        cases::toml_value(command.channel));
  for (std::string& entry :
       run::map_overrides(command.length, command.height_unit))
    overrides.push_back(std::move(entry));
  if (!command.missing_value.empty())
    overrides.push_back("surface.missing_value=" + command.missing_value);
  if (!command.length_unit.empty())
    overrides.push_back("surface.length_unit=" +
                        cases::toml_value(run::length_unit_text(
                            "--length-unit", command.length_unit)));
  overrides.insert(overrides.end(), command.overrides.begin(),
                   command.overrides.end());
  return cases::read_case_text(run::map_case_text({file, "1 Pa"}), file,
                               overrides);
}

std::string level_words(mechanics::Levelling level) {
  if (level == mechanics::Levelling::none)
    return "Mean height removed, not levelled";
  if (level == mechanics::Levelling::plane)
    return "Levelled by the least-squares plane";
  if (level == mechanics::Levelling::bow)
    return "Levelled by the least-squares second-order form";
  return level == mechanics::Levelling::sphere
             ? "Levelled by the least-squares sphere"
             : "Levelled by the least-squares cylinder";
}

SurfaceInput measured_input(const mechanics::SurfaceSpec& surface) {
  const bool is_periodic = surface.edges == mechanics::Edges::periodic;
  surfaces::MeasuredMap measured = surfaces::measured_map(surface);
  SurfaceInput input;
  input.origin =
      fmt::format("{}{}. Read: {}.", level_words(surface.level),
                  is_periodic ? "; periodic" : "; edges not periodic",
                  surfaces::description_of(measured));
  input.heights = SurfaceMap{std::move(measured.map), is_periodic,
                             surfaces::warnings_of(measured.faults)};
  return input;
}

SurfaceInput line_input(const std::string& file,
                        const SurfaceCommand& command) {
  if (!command.missing_value.empty())
    throw input::InputError(
        file + ": --missing-value: the points of a line scan must be measured");
  surfaces::LineScale scale;
  if (!command.length.empty())
    scale.length = run::positive_quantity("--length", command.length,
                                          input::Dimension::length);
  const auto unit = [](const char* option, const std::string& text) {
    return text.empty() ? std::nullopt
                        : std::optional(run::positive_quantity(
                              option, run::length_unit_text(option, text),
                              input::Dimension::length));
  };
  scale.height_unit = unit("--height-unit", command.height_unit);
  scale.length_unit = unit("--length-unit", command.length_unit);
  surfaces::LineScan line = surfaces::read_line_scan(file, scale);
  for (const double height : line.heights)
    if (!(std::abs(height) <= mechanics::largest_length))
      throw input::InputError(fmt::format(
          "{}: a height of {:.3g} m, but lengths must be at most {} m; check "
          "their unit",
          file, height, mechanics::largest_length));
  if (command.level != "none" && command.level != "plane" &&
      command.level != "bow")
    throw input::InputError(
        fmt::format("--level {}: a line scan is levelled by "
                    "none, plane or bow",
                    command.level));
  const int degree = command.level == "none"    ? 0
                     : command.level == "plane" ? 1
                                                : 2;
  surfaces::level_line(line, degree);
  SurfaceInput input;
  input.origin = degree == 0   ? "Line scan; mean height removed."
                 : degree == 1 ? "Line scan; least-squares line removed."
                               : "Line scan; least-squares parabola removed.";
  input.heights = std::move(line);
  return input;
}

SurfaceInput file_input(const std::string& file,
                        const SurfaceCommand& command) {
  const bool has_format = std::ranges::any_of(
      command.overrides, [](const std::string& override_text) {
        return override_text.starts_with("surface.format");
      });
  if (!has_format && surfaces::is_line_scan(file))
    return line_input(file, command);
  try {
    return measured_input(case_of_file(file, command).surface);
  } catch (const input::InputError& error) {
    const std::string message = error.what();
    if (message.find("surface.length_unit is missing") != std::string::npos)
      throw input::InputError(message +
                              "\ngive --length-unit um and --height-unit nm");
    if (message.find("surface.length is missing") != std::string::npos ||
        message.find("surface.height_unit is missing") != std::string::npos)
      throw input::InputError(message +
                              "\ngive --length \"20 um\" and --height-unit nm");
    if (message.find("surface.missing_value =") != std::string::npos)
      throw input::InputError(message + "\ngive --missing-value NUMBER");
    throw;
  }
}

SurfaceInput case_input(const std::string& word,
                        const SurfaceCommand& command) {
  const run::NamedCases named = run::read_named_cases(word, command.overrides);
  if (named.cases.size() != 1)
    throw input::InputError(
        fmt::format("{} is a collection; name one of its parts", word));
  const cases::Case& found = named.cases.front().contact_case;
  const mechanics::SurfaceSpec& surface = found.surface;
  if (surface.kind == mechanics::SurfaceKind::measured)
    return measured_input(surface);
  if (!surface.length || !surface.points)
    throw input::InputError(fmt::format(
        "{}: surface.length and surface.points are missing: the case has only "
        "a formula, no heights; give them by --set",
        found.path));
  SurfaceInput input;
  // The edges at which the images of a single shape meet are not of the shape.
  const bool is_periodic = !surface.has_middle();
  input.origin = fmt::format("{}; {}.",
                             surfaces::is_random(surface.kind)
                                 ? "Realisation 0 of the random surface of the "
                                   "case"
                                 : "The exact shape of the case",
                             is_periodic ? "periodic" : "inside its square");
  input.heights = SurfaceMap{surfaces::build_surface(surface, 0), is_periodic};
  return input;
}

} // namespace

SurfaceInput read_surface_input(const std::string& word,
                                const SurfaceCommand& command) {
  const fs::path path(word);
  const bool is_lost = !fs::exists(path) && path.has_extension();
  if (is_lost)
    throw input::InputError(word + ": there is no such file");
  SurfaceInput input = run::is_map_file(word) ? file_input(word, command)
                                              : case_input(word, command);
  const fs::path name = path.has_filename() ? path : path.parent_path();
  input.name = name.filename() == "case.toml"
                   ? name.parent_path().filename().string()
                   : name.filename().string();
  return input;
}

} // namespace asperity::cli
