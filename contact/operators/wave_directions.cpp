#include "contact/operators/wave_directions.hpp"

#include "base/field_sums.hpp"
#include "base/ranks/convolution.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace asperity::contact {
namespace {

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

/// The kernel of T along x, or of that along y.
EvenSymbol::KernelRow kernel_of(const Grid& grid, bool is_along_x) {
  return [=, dx = grid.spacing_x(),
          dy = grid.spacing_y()](int iy, std::span<double> of_ix) {
    for (std::size_t ix = 0; ix < of_ix.size(); ++ix) {
      const double x = static_cast<double>(ix) * dx, y = iy * dy;
      of_ix[ix] = is_along_x ? cell_integral(x, y, dx, dy)
                             : cell_integral(y, x, dy, dx);
    }
  };
}

/// <p, T p>, up to a factor.
double energy_of(std::span<const double> pressure, const EvenColumn& symbol,
                 Convolution<double> convolution) {
  std::vector<double> displacement(pressure.size());
  convolution.apply(pressure, symbol, displacement);
  return std::inner_product(pressure.begin(), pressure.end(),
                            displacement.begin(), 0.0);
}

} // namespace

double energy_along_x(const Grid& grid, std::span<const double> pressure,
                      bool is_periodic, int threads) {
  const Grid wide = padded_grid(grid);
  const auto energy = [&](bool is_along_x) {
    if (!is_periodic) {
      const EvenSymbol symbol(wide, kernel_of(wide, is_along_x), threads);
      return energy_of(pressure, columns_of(symbol),
                       Convolution<double>(grid, wide, threads));
    }
    const EvenColumn symbol = [&](int jx, std::span<double> of_jy) {
      const double x = wavevector(jx, grid.length_x);
      for (std::size_t jy = 0; jy < of_jy.size(); ++jy) {
        const double y = wavevector(static_cast<int>(jy), grid.length_y);
        const double k = std::hypot(x, y), own = is_along_x ? x : y;
        of_jy[jy] = k > 0.0 ? own * own / (k * k * k) : 0.0;
      }
    };
    return energy_of(pressure, symbol, Convolution<double>(grid, threads));
  };
  const double along = energy(true);
  return along / (along + energy(false));
}

} // namespace asperity::contact
