#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/own_readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity::surfaces {

std::size_t count_missing(const Scan& scan) {
  return static_cast<std::size_t>(
      std::count(scan.is_missing.begin(), scan.is_missing.end(), char{1}));
}

void multiply_heights(Scan& scan, double factor) {
  for (double& height : scan.map.heights)
    height *= factor;
}

void mark_missing_value(std::span<double> heights, const FileNumbers& numbers,
                        const std::optional<double>& missing_value) {
  constexpr double rounding = 1.5e-6;
  for (const std::optional<double>& number : {missing_value, numbers.missing})
    if (number && std::isfinite(*number)) {
      const double marked = *number * numbers.unit;
      for (double& height : heights)
        if (std::abs(height - marked) <= rounding * std::abs(marked))
          height = std::numeric_limits<double>::quiet_NaN();
    }
}

void mark_missing(Scan& scan, const std::string& name) {
  std::vector<double>& heights = scan.map.heights;
  const auto is_bad = [](double height) { return !std::isfinite(height); };
  if (std::none_of(heights.begin(), heights.end(), is_bad))
    return;
  scan.is_missing.resize(heights.size(), 0);
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (is_bad(heights[i])) {
      scan.is_missing[i] = 1;
      heights[i] = 0.0;
    }
  if (count_missing(scan) == heights.size())
    throw input::InputError(name + ": all points are missing");
}

Grid grid_by_scale(const Grid& points, const std::string& name,
                   const std::string& what, const MapScale& scale) {
  if (!scale.length)
    throw input::InputError(fmt::format("surface.length is missing: {} is {}, "
                                        "which does not give its width",
                                        name, what));
  if (!scale.height_unit)
    throw input::InputError(
        fmt::format("surface.height_unit is missing: {} is "
                    "{}, which does not give the unit of its "
                    "heights",
                    name, what));
  require_positive("length", *scale.length, "m");
  require_positive("height_unit", *scale.height_unit, "m");
  Grid grid = points;
  grid.length_x = *scale.length;
  grid.length_y =
      scale.length_y.value_or(*scale.length * grid.points_y / grid.points_x);
  require_positive("length_y", grid.length_y, "m");
  return grid;
}

Scan scan_by_scale(const Grid& points, std::vector<double> numbers,
                   const std::string& name, const std::string& what,
                   const MapScale& scale) {
  Scan scan{{grid_by_scale(points, name, what, scale), std::move(numbers)},
            {},
            "",
            "",
            {.unit = *scale.height_unit}};
  multiply_heights(scan, *scale.height_unit);
  mark_missing(scan, name);
  return scan;
}

void refuse_scale(const MapScale& scale, const std::string& name) {
  const std::pair<const char*, const std::optional<double>*> keys[] = {
      {"length", &scale.length},
      {"length_y", &scale.length_y},
      {"length_unit", &scale.length_unit},
      {"height_unit", &scale.height_unit}};
  for (const auto& [key, value] : keys)
    if (*value)
      throw input::InputError(
          fmt::format("surface.{} = {:.6g} m, but must be left out: {} itself "
                      "gives its lengths and its unit of height",
                      key, **value, name));
}

void refuse_channel(const ScanRequest& request, const std::string& channel,
                    const std::string& name) {
  if (names_another(request.channel, channel))
    throw input::InputError(fmt::format(
        "surface.channel must be left out: {} has only one channel", name));
}

namespace {

constexpr std::int64_t most_points = 1 << 20; // along a side

} // namespace

bool are_sizes_sound(std::int64_t points_x, std::int64_t points_y) {
  return points_x >= 2 && points_y >= 2 && points_x <= most_points &&
         points_y <= most_points;
}

void require_sound_grid(const std::string& name, std::int64_t points_x,
                        std::int64_t points_y, double bytes_each,
                        std::size_t bytes) {
  if (!are_sizes_sound(points_x, points_y))
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
