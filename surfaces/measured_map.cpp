#include "surfaces/measured_map.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/corrections.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/missing_points.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::SurfaceSpec;

double largest_magnitude(const HeightMap& map) {
  double largest = 0.0;
  for (const double height : map.heights)
    largest = std::max(largest, std::abs(height));
  return largest;
}

/// Uses differences of neighbours inside the map, which need not be periodic.
MapRoughness rms_height_and_slope(const HeightMap& map) {
  const Grid& grid = map.grid;
  const auto mean_square = [&](int step_x, int step_y, double distance) {
    double sum = 0.0;
    for (int iy = 0; iy + step_y < grid.points_y; ++iy)
      for (int ix = 0; ix + step_x < grid.points_x; ++ix)
        sum += std::pow((map.heights[grid.index(ix + step_x, iy + step_y)] -
                         map.heights[grid.index(ix, iy)]) /
                            distance,
                        2);
    return sum / (static_cast<double>(grid.points_x - step_x) *
                  (grid.points_y - step_y));
  };
  return {statistics(map).rms_height,
          std::sqrt(mean_square(1, 0, grid.spacing_x()) +
                    mean_square(0, 1, grid.spacing_y()))};
}

std::size_t missing_of(const FlaggedMap& map) {
  return static_cast<std::size_t>(
      std::count(map.is_missing.begin(), map.is_missing.end(), char{1}));
}

void level_form(HeightMap& map, const SurfaceSpec& surface) {
  const double before = largest_magnitude(map);
  try {
    remove_trend(map, surface.level);
  } catch (const std::domain_error& error) {
    throw input::InputError(
        fmt::format("{}: surface.level: {}", surface.file, error.what()));
  }
  require_relief(surface, before, largest_magnitude(map));
}

} // namespace

ScanRequest request_of_map(const SurfaceSpec& surface) {
  return {surface.format,
          surface.channel,
          {surface.length, surface.height_unit, surface.length_y,
           surface.length_unit}};
}

PixelWindow window_of_map(const SurfaceSpec& surface, const Grid& grid) {
  if (!surface.crop)
    return {0, 0, grid};
  mechanics::MapWindow window = *surface.crop;
  if (window.length_x == 0.0) // reaches to the end of the map
    window.length_x = grid.length_x - window.x;
  if (window.length_y == 0.0)
    window.length_y = grid.length_y - window.y;
  try {
    return pixels_of(grid, window);
  } catch (const std::domain_error& error) {
    throw input::InputError(fmt::format("{}: {}", surface.file, error.what()));
  }
}

void require_relief(const SurfaceSpec& surface, double before, double left) {
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  if (left <= rounding * before)
    throw input::InputError(fmt::format(
        "{}: the surface is flat: after levelling, heights of up to {:.3g} m "
        "remain, the roundoff of the original {:.3g} m; there is no roughness",
        surface.file, left, before));
  constexpr double largest = 1e100; // [m]; spectra contain squares
  if (!(left < largest))
    throw input::InputError(fmt::format(
        "{}: heights of up to {:.3g} m, but they must be below {:.0e} m; check "
        "their unit",
        surface.file, left, largest));
}

void require_few_missing(const SurfaceSpec& surface, std::size_t count,
                         std::size_t size) {
  const auto missing = static_cast<double>(count);
  const double fraction = missing / static_cast<double>(size);
  if (missing > 0.0 && surface.fill == mechanics::Filling::none)
    throw input::InputError(fmt::format(
        "{}: {} of {} points are missing ({:.3g} %), but with surface.fill "
        "= \"none\" none must be",
        surface.file, missing, size, 100.0 * fraction));
  if (fraction > surface.max_missing || fraction == 1.0)
    throw input::InputError(fmt::format(
        "{}: {} of {} points are missing, a fraction of {:.4g}, but at most "
        "surface.max_missing = {:.4g} may be filled; crop the map or raise "
        "that limit",
        surface.file, missing, size, fraction, surface.max_missing));
}

MeasuredMap measured_map(const SurfaceSpec& surface) {
  Scan scan = read_scan(surface.file, request_of_map(surface));
  MeasuredMap measured{{}, scan.channel, scan.reader, 0, 0};
  FlaggedMap map{std::move(scan.map), std::move(scan.is_missing)};
  if (surface.crop)
    crop(map, window_of_map(surface, map.map.grid));
  measured.missing = missing_of(map);
  if (measured.missing == map.map.grid.size())
    require_few_missing(surface, measured.missing, map.map.grid.size());
  if (surface.align_lines == mechanics::LineAlignment::median)
    align_lines(map);
  if (surface.spikes)
    measured.spikes = mark_spikes(map, *surface.spikes);
  require_few_missing(surface, missing_of(map), map.map.grid.size());
  fill_missing(map.map, map.is_missing);
  level_form(map.map, surface);
  measured.map = std::move(map.map);
  return measured;
}

std::string description_of(const MeasuredMap& measured) {
  const auto size = static_cast<double>(measured.map.grid.size());
  std::string text = measured.reader;
  if (!measured.channel.empty())
    text = fmt::format("channel \"{}\", {}", printable(measured.channel), text);
  if (measured.missing > 0)
    text +=
        fmt::format("; {} missing point(s) ({:.2g} %) filled", measured.missing,
                    100.0 * static_cast<double>(measured.missing) / size);
  if (measured.spikes > 0)
    text += fmt::format("; {} spike(s) ({:.2g} %) replaced", measured.spikes,
                        100.0 * static_cast<double>(measured.spikes) / size);
  return text;
}

HeightMap levelled_map(const SurfaceSpec& surface) {
  return measured_map(surface).map;
}

EdgeEffect edge_effect(const SurfaceSpec& surface) {
  const HeightMap before = levelled_map(surface);
  const HeightMap after = with_edges(before, surface.edges);
  return {rms_height_and_slope(before), rms_height_and_slope(after)};
}

} // namespace asperity::surfaces
