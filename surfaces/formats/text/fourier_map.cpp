#include "surfaces/formats/text/fourier_map.hpp"

#include "base/fourier.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

namespace asperity::surfaces {
namespace {

using Index = std::pair<int, int>; ///< qX, qY

using Coefficients = std::map<Index, std::complex<double>>;

constexpr int most_waves = 1 << 11; ///< along a side; some 0.5 GB of heights
constexpr int largest_index = 1 << 16;
constexpr double printed = 1e-4; ///< difference of equal printed numbers

bool is_index(double number) {
  return number == std::round(number) && std::abs(number) <= largest_index;
}

/// The coefficients of a table; empty if it has none.
Coefficients coefficients_of(const NumberTable& table) {
  Coefficients found;
  if (table.columns != 4)
    return found;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = table.number(row, 0), y = table.number(row, 1);
    const std::complex<double> value(table.number(row, 2),
                                     table.number(row, 3));
    if (!is_index(x) || !is_index(y) || !std::isfinite(std::abs(value)) ||
        !found.insert({{static_cast<int>(x), static_cast<int>(y)}, value})
             .second)
      return {};
  }
  return found;
}

bool are_conjugate(const std::complex<double>& one,
                   const std::complex<double>& other) {
  return std::abs(one - std::conj(other)) <= printed * std::abs(one);
}

/// Number of points N of a transform whose indices are 0 to N - 1: the
/// coefficients on one axis, of which a half spectrum has all, are then pairs
/// k, N - k of conjugates. 0 if they are not.
int points_along(const Coefficients& coefficients, bool is_x) {
  std::map<int, std::complex<double>> on_axis;
  for (const auto& [index, coefficient] : coefficients) {
    if (index.first < 0 || index.second < 0)
      return 0;
    const int place = is_x ? index.first : index.second;
    if (place != 0 && place == index.first + index.second)
      on_axis.insert({place, coefficient});
  }
  if (on_axis.size() < 2)
    return 0;
  const int points = on_axis.begin()->first + on_axis.rbegin()->first;
  for (const auto& [place, coefficient] : on_axis) {
    const auto other = on_axis.find(points - place);
    if (other == on_axis.end() || !are_conjugate(coefficient, other->second))
      return 0;
  }
  return points;
}

/// The coefficients with indices of either sign; empty if they are none.
Coefficients with_signs(const NumberTable& table) {
  const Coefficients stored = coefficients_of(table);
  const int points =
      std::max(points_along(stored, true), points_along(stored, false));
  Coefficients found;
  for (const auto& [index, coefficient] : stored) {
    const auto folded = [&](int one) {
      return points > 0 && 2 * one > points ? one - points : one;
    };
    found.insert({{folded(index.first), folded(index.second)}, coefficient});
  }
  bool has_pair = false;
  for (const auto& [index, coefficient] : found) {
    const Index opposite{-index.first, -index.second};
    const auto other = found.find(opposite);
    if (opposite == index || other == found.end())
      continue;
    if (!are_conjugate(coefficient, other->second))
      return {};
    has_pair = true;
  }
  return has_pair && found.size() == stored.size() ? found : Coefficients();
}

int points_for(const Coefficients& coefficients) {
  int largest = 1, points = 4;
  for (const auto& [index, coefficient] : coefficients)
    largest =
        std::max({largest, std::abs(index.first), std::abs(index.second)});
  while (points < 4 * largest)
    points *= 2;
  return coefficients.empty() ? 0 : points;
}

/// The half spectrum of RealFourier with both q and -q.
std::vector<std::complex<double>> modes_of(const Coefficients& coefficients,
                                           const Grid& grid) {
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  const auto put = [&](const Index& index, const std::complex<double>& value) {
    if (index.first >= 0)
      modes[static_cast<std::size_t>((index.second + grid.points_y) %
                                     grid.points_y) *
                grid.half_spectrum_columns() +
            static_cast<std::size_t>(index.first)] = value;
  };
  for (const auto& [index, coefficient] : coefficients) {
    put(index, coefficient);
    const Index opposite{-index.first, -index.second};
    if (!coefficients.contains(opposite))
      put(opposite, std::conj(coefficient));
  }
  return modes;
}

} // namespace

int fourier_points(const NumberTable& table) {
  return points_for(with_signs(table));
}

std::optional<Scan> fourier_scan(const NumberTable& table,
                                 const MapScale& scale) {
  const Coefficients coefficients = with_signs(table);
  const int points = points_for(coefficients);
  if (points == 0)
    return std::nullopt;
  if (scale.length_y || scale.length_unit)
    throw input::InputError(
        fmt::format("surface.{} must be left out: {} is a list of Fourier "
                    "coefficients of a "
                    "periodic square, whose side is surface.length",
                    scale.length_y ? "length_y" : "length_unit", table.name));
  if (points > 4 * most_waves)
    throw input::InputError(fmt::format(
        "{}: has Fourier coefficients of more than the {} waves along a side "
        "that are read",
        table.name, most_waves));
  const Grid grid = grid_by_scale({points, points, 0.0, 0.0}, table.name,
                                  "a list of Fourier coefficients", scale);
  std::vector<double> heights(grid.size());
  std::vector<std::complex<double>> modes = modes_of(coefficients, grid);
  RealFourier(grid).backward(modes, heights);
  for (double& height : heights)
    height *= *scale.height_unit;
  return scan_of_numbers(grid, std::move(heights),
                         "own reader of Fourier coefficients");
}

} // namespace asperity::surfaces
