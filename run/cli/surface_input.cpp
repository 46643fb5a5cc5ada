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

/// What `asperity run MAP` would read.
mechanics::SurfaceSpec spec_of_file(const std::string& file,
                                    const SurfaceCommand& command) {
  std::vector<std::string> overrides;
  if (command.is_periodic)
    overrides.emplace_back("surface.edges=periodic");
  overrides.insert(overrides.end(), command.overrides.begin(),
                   command.overrides.end());
  return run::map_surface(file, command.options, overrides);
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
  for (const char* option : {"--missing-value", "--remove-spikes", "--cut-off"})
    if (command.options.has(option))
      throw input::InputError(fmt::format(
          "{}: {} applies to maps, but this is a line scan", file, option));
  const auto unit = [&](const char* option) {
    return command.options.has(option)
               ? std::optional(run::positive_quantity(
                     option,
                     run::length_unit_text(option,
                                           command.options.value(option)),
                     input::Dimension::length))
               : std::nullopt;
  };
  surfaces::LineScale scale;
  if (command.options.has("--length"))
    scale.length =
        run::positive_quantity("--length", command.options.value("--length"),
                               input::Dimension::length);
  scale.height_unit = unit("--height-unit");
  scale.length_unit = unit("--length-unit");
  surfaces::LineScan line = surfaces::read_line_scan(file, scale);
  for (const double height : line.heights)
    if (!(std::abs(height) <= mechanics::largest_length))
      throw input::InputError(fmt::format(
          "{}: a height of {:.3g} m, but lengths must be at most {} m; check "
          "their unit",
          file, height, mechanics::largest_length));
  const std::string level = command.options.has("--level")
                                ? command.options.value("--level")
                                : "plane";
  if (level != "none" && level != "plane" && level != "bow")
    throw input::InputError(fmt::format(
        "--level {}: a line scan is levelled by none, plane or bow", level));
  const int degree = level == "none" ? 0 : level == "plane" ? 1 : 2;
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
    return measured_input(spec_of_file(file, command));
  } catch (const input::InputError& error) {
    throw input::InputError(command.options.with_options(
        run::refusal_without_lines(error.what(), file), true));
  }
}

SurfaceInput case_input(const std::string& word,
                        const SurfaceCommand& command) {
  const run::NamedCases named =
      run::read_named_cases(word, command.overrides, false, command.options);
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

void put_against(SurfaceInput& input, const SurfaceInput& other) {
  auto* const map = std::get_if<SurfaceMap>(&input.heights);
  const auto* const face = std::get_if<SurfaceMap>(&other.heights);
  if (map == nullptr || face == nullptr)
    throw input::InputError("--against lays one map on another, but " +
                            (map == nullptr ? input.name : other.name) +
                            " is a line scan");
  constexpr double tolerance = 1e-3;
  const Grid& one = map->map.grid;
  const Grid& two = face->map.grid;
  const auto differ = [](double a, double b) {
    return std::abs(a - b) > tolerance * a;
  };
  if (differ(one.spacing_x(), two.spacing_x()) ||
      differ(one.spacing_y(), two.spacing_y()))
    throw input::InputError(fmt::format(
        "--against {}: its points are {:.4g} x {:.4g} m apart, but must be as "
        "those of {}, {:.4g} x {:.4g} m; please sample one map anew",
        other.name, two.spacing_x(), two.spacing_y(), input.name,
        one.spacing_x(), one.spacing_y()));
  const bool is_whole =
      one.points_x == two.points_x && one.points_y == two.points_y;
  if ((map->is_periodic || face->is_periodic) &&
      !(map->is_periodic && face->is_periodic && is_whole))
    throw input::InputError("--against: both maps must be periodic and of one "
                            "size, or none");
  Grid grid = one;
  grid.points_x = std::min(one.points_x, two.points_x);
  grid.points_y = std::min(one.points_y, two.points_y);
  grid.length_x = one.spacing_x() * grid.points_x;
  grid.length_y = one.spacing_y() * grid.points_y;
  surfaces::HeightMap sum{grid, std::vector<double>(grid.size())};
  for (int y = 0; y < grid.points_y; ++y)
    for (int x = 0; x < grid.points_x; ++x)
      sum.heights[grid.index(x, y)] =
          map->map.heights[one.index(x, y)] +
          face->map.heights[two.index(two.points_x - 1 - x, y)];
  const double mean = surfaces::mean_height(sum);
  for (double& height : sum.heights)
    height -= mean;
  map->map = std::move(sum);
  for (const std::string& warning : face->warnings)
    map->warnings.push_back(other.name + ": " + warning);
  input.origin += fmt::format(" Against it, turned over along x: {}. {}",
                              other.name, other.origin);
  input.name += " against " + other.name;
}

} // namespace asperity::cli
