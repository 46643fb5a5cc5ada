#include "surfaces/assumptions.hpp"

#include "base/special_numbers.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace asperity::surfaces {
namespace {

/// Relative tolerance for a mode exactly at the limit.
constexpr double nyquist_rounding = 1e-9;

/// s^2 of lines with these mean heights [m^2], see line_offset_ratio.
double mean_square_offset(const std::vector<double>& means, std::size_t step) {
  if (means.size() <= 2 * step)
    return not_a_number;
  double sum = 0.0;
  for (std::size_t i = step; i + step < means.size(); ++i)
    sum += std::pow(means[i] - 0.5 * (means[i - step] + means[i + step]), 2);
  return sum / static_cast<double>(means.size() - 2 * step);
}

/// Half the Nyquist wavevector of the coarser direction.
double resolved_wavevector(const Grid& grid) {
  const double spacing = std::max(grid.spacing_x(), grid.spacing_y());
  return 0.5 * std::numbers::pi / spacing * (1.0 + nyquist_rounding);
}

std::size_t lines_within(double distance, double spacing) {
  return static_cast<std::size_t>(
      std::max(1.0, std::round(distance / spacing)));
}

/// Calls take() with the size of the third differences along x.
template <class Take>
void each_third_difference(const Grid& grid, const HeightRows& heights,
                           const Take& take) {
  const auto width = static_cast<std::size_t>(grid.points_x);
  heights([&](std::span<const double> piece) {
    for (std::size_t first = 0; first < piece.size(); first += width)
      for (std::size_t i = first; i + 3 < first + width; ++i)
        take(std::abs(piece[i + 3] - piece[i] -
                      3.0 * (piece[i + 2] - piece[i + 1])));
  });
}

/// Sums of heights and of their products with the place, in spacings from the
/// middle.
struct PlaneSums {
  double one = 0.0, square = 0.0, along_x = 0.0, along_y = 0.0;
};

/// Mean square of the numbers 0..n-1 about their mean.
double mean_square_place(double n) {
  return (n * n - 1.0) / 12.0;
}

} // namespace

double height_step(const Grid& grid, const HeightRows& heights,
                   double rms_height) {
  constexpr double smallest = 1e-5; // of the rms height; below it is roundoff
  constexpr double most_steps = 100.0, rounding = 0.05, most_others = 1e-3;
  double step = std::numeric_limits<double>::infinity();
  each_third_difference(grid, heights, [&](double difference) {
    if (difference > smallest * rms_height)
      step = std::min(step, difference);
  });
  double few = 0.0, others = 0.0;
  each_third_difference(grid, heights, [&](double difference) {
    const double steps = difference / step;
    if (!(steps < most_steps))
      return;
    few += 1.0;
    others += std::abs(steps - std::round(steps)) > rounding ? 1.0 : 0.0;
  });
  return few > 0.0 && others <= most_others * few ? step : 0.0;
}

double rms_about_plane(const Grid& grid, const HeightRows& heights) {
  const auto columns = static_cast<std::size_t>(grid.points_x);
  const auto rows = static_cast<std::size_t>(grid.points_y);
  std::size_t y = 0;
  PlaneSums sums;
  heights([&](std::span<const double> piece) {
    for (std::size_t first = 0; first < piece.size(); first += columns, ++y)
      for (std::size_t x = 0; x < columns; ++x) {
        const double height = piece[first + x];
        sums.one += height;
        sums.square += height * height;
        sums.along_x +=
            height *
            (static_cast<double>(2 * x + 1) - static_cast<double>(columns)) /
            2.0;
        sums.along_y +=
            height *
            (static_cast<double>(2 * y + 1) - static_cast<double>(rows)) / 2.0;
      }
  });
  const auto nx = static_cast<double>(columns), ny = static_cast<double>(rows);
  const double n = nx * ny;
  const auto explained = [n](double sum, double points) {
    return points > 1.0 ? sum * sum / (n * n * mean_square_place(points)) : 0.0;
  };
  const double rest = sums.square / n - sums.one * sums.one / (n * n) -
                      explained(sums.along_x, nx) - explained(sums.along_y, ny);
  return std::sqrt(std::max(0.0, rest));
}

double unresolved_slope_share(const Grid& grid, const HeightRows& heights,
                              int threads) {
  double whole = 0.0;
  double above = 0.0;
  each_column(grid, heights, threads,
              [&, limit = resolved_wavevector(grid)](
                  int jx, std::span<const double> power) {
                for (std::size_t jy = 0; jy < power.size(); ++jy) {
                  const double q =
                      mode_wavevector(grid, jx, static_cast<int>(jy));
                  whole += q * q * power[jy];
                  if (q > limit)
                    above += q * q * power[jy];
                }
              });
  return whole > 0.0 ? above / whole : not_a_number;
}

double line_offset_ratio(const Grid& grid, const HeightRows& heights) {
  std::vector<double> along_x(static_cast<std::size_t>(grid.points_y), 0.0);
  std::vector<double> along_y(static_cast<std::size_t>(grid.points_x), 0.0);
  std::size_t y = 0;
  heights([&](std::span<const double> piece) {
    for (std::size_t first = 0; first < piece.size();
         first += along_y.size(), ++y)
      for (std::size_t x = 0; x < along_y.size(); ++x) {
        const double height = piece[first + x];
        along_x[y] += height / grid.points_x;
        along_y[x] += height / grid.points_y;
      }
  });
  const double distance = std::max(grid.spacing_x(), grid.spacing_y());
  const double square_x =
      mean_square_offset(along_x, lines_within(distance, grid.spacing_y()));
  const double square_y =
      mean_square_offset(along_y, lines_within(distance, grid.spacing_x()));
  const bool has_both = square_x > 0.0 && square_y > 0.0;
  return has_both
             ? std::sqrt(square_x * grid.length_x / (square_y * grid.length_y))
             : not_a_number;
}

} // namespace asperity::surfaces
