#pragma once

// The simplest numerical contact solver (Polonsky and Keer's conjugate
// gradients, hard contact, continuum half-space): an independent reference for
// limits.

#include "base/fourier.hpp"
#include "base/grid.hpp"

#include <cmath>
#include <complex>
#include <numeric>
#include <span>
#include <vector>

namespace asperity::theory {

/// The problem of a numerical solution.
struct PlainContact {
  double area_fraction = 0.0;
  double mean_gap = 0.0;
};

/// u = F^-1 [2/(E* q)] F p, without the mean.
inline std::vector<double>
surface_displacement(const RealFourier& fourier,
                     std::span<const double> pressure, double contact_modulus) {
  const Grid& grid = fourier.grid();
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
  fourier.forward(pressure, spectrum);
  const int columns = grid.points_x / 2 + 1;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx < columns; ++jx) {
      const double q = std::hypot(
          wavevector(jx, grid.length_x),
          wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y));
      spectrum[static_cast<std::size_t>(jy * columns + jx)] *=
          q > 0.0
              ? 2.0 / (contact_modulus * q * static_cast<double>(grid.size()))
              : 0.0;
    }
  std::vector<double> displacement(grid.size());
  fourier.backward(spectrum, displacement);
  return displacement;
}

/// Solves for heights of mean 0 until the steps of the pressure are roundoff.
inline PlainContact press(const Grid& grid, std::span<const double> heights,
                          double contact_modulus, double nominal_pressure,
                          int iterations) {
  const RealFourier fourier(grid);
  const std::size_t n = grid.size();
  std::vector<double> pressure(n, nominal_pressure), gap(n), direction(n, 0.0);
  double last_norm = 1.0, keep = 0.0, mean_gap = 0.0;
  const auto mean_in_contact = [&](std::span<const double> field) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      if (pressure[i] > 0.0) {
        sum += field[i];
        count += 1.0;
      }
    return sum / count;
  };
  for (int iteration = 0; iteration < iterations; ++iteration) {
    gap = surface_displacement(fourier, pressure, contact_modulus);
    for (std::size_t i = 0; i < n; ++i)
      gap[i] -= heights[i];
    mean_gap = -mean_in_contact(gap);
    double norm = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      gap[i] += mean_gap;
      norm += pressure[i] > 0.0 ? gap[i] * gap[i] : 0.0;
    }
    for (std::size_t i = 0; i < n; ++i)
      direction[i] = pressure[i] > 0.0
                         ? gap[i] + keep * norm / last_norm * direction[i]
                         : 0.0;
    last_norm = norm;
    std::vector<double> change =
        surface_displacement(fourier, direction, contact_modulus);
    const double mean_change = mean_in_contact(change);
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      above += gap[i] * direction[i];
      below += (change[i] - mean_change) * direction[i];
    }
    if (!(below > 0.0))
      break;
    const double step = above / below;
    keep = 1.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (pressure[i] > 0.0)
        pressure[i] = std::max(0.0, pressure[i] - step * direction[i]);
      if (pressure[i] == 0.0 && gap[i] < 0.0) {
        pressure[i] -= step * gap[i];
        keep = 0.0;
      }
    }
    const double scale = nominal_pressure * static_cast<double>(n) /
                         std::accumulate(pressure.begin(), pressure.end(), 0.0);
    for (double& value : pressure)
      value *= scale;
  }
  double touching = 0.0;
  for (const double value : pressure)
    touching += value > 0.0 ? 1.0 : 0.0;
  return {touching / static_cast<double>(n), mean_gap};
}

} // namespace asperity::theory
