#pragma once

// Maps of self-affine surfaces as an instrument measures them: blurred by a
// Gaussian, with white noise, of a whole periodic cell or of a corner of one.

#include "base/fourier.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/levelling.hpp"

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace asperity::surfaces {

/// A map over 10 um with an rms height of 25 nm before blur and noise.
struct InstrumentMap {
  int points = 128;         ///< per side
  double hurst = 0.8;       ///< H [1]
  double roll_off = 5.0;    ///< q_0 in units of 2 pi over the side; below 1 it
                            ///< is not in the map
  double blur = 0.0;        ///< standard deviation in pixels
  double noise = 0.0;       ///< rms [m]
  bool is_periodic = false; ///< else a corner of a cell of twice the side,
                            ///< levelled by a plane
  std::uint64_t seed = 0;
};

inline HeightMap measured(const InstrumentMap& of) {
  constexpr double side = 10e-6;
  constexpr double rms_height = 25e-9;
  const int cells = of.is_periodic ? 1 : 2;
  const int points = cells * of.points;
  const Grid grid{points, points, cells * side, cells * side};
  std::mt19937_64 generator(of.seed);
  std::normal_distribution<double> normal;
  std::vector<double> white(grid.size());
  for (double& value : white)
    value = normal(generator);
  std::vector<std::complex<double>> sharp(grid.half_spectrum_size());
  const RealFourier fourier(grid);
  fourier.forward(white, sharp);
  std::vector<std::complex<double>> blurred = sharp;
  const double pixel = side / of.points;
  const double unit = 2.0 * std::numbers::pi / side;
  for (int jy = 0; jy < points; ++jy)
    for (int jx = 0; jx <= points / 2; ++jx) {
      const std::size_t mode = static_cast<std::size_t>(jy) *
                                   static_cast<std::size_t>(points / 2 + 1) +
                               static_cast<std::size_t>(jx);
      const double q =
          unit / cells * std::hypot(jx, signed_wavenumber(jy, points));
      const double amplitude =
          mode == 0
              ? 0.0
              : std::pow(std::max(q / unit, of.roll_off), -1.0 - of.hurst);
      sharp[mode] *= amplitude;
      blurred[mode] =
          sharp[mode] * std::exp(-0.5 * std::pow(q * of.blur * pixel, 2));
    }
  std::vector<double> heights(grid.size());
  fourier.backward(sharp, heights);
  double square = 0.0;
  for (const double height : heights)
    square += height * height / static_cast<double>(grid.size());
  fourier.backward(blurred, heights);
  HeightMap map{{of.points, of.points, side, side}, {}};
  for (int iy = 0; iy < of.points; ++iy)
    for (int ix = 0; ix < of.points; ++ix)
      map.heights.push_back(rms_height / std::sqrt(square) *
                                heights[grid.index(ix, iy)] +
                            of.noise * normal(generator));
  if (!of.is_periodic)
    remove_trend(map, mechanics::Levelling::plane);
  return map;
}

/// The map of a number: blur from 0 to 1 pixel, noise from 0 to 1 nm, H from
/// 0.3 to 1, roll-off in and out of the map, periodic and not, in turn.
inline InstrumentMap instrument_map(int number, int points) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(7919 + number));
  std::uniform_real_distribution<double> share;
  InstrumentMap map;
  map.points = points;
  map.hurst = 0.3 + 0.7 * share(generator);
  map.blur = share(generator);
  map.noise = 1e-9 * share(generator);
  map.roll_off = number % 2 == 0 ? 3.0 + 7.0 * share(generator) : 0.3;
  map.is_periodic = number / 2 % 2 == 1;
  map.seed = static_cast<std::uint64_t>(number);
  return map;
}

} // namespace asperity::surfaces
