#include "surfaces/realization.hpp"

#include "base/ranks/convolution.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::surfaces {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// The largest integer wavenumber whose wavevector may lie in the band, with
/// the tolerance of is_in_band and a margin for the roundoff of the quotient.
int highest_wavenumber(double wavevector_high, double length) {
  const double wavenumber = wavevector_high * length / two_pi * (1.0 + 2e-9);
  require_between("wavevector_high", wavenumber / length * two_pi, 0.0,
                  two_pi * 1e6 / length, "rad/m");
  return static_cast<int>(std::floor(wavenumber));
}

void require_points(const char* name, int points, double wavevector_high,
                    double length) {
  const int needed = points_needed(wavevector_high, length);
  if (points < needed)
    refuse_argument(name, points,
                    fmt::format(">= {} to resolve the shortest wavelength of "
                                "{:.6g} m over {:.6g} m",
                                needed, two_pi / wavevector_high, length));
}

/// a_q for the mode of the pair (q, -q) that owns the draw.
std::complex<double> draw_coefficient(double mean_square, const RandomKey& key,
                                      int wavenumber_x, int wavenumber_y,
                                      mechanics::Amplitudes amplitudes) {
  const UniformPair draw = draw_mode(key, wavenumber_x, wavenumber_y);
  const double spread = amplitudes == mechanics::Amplitudes::gaussian
                            ? std::sqrt(-std::log(draw.first))
                            : 1.0;
  return std::polar(std::sqrt(mean_square) * spread, two_pi * draw.second);
}

/// Draws the modes of column i >= 0 of the half spectrum.
/// @return  whether the band has a mode there
bool draw_column(const IsotropicSpectrum& spectrum, const Grid& grid,
                 const RandomKey& key, mechanics::Amplitudes amplitudes, int i,
                 std::span<std::complex<double>> column) {
  const double wavevector_high = spectrum.wavevector_high();
  if (i > highest_wavenumber(wavevector_high, grid.length_x))
    return false;
  const int highest = highest_wavenumber(wavevector_high, grid.length_y);
  const double mode_area = two_pi * two_pi / grid.area();
  const auto mode_at = [&](int j) -> std::complex<double>& {
    return column[static_cast<std::size_t>(j >= 0 ? j : j + grid.points_y)];
  };
  bool has_modes = false;
  for (int j = i > 0 ? -highest : 1; j <= highest; ++j) {
    const double density = spectrum.density(
        std::hypot(wavevector(i, grid.length_x), wavevector(j, grid.length_y)));
    if (density <= 0.0)
      continue;
    has_modes = true;
    mode_at(j) = draw_coefficient(density * mode_area, key, i, j, amplitudes);
    if (i == 0) // column 0 has both modes of a pair
      mode_at(-j) = std::conj(mode_at(j));
  }
  return has_modes;
}

} // namespace

int points_needed(double wavevector_high, double length) {
  require_positive("wavevector_high", wavevector_high, "rad/m");
  require_positive("length", length, "m");
  return 2 * highest_wavenumber(wavevector_high, length) + 2;
}

HeightMap realize(const IsotropicSpectrum& spectrum, const Grid& grid,
                  const RandomKey& key, mechanics::Amplitudes amplitudes) {
  const double wavevector_high = spectrum.wavevector_high();
  require_points("points_x", grid.points_x, wavevector_high, grid.length_x);
  require_points("points_y", grid.points_y, wavevector_high, grid.length_y);
  require_not_negative("realization", key.realization, "1");

  HeightMap map{grid, std::vector<double>(grid.size())};
  bool has_modes = false;
  Convolution<double>(grid).synthesise(
      [&](int jx, std::span<std::complex<double>> column) {
        if (draw_column(spectrum, grid, key, amplitudes, jx, column))
          has_modes = true;
      },
      map.heights);
  if (!has_modes)
    throw std::domain_error(fmt::format(
        "the band from {:.6g} to {:.6g} rad/m contains no wavevector that fits "
        "the periodic cell of {:.6g} m by {:.6g} m",
        spectrum.wavevector_low(), wavevector_high, grid.length_x,
        grid.length_y));
  return map;
}

} // namespace asperity::surfaces
