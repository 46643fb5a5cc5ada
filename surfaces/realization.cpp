#include "surfaces/realization.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
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

/// The half spectrum of the surface; all zeros if the band contains no mode.
std::vector<std::complex<double>> draw_modes(const IsotropicSpectrum& spectrum,
                                             const Grid& grid,
                                             const RandomKey& key,
                                             mechanics::Amplitudes amplitudes) {
  const double wavevector_high = spectrum.wavevector_high();
  const int highest_x = highest_wavenumber(wavevector_high, grid.length_x);
  const int highest_y = highest_wavenumber(wavevector_high, grid.length_y);
  const double mode_area = two_pi * two_pi / grid.area();
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  const auto mode_at = [&](int i, int j) -> std::complex<double>& {
    const int row = j >= 0 ? j : j + grid.points_y;
    return modes[static_cast<std::size_t>(row) * grid.half_spectrum_columns() +
                 static_cast<std::size_t>(i)];
  };

  for (int j = -highest_y; j <= highest_y; ++j)
    for (int i = j > 0 ? 0 : 1; i <= highest_x; ++i) {
      const double density = spectrum.density(std::hypot(
          wavevector(i, grid.length_x), wavevector(j, grid.length_y)));
      if (density <= 0.0)
        continue;
      mode_at(i, j) =
          draw_coefficient(density * mode_area, key, i, j, amplitudes);
      if (i == 0) // FFTW stores both modes of a pair in its column 0
        mode_at(0, -j) = std::conj(mode_at(0, j));
    }
  return modes;
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

  std::vector<std::complex<double>> modes =
      draw_modes(spectrum, grid, key, amplitudes);
  const bool is_empty = std::all_of(
      modes.begin(), modes.end(), [](const auto& mode) { return mode == 0.0; });
  if (is_empty)
    throw std::domain_error(fmt::format(
        "the band from {:.6g} to {:.6g} rad/m contains no wavevector that fits "
        "the periodic cell of {:.6g} m by {:.6g} m",
        spectrum.wavevector_low(), wavevector_high, grid.length_x,
        grid.length_y));

  HeightMap map{grid, std::vector<double>(grid.size())};
  RealFourier(grid).backward(modes, map.heights);
  return map;
}

} // namespace asperity::surfaces
