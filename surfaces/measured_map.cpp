#include "surfaces/measured_map.hpp"

#include "base/maximum.hpp"
#include "base/plain_text.hpp"
#include "base/shown_number.hpp"
#include "input/case_options.hpp"
#include "input/input_error.hpp"
#include "mechanics/limits.hpp"
#include "surfaces/analysis/reliable_range.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/corrections.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/resample.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace asperity::surfaces {

namespace {

/// An end of the range of all heights, as its sign times the heights.
struct RangeEnd {
  double outer = 0.0;  ///< the largest
  double inner = 0.0;  ///< the largest of the others; -infinity: there is none
  double range = 0.0;  ///< of the others
  double points = 0.0; ///< whose height is the largest

  /// Whether it is farther from the others than a fraction of their range.
  bool is_apart(double fraction) const {
    return outer - inner > fraction * range;
  }
};

RangeEnd range_end(std::span<const double> heights, double sign) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto largest_of = [&](double factor, double below) {
    double largest = none;
    for (const double height : heights)
      if (std::isfinite(height) && factor * height < below)
        largest = std::max(largest, factor * height);
    return largest;
  };
  RangeEnd end;
  end.outer = largest_of(sign, std::numeric_limits<double>::infinity());
  end.inner = largest_of(sign, end.outer);
  end.range = end.inner + largest_of(-sign, -none);
  end.points =
      static_cast<double>(std::ranges::count(heights, sign * end.outer));
  return end;
}

/// Whether a number is a usual mark, as the file writes it or converted between
/// units of length.
bool is_usual_mark(double number) {
  static constexpr double marks[] = {
      -999.0,    -9999.0,  9999.0,  -99999.0, 99999.0,       999999.0,
      -999999.0, -32768.0, 32767.0, 65535.0,  -2147483648.0, 2147483647.0};
  static constexpr double units[] = {1.0, 1e-3, 1e-6, 1e-9, 1e-10, 1e-12};
  constexpr double rounding = 1e-7; // of single precision
  return std::ranges::any_of(marks, [&](double mark) {
    return std::ranges::any_of(units, [&](double unit) {
      return std::abs(number - mark * unit) <= rounding * std::abs(mark * unit);
    });
  });
}

/// Refuses a map whose least or largest number marks missing points. That is:
/// its magnitude is 1e20 or more; or it is one of the usual marks (-9999,
/// -32768, 65535, ...), also after a conversion between units of length, and
/// farther from the other numbers than 1/8 of their range; or, in a file that
/// another program has converted, several points have it and it is farther from
/// the other numbers than these are from each other.
/// @param heights  [m], not finite at missing points
/// @param name     of the file, for messages
/// @throws input::InputError  names the number, how many points have it, and
///                            the option --missing-value
void refuse_marks(std::span<const double> heights, const FileNumbers& numbers,
                  const std::string& name) {
  constexpr double least_impossible = 1e20;
  for (const double sign : {-1.0, 1.0}) {
    const RangeEnd end = range_end(heights, sign);
    const double number = sign * end.outer / numbers.unit;
    const bool is_impossible = std::abs(number) >= least_impossible;
    const bool is_known = is_usual_mark(number) && end.is_apart(0.125);
    const bool is_suspect = numbers.is_converted && end.points > 1.0 &&
                            end.is_apart(1.0) && end.range > 0.0;
    if (is_impossible || is_known || is_suspect)
      throw input::InputError(fmt::format(
          "{}: {} point(s) have the number {:.7g}, which {} and probably marks "
          "missing points; {} takes it for that, and another value, such as "
          "1e99, takes all numbers for heights",
          name, end.points, number,
          is_impossible ? "is larger than any height"
                        : "is far from all others",
          input::setting("surface.missing_value",
                         fmt::format("{:.7g}", number))));
  }
}

using mechanics::SurfaceSpec;

/// Mean square slope between neighbours inside the map along x or y, added row
/// by row.
double mean_square_slope(const HeightMap& map, bool is_along_x) {
  const Grid& grid = map.grid;
  const int columns = grid.points_x - (is_along_x ? 1 : 0);
  const int rows = grid.points_y - (is_along_x ? 0 : 1);
  const double spacing = is_along_x ? grid.spacing_x() : grid.spacing_y();
  const std::size_t next = is_along_x ? 1 : grid.index(0, 1);
  double sum = 0.0;
  for (int row = 0; row < rows; ++row) {
    double of_row = 0.0;
    for (int x = 0; x < columns; ++x) {
      const std::size_t at = grid.index(x, row);
      of_row +=
          std::pow((map.heights[at + next] - map.heights[at]) / spacing, 2);
    }
    sum += of_row;
  }
  return sum / (static_cast<double>(columns) * rows);
}

/// Refuses sides and heights outside the limits of lengths.
/// @param height  largest magnitude of the heights [m]
void require_lengths(const SurfaceSpec& surface, const Grid& grid,
                     double height) {
  const auto require = [&](const char* what, double length, double least) {
    if (!(length >= least && length <= mechanics::largest_length))
      throw input::InputError(
          fmt::format("{}: {} of {:.3g} m, but lengths other than 0 must be "
                      "between {} and {} m; check their unit",
                      surface.file, what, length, mechanics::least_length,
                      mechanics::largest_length));
  };
  require("a side", grid.length_x, mechanics::least_length);
  require("a side", grid.length_y, mechanics::least_length);
  require("heights", height, 0.0);
}

/// Refuses a flat map.
/// @param before  largest magnitude of the heights before levelling [m]
/// @param left    the same after it [m]
void require_relief(const SurfaceSpec& surface, double before, double left) {
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  if (left <= rounding * before)
    throw input::InputError(fmt::format(
        "{}: the surface is flat: after levelling, heights of up to {:.3g} m "
        "remain, the roundoff of the original {:.3g} m; there is no roughness",
        surface.file, left, before));
  if (left < mechanics::least_length)
    throw input::InputError(fmt::format(
        "{}: heights of at most {:.3g} m, but lengths other than 0 must be "
        "between {} and {} m; check their unit",
        surface.file, left, mechanics::least_length,
        mechanics::largest_length));
}

void level_form(const SurfaceSpec& surface, HeightMap& map) {
  const double before = largest_magnitude(map.heights);
  require_lengths(surface, map.grid, before);
  try {
    remove_trend(map, surface.level);
  } catch (const std::domain_error& error) {
    throw input::InputError(
        fmt::format("{}: surface.level: {}", surface.file, error.what()));
  }
  require_relief(surface, before, largest_magnitude(map.heights));
}

/// Adds form and spikes of the levelled map to the faults.
void find_faults(const SurfaceSpec& surface, const HeightMap& map,
                 MapFaults& faults) {
  HeightMap left = map;
  remove_trend(left, mechanics::Levelling::plane);
  const double with_form = moments_of(left.heights).rms;
  remove_trend(left, mechanics::Levelling::bow);
  const double roughness = moments_of(left.heights).rms;
  const bool has_form = surface.level == mechanics::Levelling::none ||
                        surface.level == mechanics::Levelling::plane;
  if (has_form && with_form > 0.0)
    faults.form_share = 1.0 - std::pow(roughness / with_form, 2);
  faults.spikes = find_spikes(left, spike_threshold, roughness);
}

/// What a case says about its map file.
ScanRequest request_of_map(const SurfaceSpec& surface) {
  return {surface.format,
          surface.channel,
          {surface.length, surface.height_unit, surface.length_y,
           surface.length_unit},
          surface.missing_value};
}

/// The pixels of the map that a case uses.
/// @param grid  of the whole map
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

/// Refuses a map with too many missing points to be filled.
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

/// Prepares a cropped map.
/// @param numbers  of the file
void prepare(const SurfaceSpec& surface, const FileNumbers& numbers,
             MeasuredMap& measured) {
  HeightMap& map = measured.map;
  const std::size_t size = map.grid.size();
  measured.missing = count_missing(map);
  if (measured.missing == size)
    require_few_missing(surface, size, size);
  if (!surface.missing_value && !numbers.has_own_marks)
    refuse_marks(map.heights, numbers, surface.file);
  if (surface.align_lines == mechanics::LineAlignment::median)
    align_lines(map);
  if (surface.spikes)
    measured.spikes = mark_spikes(map, *surface.spikes);
  require_few_missing(surface, measured.missing + measured.spikes, size);
  measured.faults.points = size;
  measured.faults.missing = measured.missing;
  fill_missing(map);
  level_form(surface, map);
  find_faults(surface, map, measured.faults);
}

/// The wavelength at which a map sinks into its noise floor [m]; 0 if it has
/// none.
double noise_wavelength(const HeightMap& map, bool is_periodic) {
  const ReliableRange range =
      reliable_range(estimate_spectrum(map, is_periodic), {}, {});
  return range.noise ? 2.0 * std::numbers::pi / range.noise->wavevector : 0.0;
}

/// Removes the waves that are shorter than surface.cut_off. Returns the
/// wavelength [m], or 0 if none are removed.
double remove_short_waves(const SurfaceSpec& surface, HeightMap& map) {
  const double longest = std::max(map.grid.length_x, map.grid.length_y);
  if (*surface.cut_off > longest)
    throw input::InputError(
        fmt::format("{}: surface.cut_off = {:.6g} m, but must be at most the "
                    "longer side of the map, {:.6g} m",
                    surface.file, *surface.cut_off, longest));
  const Grid grid = map.grid;
  const bool is_periodic = surface.edges == mechanics::Edges::periodic;
  const double cut_off = *surface.cut_off > 0.0
                             ? *surface.cut_off
                             : noise_wavelength(map, is_periodic);
  if (cut_off == 0.0)
    return cut_off;
  if (!is_periodic)
    map = with_edges(std::move(map), mechanics::Edges::mirror);
  map = low_passed(map, 2.0 * std::numbers::pi / cut_off);
  if (!is_periodic)
    crop(map, {0, 0, grid});
  return cut_off;
}

} // namespace

mechanics::Edges continuation_of(const SurfaceSpec& surface) {
  return surface.has_images ? surface.edges : mechanics::Edges::periodic;
}

std::vector<std::string> warnings_of(const MapFaults& faults) {
  std::vector<std::string> warnings;
  if (faults.spikes.count > 0)
    warnings.push_back(
        fmt::format("{} spike{} of up to {} beside all neighbours; {} removes "
                    "{}",
                    faults.spikes.count, faults.spikes.count == 1 ? "" : "s",
                    quantity_text(faults.spikes.highest, "m", 3),
                    input::setting("surface.remove_spikes",
                                   fmt::format("{:g}", spike_threshold)),
                    faults.spikes.count == 1 ? "it" : "them"));
  if (faults.form_share > largest_form_share)
    warnings.push_back(fmt::format(
        "form: a second-order surface explains {:.3g} % of the variance; {} "
        "removes it",
        100.0 * faults.form_share, input::setting("surface.level", "bow")));
  if (faults.missing > 0)
    warnings.push_back(fmt::format(
        "{} of {} points ({:.2g} %) are missing and interpolated; crop them "
        "by --set surface.crop_x",
        faults.missing, faults.points,
        100.0 * static_cast<double>(faults.missing) /
            static_cast<double>(faults.points)));
  return warnings;
}

Grid measured_grid(const SurfaceSpec& surface) {
  const Grid file = read_scan(surface.file, request_of_map(surface)).map.grid;
  return grid_with_edges(window_of_map(surface, file).grid,
                         continuation_of(surface));
}

MeasuredMap measured_map(const SurfaceSpec& surface) {
  Scan scan = read_scan(surface.file, request_of_map(surface));
  if (surface.crop)
    crop(scan.map, window_of_map(surface, scan.map.grid));
  MeasuredMap measured{std::move(scan.map), scan.channel, scan.reader};
  prepare(surface, scan.numbers, measured);
  if (surface.cut_off)
    measured.cut_off = remove_short_waves(surface, measured.map);
  return measured;
}

MapRoughness roughness_of(const HeightMap& map) {
  return {
      moments_of(map.heights).rms,
      std::sqrt(mean_square_slope(map, true) + mean_square_slope(map, false))};
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
  const HeightMap after = with_edges(before, continuation_of(surface));
  return {roughness_of(before), roughness_of(after)};
}

} // namespace asperity::surfaces
