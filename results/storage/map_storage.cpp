#include "results/storage/map_storage.hpp"

#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "results/storage/result_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <mutex>

namespace asperity::results {
namespace {

constexpr int most_points = 1'000'000; ///< per side

/// A number of a SurfaceRecord that is stored as an attribute together with
/// "<name>_unit".
struct SurfaceNumber {
  const char* name;
  const char* unit;
  double SurfaceRecord::*number;
};

constexpr std::array surface_numbers{
    SurfaceNumber{"rms_height", "m", &SurfaceRecord::rms_height},
    SurfaceNumber{"rms_slope", "1", &SurfaceRecord::rms_slope},
    SurfaceNumber{"rms_curvature", "1/m", &SurfaceRecord::rms_curvature},
    SurfaceNumber{"skewness", "1", &SurfaceRecord::skewness},
    SurfaceNumber{"kurtosis", "1", &SurfaceRecord::kurtosis},
    SurfaceNumber{"highest", "m", &SurfaceRecord::highest},
};

Hdf5Shape shape_of(const Grid& grid) {
  return {static_cast<std::size_t>(grid.points_y),
          static_cast<std::size_t>(grid.points_x)};
}

/// Validates a number of points read from a file; 0 means that it is unknown.
int points_in(double points, const std::string& place) {
  if (!(points >= 0.0 && points <= most_points && points == std::floor(points)))
    throw input::InputError(
        fmt::format("{} = {} points, but must be an integer between 0 and {}",
                    place, points, most_points));
  return static_cast<int>(points);
}

/// Reads the lengths of a grid; 0 if unknown.
/// @param has_map  whether there is a map of this size, so that no length is 0
void read_lengths(const Hdf5Group& group, bool has_map, Grid& grid) {
  const auto read = [&](const char* name, double otherwise) {
    if (!group.has_attribute(name))
      return otherwise;
    const double length = group.number_attribute(name);
    if (!(length >= 0.0 && std::isfinite(length)) || (has_map && length == 0.0))
      throw input::InputError(
          fmt::format("{} = {}, but must be finite and {} 0 [m]",
                      group.place(name), length, has_map ? ">" : ">="));
    return length;
  };
  grid.length_x = read("length_x", 0.0);
  grid.length_y = read("length_y", grid.length_x);
}

void set_points(Grid& grid, const std::vector<std::size_t>& extents,
                const std::string& place) {
  grid.points_y = points_in(static_cast<double>(extents[0]), place);
  grid.points_x = points_in(static_cast<double>(extents[1]), place);
}

/// Says which part of its maps is the user's map.
void write_map_in_cell(Hdf5Group& group, const MapInCell& map,
                       const Grid& cell) {
  const Grid own = map.grid(cell);
  group.set_attribute("map_points_x", own.points_x);
  group.set_attribute("map_points_y", own.points_y);
}

/// @return  the whole cell if the file does not say
MapInCell read_map_in_cell(const Hdf5Group& group, const Grid& cell) {
  const auto read = [&](const char* name, int points) {
    const double number = number_or(group, name, points);
    if (!(number >= 1.0 && number <= points && number == std::floor(number)))
      throw input::InputError(fmt::format(
          "{} = {} points, but must be an integer between 1 and {}, the points "
          "of its maps",
          group.place(name), number, points));
    return static_cast<int>(number);
  };
  if (cell.size() == 0)
    return {};
  const MapInCell map{read("map_points_x", cell.points_x),
                      read("map_points_y", cell.points_y)};
  return map.is_whole(cell) ? MapInCell{} : map;
}

Grid read_grid(const Hdf5Group& surface) {
  Grid grid;
  if (surface.has("heights")) {
    const std::vector<std::size_t> extents = surface.extents("heights");
    if (extents.size() != 2)
      throw input::InputError(surface.place("heights") +
                              " must have two dimensions: points_y, points_x");
    set_points(grid, extents, surface.place("heights"));
  } else {
    for (const auto& [name, points] : {std::pair("points_x", &grid.points_x),
                                       std::pair("points_y", &grid.points_y)})
      *points = points_in(number_or(surface, name, 0.0), surface.place(name));
  }
  read_lengths(surface, surface.has("heights"), grid);
  return grid;
}

/// Takes the points from the shape of the map and the lengths from its
/// attributes; 0 if unknown.
Grid grid_of_map(const Hdf5Group& maps) {
  Grid grid;
  const std::vector<std::size_t> extents = maps.extents("pressure");
  if (maps.extents("gap") != extents)
    throw input::InputError(
        fmt::format("{} has [{}] values, but must have [{}], as pressure",
                    maps.place("gap"), fmt::join(maps.extents("gap"), ", "),
                    fmt::join(extents, ", ")));
  if (extents.size() == 2)
    set_points(grid, extents, maps.place("pressure"));
  read_lengths(maps, true, grid);
  return grid;
}

/// Reads rows of a map from a file that is not open.
std::vector<double> rows_in_file(const std::filesystem::path& path,
                                 const std::string& group,
                                 const std::string& name, std::size_t first,
                                 std::size_t count) {
  const std::lock_guard lock(hdf5_mutex());
  try {
    return Hdf5File(path, Hdf5File::Mode::read)
        .open_path(group)
        .rows(name, first, count);
  } catch (const Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

/// Reads a map, or finds it if it is to stay in its file.
void read_map(const Hdf5Group& group, const std::string& name,
              const std::filesystem::path& path, MapsInFile left,
              std::vector<double>& values, StoredMap& stored) {
  group.require_stored(name);
  const std::vector<std::size_t> extents = group.extents(name);
  if (left == MapsInFile::none || extents.size() != 2 || extents[1] == 0 ||
      extents[0] < large_map / extents[1]) {
    values = group.numbers(name);
    return;
  }
  stored = {extents[0], extents[1],
            [path, name, parent = group.path()](std::size_t first,
                                                std::size_t count) {
              return rows_in_file(path, parent, name, first, count);
            }};
}

std::vector<SpectrumPoint> read_spectrum(const Hdf5Group& group) {
  const std::array<std::string, 2> names{"wavevector", "height_spectrum"};
  group.common_length(names);
  const std::vector<double> wavevector = group.column(names[0]);
  const std::vector<double> spectrum = group.column(names[1]);
  std::vector<SpectrumPoint> points;
  for (std::size_t i = 0; i < wavevector.size(); ++i)
    points.push_back({wavevector[i], spectrum[i]});
  return points;
}

void write_spectrum(Hdf5Group group, const std::vector<SpectrumPoint>& points) {
  std::vector<double> wavevector;
  std::vector<double> spectrum;
  for (const SpectrumPoint& point : points) {
    wavevector.push_back(point.wavevector);
    spectrum.push_back(point.spectrum);
  }
  group.append("wavevector", wavevector, Hdf5Number::float64, "rad/m");
  group.append("height_spectrum", spectrum, Hdf5Number::float64, "m^4");
}

} // namespace

void set_with_unit(Hdf5Group& group, const std::string& name, double number,
                   const std::string& unit) {
  group.set_attribute(name, number);
  group.set_attribute(name + "_unit", unit);
}

double number_or(const Hdf5Group& group, const std::string& name,
                 double otherwise) {
  return group.has_attribute(name) ? group.number_attribute(name) : otherwise;
}

/// Returns the index after which a group is named; nothing for any other name.
std::optional<int> index_of(const std::string& name) {
  int index = -1;
  const auto [end, error] =
      std::from_chars(name.data(), name.data() + name.size(), index);
  const bool is_index = error == std::errc() &&
                        end == name.data() + name.size() && index >= 0 &&
                        index < layout::highest_index;
  return is_index ? std::optional(index) : std::nullopt;
}

void write_surface(Hdf5Group& group, const SurfaceRecord& surface,
                   const MapRows& heights) {
  const Grid& grid = surface.grid;
  group.set_attribute("points_x", grid.points_x);
  group.set_attribute("points_y", grid.points_y);
  set_with_unit(group, "length_x", grid.length_x, "m");
  set_with_unit(group, "length_y", grid.length_y, "m");
  write_map_in_cell(group, surface.map, grid);
  for (const auto& [name, unit, number] : surface_numbers)
    set_with_unit(group, name, surface.*number, unit);
  if (heights)
    group.write_map("heights", heights, shape_of(grid), Hdf5Number::float64,
                    "m");
  if (!surface.spectrum.empty())
    write_spectrum(group.open_or_create("spectrum"), surface.spectrum);
}

SurfaceRecord read_surface(const Hdf5Group& group,
                           const std::filesystem::path& path, MapsInFile left) {
  SurfaceRecord surface;
  surface.grid = read_grid(group);
  surface.map = read_map_in_cell(group, surface.grid);
  if (group.has("heights"))
    read_map(group, "heights", path, left, surface.heights,
             surface.stored_heights);
  for (const auto& [name, unit, number] : surface_numbers)
    surface.*number = number_or(group, name, not_a_number);
  if (group.has("spectrum"))
    surface.spectrum = read_spectrum(group.open("spectrum"));
  return surface;
}

void write_fields(Hdf5Group& group, const FieldsChange& fields) {
  const Grid& grid = fields.grid;
  const std::string name = std::to_string(fields.step);
  if (group.has(name))
    group.remove(name);
  Hdf5Group maps = group.open_or_create(name);
  set_with_unit(maps, "nominal_pressure", fields.nominal_pressure, "Pa");
  set_with_unit(maps, "length_x", grid.length_x, "m");
  set_with_unit(maps, "length_y", grid.length_y, "m");
  write_map_in_cell(maps, fields.map, grid);
  const Hdf5Number number =
      fields.has_double_maps ? Hdf5Number::float64 : Hdf5Number::float32_packed;
  maps.write_map("pressure", fields.pressure.rows, shape_of(grid), number,
                 "Pa");
  maps.write_map("gap", fields.gap.rows, shape_of(grid), number, "m");
}

std::vector<Fields> read_fields(const Hdf5Group& group,
                                const std::filesystem::path& path,
                                MapsInFile left) {
  std::vector<Fields> all;
  for (const std::string& name : group.children())
    if (const std::optional<int> step = index_of(name)) {
      const Hdf5Group maps = group.open(name);
      Fields fields;
      fields.step = *step;
      fields.nominal_pressure =
          number_or(maps, "nominal_pressure", not_a_number);
      fields.grid = grid_of_map(maps);
      fields.map = read_map_in_cell(maps, fields.grid);
      read_map(maps, "pressure", path, left, fields.pressure,
               fields.stored_pressure);
      fields.has_double_maps = maps.value_bytes("pressure") >= sizeof(double) &&
                               maps.value_bytes("gap") >= sizeof(double);
      read_map(maps, "gap", path, left, fields.gap, fields.stored_gap);
      all.push_back(std::move(fields));
    }
  std::sort(all.begin(), all.end(),
            [](const Fields& a, const Fields& b) { return a.step < b.step; });
  return all;
}

} // namespace asperity::results
