#include "contact/operators/wave_directions.hpp"

#include "base/fourier.hpp"
#include "contact/operators/free_halfspace.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace asperity::contact {
namespace {

using Spectrum = std::vector<std::complex<double>>;

/// Calls of(i, jx, jy, weight) for all modes of a half spectrum, with the
/// number of modes that each stands for.
template <class Of>
void each_mode(const Grid& grid, const Of& of) {
  std::size_t i = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++i)
      of(i, jx, jy, jx == 0 || 2 * jx == grid.points_x ? 1.0 : 2.0);
}

Spectrum spectrum_of(const RealFourier& fourier,
                     std::span<const double> field) {
  Spectrum modes(fourier.grid().half_spectrum_size());
  fourier.forward(field, modes);
  return modes;
}

double share_of_periodic(const Grid& grid, std::span<const double> pressure,
                         int threads) {
  const Spectrum modes = spectrum_of(RealFourier(grid, threads), pressure);
  double along = 0.0, all = 0.0;
  each_mode(grid, [&](std::size_t i, int jx, int jy, double weight) {
    const double x = wavevector(jx, grid.length_x);
    const double y =
        wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y);
    const double square = x * x + y * y;
    if (square == 0.0)
      return;
    const double energy = weight * std::norm(modes[i]) / std::sqrt(square);
    along += energy * x * x / square;
    all += energy;
  });
  return along / all;
}

/// The integral of y^2/r^3 over the cell at a distance (x, y), of which
/// x asinh(y/|x|) is the double integral.
double cell_integral(double x, double y, double side_x, double side_y) {
  const auto corner = [](double a, double b) {
    return a == 0.0 ? 0.0 : a * std::asinh(b / std::abs(a));
  };
  const double east = x + 0.5 * side_x, west = x - 0.5 * side_x;
  const double north = y + 0.5 * side_y, south = y - 0.5 * side_y;
  return corner(east, north) - corner(west, north) - corner(east, south) +
         corner(west, south);
}

/// The transform of the kernel along x, and of that along y, on a padded grid.
Spectrum kernel_of(const RealFourier& fourier, bool is_along_x) {
  const Grid& grid = fourier.grid();
  const double side_x = grid.spacing_x(), side_y = grid.spacing_y();
  std::vector<double> kernel(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double x = signed_wavenumber(ix, grid.points_x) * side_x;
      const double y = signed_wavenumber(iy, grid.points_y) * side_y;
      kernel[grid.index(ix, iy)] = is_along_x
                                       ? cell_integral(x, y, side_x, side_y)
                                       : cell_integral(y, x, side_y, side_x);
    }
  return spectrum_of(fourier, kernel);
}

double share_of_free(const Grid& grid, std::span<const double> pressure,
                     int threads) {
  const RealFourier fourier(padded_grid(grid), threads);
  const Grid& wide = fourier.grid();
  std::vector<double> padded(wide.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      padded[wide.index(ix, iy)] = pressure[grid.index(ix, iy)];
  const Spectrum modes = spectrum_of(fourier, padded);
  std::array<double, 2> energy{};
  for (const bool is_along_x : {true, false}) {
    const Spectrum kernel = kernel_of(fourier, is_along_x);
    each_mode(wide, [&](std::size_t i, int, int, double weight) {
      energy[is_along_x ? 0 : 1] +=
          weight * std::norm(modes[i]) * kernel[i].real();
    });
  }
  return energy[0] / (energy[0] + energy[1]);
}

} // namespace

double energy_along_x(const Grid& grid, std::span<const double> pressure,
                      bool is_periodic, int threads) {
  return is_periodic ? share_of_periodic(grid, pressure, threads)
                     : share_of_free(grid, pressure, threads);
}

} // namespace asperity::contact
