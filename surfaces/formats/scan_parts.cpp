#include "base/file_bytes.hpp"
#include "base/read_file.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

namespace asperity::surfaces {

MapBytes MapBytes::of_file(const std::string& path) {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 16;
  try {
    require_regular_file(path, input::largest_number_file);
  } catch (const FileError& error) {
    throw input::InputError(error.what());
  }
  const std::optional<FileBytes> file = FileBytes::of(path);
  if (!file)
    throw input::InputError(path + ": cannot be read (" +
                            std::generic_category().message(errno) + ")");
  MapBytes bytes({}, path);
  bytes.is_file_ = true;
  bytes.beginning_.resize(
      static_cast<std::size_t>(std::min(most, file->size())));
  bytes.beginning_.resize(file->read_some(0, bytes.beginning_));
  return bytes;
}

std::string_view MapBytes::beginning() const {
  return is_file_ ? std::string_view(beginning_) : all_;
}

std::string_view MapBytes::all() const {
  if (is_file_ && read_ == nullptr)
    read_ = std::make_shared<const std::string>(
        input::read_input_file(name_, input::largest_number_file));
  return is_file_ ? std::string_view(*read_) : all_;
}

Scan scan_of_numbers(const Grid& grid, std::vector<double> values,
                     const std::string& reader, const FileNumbers& numbers) {
  for (double& value : values)
    value *= numbers.unit;
  return {{grid, std::move(values)}, "", reader, numbers};
}

void require_file(const MapBytes& bytes) {
  if (!bytes.is_file())
    throw input::InputError(bytes.name() +
                            ": this format is read from files only");
}

Grid grid_by_scale(const Grid& points, const std::string& name,
                   const std::string& what, const MapScale& scale) {
  std::string missing;
  if (!scale.length)
    missing = fmt::format("surface.length is missing: {} is {}, which does not "
                          "give its width",
                          name, what);
  if (!scale.height_unit)
    missing += fmt::format("{}surface.height_unit is missing: {} is {}, which "
                           "does not give the unit of its heights",
                           missing.empty() ? "" : "\n", name, what);
  if (!missing.empty())
    throw input::InputError(missing);
  require_positive("length", *scale.length, "m");
  require_positive("height_unit", *scale.height_unit, "m");
  Grid grid = points;
  grid.length_x = *scale.length;
  // A ratio of 1 is exact: as many rows as columns are a square, which atoms
  // need.
  const double sides = static_cast<double>(grid.points_y) / grid.points_x;
  grid.length_y = scale.length_y.value_or(*scale.length * sides);
  require_positive("length_y", grid.length_y, "m");
  return grid;
}

void refuse_given(const char* key, const std::optional<double>& value,
                  const std::string& why) {
  if (value)
    throw input::InputError(fmt::format(
        "surface.{} = {:.6g} m, but must be left out: {}", key, *value, why));
}

void refuse_scale(const MapScale& scale, const std::string& name) {
  const std::string why =
      name + " itself gives its lengths and its unit of height";
  refuse_given("length", scale.length, why);
  refuse_given("length_y", scale.length_y, why);
  refuse_given("length_unit", scale.length_unit, why);
  refuse_given("height_unit", scale.height_unit, why);
}

void refuse_channel(const ScanRequest& request, const std::string& channel,
                    const std::string& name) {
  if (request.channel && *request.channel != channel && *request.channel != "1")
    throw input::InputError(fmt::format(
        "surface.channel must be left out: {} has only one channel", name));
}

void require_sound_grid(const std::string& name, std::int64_t points_x,
                        std::int64_t points_y, double bytes_each,
                        std::uintmax_t bytes) {
  constexpr std::int64_t most_points = 1 << 20; // along a side
  if (std::min(points_x, points_y) < 2 ||
      std::max(points_x, points_y) > most_points)
    throw input::InputError(
        fmt::format("{}: has {} x {} points, but a map must "
                    "have 2 to {} along each side",
                    name, points_x, points_y, most_points));
  const double needed = static_cast<double>(points_x) *
                        static_cast<double>(points_y) * bytes_each;
  if (needed > static_cast<double>(bytes))
    throw input::InputError(fmt::format(
        "{}: has {} x {} points according to its header, which need {:.0f} "
        "bytes, but only {} follow",
        name, points_x, points_y, needed, bytes));
}

void require_sound_lengths(const std::string& name, const Grid& grid) {
  for (const double length : {grid.length_x, grid.length_y})
    if (!std::isfinite(length) || length <= 0.0)
      throw input::InputError(
          fmt::format("{}: has a side length of {:.6g} m, but it must be > 0",
                      name, length));
}

} // namespace asperity::surfaces
