#include "surfaces/build.hpp"

#include "cases/case_error.hpp"
#include "surfaces/edges.hpp"
#include "surfaces/exact_shapes.hpp"
#include "surfaces/levelling.hpp"
#include "surfaces/map_file.hpp"
#include "surfaces/realization.hpp"
#include "surfaces/self_affine.hpp"
#include "surfaces/statistics.hpp"
#include "surfaces/tabulated_spectrum.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace asperity::surfaces {
namespace {

using cases::SurfaceKind;
using cases::SurfaceSpec;

template <class Number>
Number required(const std::optional<Number>& number, const char* key) {
  if (!number)
    throw cases::CaseError(std::string(key) + " is missing");
  return *number;
}

Grid square_grid(const SurfaceSpec& surface) {
  const int points = required(surface.points, "surface.points");
  const double length = required(surface.length, "surface.length");
  return {points, points, length, length};
}

/// The wavevector, or the lower one that it undercuts by a rounding in print.
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

/// The table, C multiplied by a constant where an rms is asked for.
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

void require_points(const SurfaceSpec& surface, double wavevector_high,
                    const Grid& grid) {
  const int needed = points_needed(wavevector_high, grid.length_x);
  if (grid.points_x >= needed)
    return;
  const std::string band = surface.kind == SurfaceKind::spectrum
                               ? fmt::format("the last q of {}", surface.file)
                               : std::string("surface.wavevector_high");
  throw cases::CaseError(fmt::format(
      "surface.points = {}, but must be >= {} to carry {} = {:.6g} 1/m (a wave "
      "of {:.6g} m) over surface.length = {:.6g} m",
      grid.points_x, needed, band, wavevector_high,
      2.0 * std::numbers::pi / wavevector_high, grid.length_x));
}

/// Scales to the rms the case asks for; the spectrum has it already.
void rescale(HeightMap& map, const SurfaceSpec& surface,
             const IsotropicSpectrum& spectrum) {
  const Statistics found = statistics(map);
  const bool is_by_slope = surface.rms_slope && !surface.rms_height;
  const double factor =
      is_by_slope ? std::sqrt(spectrum.mean_square_slope) / found.rms_slope
                  : std::sqrt(spectrum.mean_square_height) / found.rms_height;
  for (double& height : map.heights)
    height *= factor;
}

HeightMap random_surface(const SurfaceSpec& surface, int realization) {
  const Grid grid = square_grid(surface);
  const IsotropicSpectrum spectrum = formula_spectrum(surface);
  require_points(surface, spectrum.wavevector_high(), grid);
  HeightMap map =
      realize(spectrum, grid, {surface.seed, realization}, surface.amplitudes);
  if (surface.rescale)
    rescale(map, surface, spectrum);
  return map;
}

HeightMap measured_surface(const SurfaceSpec& surface) {
  HeightMap map = read_height_map(surface.file, surface.format,
                                  {surface.length, surface.height_unit});
  remove_trend(map, surface.level);
  return with_edges(std::move(map), surface.edges);
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
                          "other kind has a formula for its spectrum");
}

HeightMap build_surface(const SurfaceSpec& surface, int realization) {
  switch (surface.kind) {
  case SurfaceKind::self_affine:
  case SurfaceKind::spectrum:
    return random_surface(surface, realization);
  case SurfaceKind::measured:
    return measured_surface(surface);
  case SurfaceKind::sphere:
    return paraboloid(square_grid(surface), surface.radius);
  case SurfaceKind::wave_1d:
    return wave_1d(square_grid(surface), surface.amplitude, surface.wavelength);
  case SurfaceKind::wave_2d:
    return wave_2d(square_grid(surface), surface.amplitude, surface.wavelength);
  }
  throw std::domain_error("surface.kind is none of SurfaceKind");
}

} // namespace asperity::surfaces
