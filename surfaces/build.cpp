#include "surfaces/build.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/tabulated_spectrum.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/resample.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"
#include "surfaces/realization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

template <class Number>
Number required(const std::optional<Number>& number, const char* key) {
  if (!number)
    throw input::InputError(std::string(key) + " is missing");
  return *number;
}

Grid square_grid(const SurfaceSpec& surface) {
  const int points = required(surface.points, "surface.points");
  const double length = required(surface.length, "surface.length");
  return {points, points, length, length};
}

/// The wavevector, or `lower` if it falls below that by no more than the
/// rounding of a printed number.
double not_below(double wavevector, double lower) {
  const bool is_meant_equal =
      wavevector < lower && wavevector >= lower * (1.0 - printed_rounding);
  return is_meant_equal ? lower : wavevector;
}

IsotropicSpectrum self_affine_spectrum(const SurfaceSpec& surface) {
  const double low = surface.wavevector_low;
  const double roll_off = not_below(surface.wavevector_roll_off, low);
  const SelfAffineShape shape{surface.hurst, low, roll_off,
                              not_below(surface.wavevector_high, roll_off)};
  if (surface.rms_height)
    return SelfAffineSpectrum::with_rms_height(shape, *surface.rms_height)
        .isotropic();
  return SelfAffineSpectrum::with_rms_slope(
             shape, required(surface.rms_slope,
                             "surface.rms_height or surface.rms_slope"))
      .isotropic();
}

/// The tabulated spectrum, with C multiplied by a constant if the case
/// prescribes an rms value.
IsotropicSpectrum table_spectrum(const SurfaceSpec& surface) {
  IsotropicSpectrum spectrum =
      read_tabulated_spectrum(surface.file).isotropic();
  double factor = 1.0;
  if (surface.rms_height)
    factor = std::pow(*surface.rms_height, 2) / spectrum.mean_square_height;
  else if (surface.rms_slope)
    factor = std::pow(*surface.rms_slope, 2) / spectrum.mean_square_slope;
  spectrum.density = [factor, table = std::move(spectrum.density)](double q) {
    return factor * table(q);
  };
  spectrum.mean_square_height *= factor;
  spectrum.mean_square_slope *= factor;
  return spectrum;
}

/// Checks that the grid resolves all modes of the surface.
/// @param points_name  name of the number of points, for the message
/// @param highest      highest wavevector of the modes [rad/m]
/// @param highest_name its name, for the message
void require_points(const SurfaceSpec& surface, const char* points_name,
                    const Grid& grid, const std::string& highest_name,
                    double highest) {
  const int needed = std::max(points_needed(highest, grid.length_x),
                              points_needed(highest, grid.length_y));
  const int points = std::min(grid.points_x, grid.points_y);
  if (points >= needed)
    return;
  throw input::InputError(
      fmt::format("{} = {}, but must be >= {} to resolve {} = {:.6g} 1/m (a "
                  "wavelength of {:.6g} m) over surface.length = {:.6g} m",
                  points_name, points, needed, highest_name, highest,
                  2.0 * std::numbers::pi / highest, *surface.length));
}

std::string band_end_name(const SurfaceSpec& surface) {
  return surface.kind == SurfaceKind::spectrum
             ? fmt::format("the last q of {}", surface.file)
             : std::string("surface.wavevector_high");
}

/// Factor that scales a map to the rms value of the case, which the spectrum
/// already has.
double rescaling(const Statistics& found, const SurfaceSpec& surface,
                 const IsotropicSpectrum& spectrum) {
  const bool is_by_slope = surface.rms_slope && !surface.rms_height;
  return is_by_slope
             ? std::sqrt(spectrum.mean_square_slope) / found.rms_slope
             : std::sqrt(spectrum.mean_square_height) / found.rms_height;
}

void multiply(std::vector<double>& heights, double factor) {
  for (double& height : heights)
    height *= factor;
}

/// The spectrum of a random surface on its own grid.
IsotropicSpectrum own_spectrum(const SurfaceSpec& surface) {
  IsotropicSpectrum spectrum = formula_spectrum(surface);
  require_points(surface, "surface.points", square_grid(surface),
                 band_end_name(surface), spectrum.wavevector_high());
  return spectrum;
}

HeightMap random_surface(const SurfaceSpec& surface, int realization) {
  const IsotropicSpectrum spectrum = own_spectrum(surface);
  HeightMap map = realize(spectrum, square_grid(surface),
                          {surface.seed, realization}, surface.amplitudes);
  if (surface.rescale)
    multiply(map.heights, rescaling(statistics(map), surface, spectrum));
  return map;
}

/// The spectrum up to a wavevector within its band; its moments remain those of
/// the whole spectrum.
IsotropicSpectrum cut(IsotropicSpectrum spectrum, double highest) {
  std::erase_if(spectrum.kinks, [&](double kink) { return kink >= highest; });
  spectrum.kinks.push_back(highest);
  spectrum.density = [highest, whole = std::move(spectrum.density)](double q) {
    return is_in_band(q, 0.0, highest) ? whole(q) : 0.0;
  };
  return spectrum;
}

/// The coarsest grid that resolves a spectrum.
Grid enough_grid(const IsotropicSpectrum& spectrum, const Grid& grid) {
  const int points = points_needed(spectrum.wavevector_high(), grid.length_x);
  return {points, points, grid.length_x, grid.length_y};
}

/// The spectrum of a random surface up to highest, if it is given.
IsotropicSpectrum kept_spectrum(const SurfaceSpec& surface, const Grid& grid,
                                const IsotropicSpectrum& whole,
                                const std::optional<double>& highest) {
  const bool is_cut = highest && *highest < whole.wavevector_high();
  if (is_cut && *highest < whole.wavevector_low())
    refuse_argument(
        "highest_wavevector", *highest,
        fmt::format(">= {} rad/m, the lowest wavevector of the spectrum",
                    number_text(whole.wavevector_low())));
  IsotropicSpectrum kept = is_cut ? cut(whole, *highest) : whole;
  require_points(surface, "points of the grid", grid,
                 is_cut ? "highest_wavevector" : band_end_name(surface),
                 kept.wavevector_high());
  return kept;
}

HeightMap random_surface_on(const SurfaceSpec& surface, int realization,
                            const Grid& grid,
                            const std::optional<double>& highest) {
  const RandomKey key{surface.seed, realization};
  const IsotropicSpectrum whole = formula_spectrum(surface);
  HeightMap map = realize(kept_spectrum(surface, grid, whole, highest), grid,
                          key, surface.amplitudes);
  if (surface.rescale) {
    // The factor depends on the modes only, so any grid that resolves them can
    // be used.
    const HeightMap all =
        realize(whole, enough_grid(whole, grid), key, surface.amplitudes);
    multiply(map.heights, rescaling(statistics(all), surface, whole));
  }
  return map;
}

HeightMap measured_surface(const SurfaceSpec& surface, MeasuredMap* facts) {
  MeasuredMap measured = measured_map(surface);
  HeightMap map{measured.map.grid, std::move(measured.map.heights)};
  if (facts != nullptr)
    *facts = std::move(measured);
  return with_edges(std::move(map), continuation_of(surface));
}

HeightMap measured_surface_on(const SurfaceSpec& surface, const Grid& grid,
                              const std::optional<double>& highest) {
  HeightMap map = measured_surface(surface, nullptr);
  if (highest)
    map = low_passed(map, *highest);
  const double rms_height = statistics(map).rms_height;
  Resampled resampled = resample(map, grid);
  constexpr double rounding = 1e-20; // roundoff of two transforms, squared
  if (resampled.dropped > rounding * rms_height * rms_height)
    throw input::InputError(fmt::format(
        "a grid of {} by {} points is too coarse for the {} by {} of {}: "
        "Fourier modes of rms height {:.6g} m would be lost",
        grid.points_x, grid.points_y, map.grid.points_x, map.grid.points_y,
        surface.file, std::sqrt(resampled.dropped)));
  return std::move(resampled.map);
}

/// Lays a rough surface on its form.
HeightMap on_form(HeightMap map, const SurfaceSpec& surface) {
  if (!surface.form_radius)
    return map;
  const HeightMap form = paraboloid(map.grid, *surface.form_radius);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] += form.heights[i];
  return map;
}

HeightMap shape_of(const SurfaceSpec& surface, const Grid& grid) {
  switch (surface.kind) {
  case SurfaceKind::sphere:
    return paraboloid(grid, surface.radius);
  case SurfaceKind::punch:
    return flat_punch(grid, surface.radius, surface.recess, surface.tilt);
  case SurfaceKind::cone:
    return cone(grid, surface.slope);
  case SurfaceKind::rounded_punch:
    return rounded_punch(grid, surface.radius, surface.edge_radius);
  case SurfaceKind::wave_1d:
    return wave_1d(grid, surface.amplitude, surface.wavelength);
  case SurfaceKind::wave_2d:
    return wave_2d(grid, surface.amplitude, surface.wavelength);
  default:
    throw std::domain_error("unknown surface.kind");
  }
}

void require_length(const SurfaceSpec& surface, const Grid& grid) {
  const double length = required(surface.length, "surface.length");
  for (const double side : {grid.length_x, grid.length_y})
    if (!is_same_length(side, length))
      refuse_argument("length of the grid", side,
                      fmt::format("surface.length = {:.6g} m", length));
}

} // namespace

bool is_random(SurfaceKind kind) {
  return kind == SurfaceKind::self_affine || kind == SurfaceKind::spectrum;
}

IsotropicSpectrum formula_spectrum(const SurfaceSpec& surface) {
  if (surface.kind == SurfaceKind::self_affine)
    return self_affine_spectrum(surface);
  if (surface.kind == SurfaceKind::spectrum)
    return table_spectrum(surface);
  throw std::domain_error("surface.kind must be self-affine or spectrum: no "
                          "other kind defines a power spectrum");
}

HeightMap build_surface(const SurfaceSpec& surface, int realization,
                        MeasuredMap* measured) {
  if (is_random(surface.kind))
    return on_form(random_surface(surface, realization), surface);
  if (surface.kind == SurfaceKind::measured)
    return on_form(measured_surface(surface, measured), surface);
  return shape_of(surface, square_grid(surface));
}

HeightMap build_surface_on(const SurfaceSpec& surface, int realization,
                           const Grid& grid,
                           std::optional<double> highest_wavevector) {
  if (highest_wavevector)
    require_positive("highest_wavevector", *highest_wavevector, "rad/m");
  if (surface.kind == SurfaceKind::measured)
    return on_form(measured_surface_on(surface, grid, highest_wavevector),
                   surface);
  require_length(surface, grid);
  if (is_random(surface.kind))
    return on_form(
        random_surface_on(surface, realization, grid, highest_wavevector),
        surface);
  HeightMap shape = shape_of(surface, grid);
  return highest_wavevector ? low_passed(shape, *highest_wavevector) : shape;
}

void require_resolved(const SurfaceSpec& surface) {
  static_cast<void>(own_spectrum(surface));
}

Grid surface_grid(const SurfaceSpec& surface) {
  return surface.kind == SurfaceKind::measured ? measured_grid(surface)
                                               : square_grid(surface);
}

} // namespace asperity::surfaces
