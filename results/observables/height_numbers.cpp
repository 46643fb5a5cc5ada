#include "results/observables/height_numbers.hpp"

#include "base/fourier.hpp"
#include "results/observables/map_sums.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace asperity::results {
namespace {

/// Fills what needs no neighbours.
void add_moments(const MapView& heights, HeightNumbers& numbers) {
  const double mean = mean_of(heights);
  double square = 0.0, cube = 0.0, fourth = 0.0;
  double highest = -std::numeric_limits<double>::infinity(), largest = 0.0;
  each_piece(std::array{heights}, [&](std::size_t, const auto& values) {
    for (const double value : values[0]) {
      const double height = value - mean;
      square += height * height;
      cube += height * height * height;
      fourth += height * height * height * height;
      highest = std::max(highest, height);
      largest = std::max(largest, std::abs(height));
    }
  });
  const auto count = static_cast<double>(heights.size());
  square /= count;
  numbers.rms_height = std::sqrt(square);
  numbers.skewness = cube / count / (square * numbers.rms_height);
  numbers.kurtosis = fourth / count / (square * square);
  numbers.highest = highest;
  numbers.largest = largest;
  numbers.roundoff = 1e-12 * (std::abs(mean) + largest);
}

/// Fills slope and curvature by the modes.
void add_slopes(const Grid& grid, std::span<const double> heights,
                HeightNumbers& numbers) {
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  RealFourier(grid).forward(heights, modes);
  double slope = 0.0, laplacian = 0.0;
  std::size_t at = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++at) {
      const bool has_opposite = jx > 0 && 2 * jx != grid.points_x;
      const double square =
          std::pow(wavevector(jx, grid.length_x), 2) +
          std::pow(
              wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y),
              2);
      const double power = (has_opposite ? 2.0 : 1.0) * std::norm(modes[at]);
      slope += square * power;
      laplacian += square * square * power;
    }
  const auto count = static_cast<double>(grid.size());
  const double rms_slope = std::sqrt(slope) / count;
  numbers.rms_slope = {rms_slope, rms_slope};
  numbers.rms_curvature = 0.5 * std::sqrt(laplacian) / count;
}

/// The map with its mirror images to the right, below and beyond both.
SurfaceRecord mirrored(const SurfaceRecord& surface) {
  const Grid& grid = surface.grid;
  SurfaceRecord whole;
  whole.grid = {2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
                2.0 * grid.length_y};
  whole.heights.reserve(whole.grid.size());
  const auto image = [](int i, int points) {
    return i < points ? i : 2 * points - 1 - i;
  };
  for (int y = 0; y < whole.grid.points_y; ++y)
    for (int x = 0; x < whole.grid.points_x; ++x)
      whole.heights.push_back(surface.heights[grid.index(
          image(x, grid.points_x), image(y, grid.points_y))]);
  return whole;
}

/// Fills the bounds of the slope by the differences of neighbours.
void bound_slope(const Grid& grid, const MapView& heights,
                 HeightNumbers& numbers) {
  const auto columns = static_cast<std::size_t>(grid.points_x);
  std::vector<double> first, above;
  double along_x = 0.0, along_y = 0.0;
  const auto add_y = [&](std::span<const double> row) {
    for (std::size_t j = 0; j < columns; ++j)
      along_y += (row[j] - above[j]) * (row[j] - above[j]);
  };
  each_piece(std::array{heights}, [&](std::size_t, const auto& values) {
    for (std::size_t i = 0; i < values[0].size(); i += columns) {
      const std::span<const double> row = values[0].subspan(i, columns);
      for (std::size_t j = 0; j < columns; ++j) {
        const double step = row[(j + 1) % columns] - row[j];
        along_x += step * step;
      }
      if (first.empty())
        first.assign(row.begin(), row.end());
      else
        add_y(row);
      above.assign(row.begin(), row.end());
    }
  });
  add_y(first);
  const double slope =
      std::sqrt((along_x / (grid.spacing_x() * grid.spacing_x()) +
                 along_y / (grid.spacing_y() * grid.spacing_y())) /
                static_cast<double>(grid.size()));
  numbers.rms_slope = {slope, 0.5 * std::numbers::pi * slope};
}

} // namespace

HeightNumbers height_numbers(const SurfaceRecord& surface,
                             Continuation continuation) {
  const MapView heights = surface.height_map();
  HeightNumbers numbers;
  add_moments(heights, numbers);
  if (continuation == Continuation::mirrored) {
    if (heights.is_stored()) {
      numbers.rms_slope = {0.0, std::numeric_limits<double>::infinity()};
    } else {
      const SurfaceRecord whole = mirrored(surface);
      add_slopes(whole.grid, whole.heights, numbers);
    }
  } else if (heights.is_stored()) {
    bound_slope(surface.grid, heights, numbers);
  } else {
    add_slopes(surface.grid, surface.heights, numbers);
  }
  return numbers;
}

} // namespace asperity::results
