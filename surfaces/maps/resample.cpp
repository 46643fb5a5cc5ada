#include "surfaces/maps/resample.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <vector>

namespace asperity::surfaces {
namespace {

using Complex = std::complex<double>;

/// Fourier coefficients of the interpolation of a map, by signed wavenumbers.
class Modes {
public:
  explicit Modes(const Grid& grid)
      : grid_(grid), half_spectrum_(grid.half_spectrum_size()) {}

  explicit Modes(const HeightMap& map) : Modes(map.grid) {
    RealFourier(grid_).forward(map.heights, half_spectrum_);
    for (Complex& mode : half_spectrum_)
      mode /= static_cast<double>(grid_.size());
  }

  /// Coefficient of the transform, for 0 <= column <= points_x/2 and any row.
  Complex& at(int column, int row) {
    return half_spectrum_[index(column, row)];
  }

  /// Coefficient of the interpolation: 0 beyond the Nyquist row, half on it.
  Complex operator()(int column, int row) const {
    const double share =
        share_of(column, grid_.points_x) * share_of(row, grid_.points_y);
    if (share == 0.0)
      return 0.0;
    return share * (column < 0 ? std::conj(half_spectrum_[index(-column, -row)])
                               : half_spectrum_[index(column, row)]);
  }

  HeightMap heights() && {
    HeightMap map{grid_, std::vector<double>(grid_.size())};
    RealFourier(grid_).backward(half_spectrum_, map.heights);
    return map;
  }

private:
  static double share_of(int wavenumber, int points) {
    const int twice = 2 * std::abs(wavenumber);
    return twice < points ? 1.0 : twice == points ? 0.5 : 0.0;
  }

  std::size_t index(int column, int row) const {
    const int stored = row >= 0 ? row : row + grid_.points_y;
    return static_cast<std::size_t>(stored) * grid_.half_spectrum_columns() +
           static_cast<std::size_t>(column);
  }

  Grid grid_;
  std::vector<Complex> half_spectrum_;
};

/// Calls visit(column, row) for each mode of the half spectrum; row is signed.
template <class Visit>
void for_half_spectrum(const Grid& grid, const Visit& visit) {
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx)
      visit(jx, signed_wavenumber(jy, grid.points_y));
}

/// sum |a_q - b_q|^2 over the modes of `grid` that are not strictly below the
/// Nyquist rows of `target`; the other modes are equal.
double difference_beyond(const Grid& grid, const Grid& target, const Modes& a,
                         const Modes& b) {
  double sum = 0.0;
  for (int row = -(grid.points_y / 2); row <= grid.points_y / 2; ++row)
    for (int column = -(grid.points_x / 2); column <= grid.points_x / 2;
         ++column)
      if (2 * std::abs(column) >= target.points_x ||
          2 * std::abs(row) >= target.points_y)
        sum += std::norm(a(column, row) - b(column, row));
  return sum;
}

void require_target(const Grid& grid, const Grid& target) {
  require_positive("target.points_x", target.points_x, "1");
  require_positive("target.points_y", target.points_y, "1");
  const auto require_length = [](const char* name, double length,
                                 double expected) {
    if (!is_same_length(length, expected))
      refuse_argument(
          name, length,
          fmt::format("{} m, the length of the map", number_text(expected)));
  };
  require_length("target.length_x", target.length_x, grid.length_x);
  require_length("target.length_y", target.length_y, grid.length_y);
}

} // namespace

Resampled resample(const HeightMap& map, const Grid& target) {
  require_target(map.grid, target);
  if (target == map.grid)
    return {map, 0.0};

  const Modes source(map);
  Modes result(target);
  for_half_spectrum(target, [&](int column, int row) {
    const bool is_last_column = 2 * column == target.points_x;
    const bool is_last_row = 2 * row == target.points_y;
    Complex sum = source(column, row);
    if (is_last_column)
      sum += source(-column, row);
    if (is_last_row)
      sum += source(column, -row);
    if (is_last_column && is_last_row)
      sum += source(-column, -row);
    result.at(column, row) = sum;
  });
  const double dropped = difference_beyond(map.grid, target, source, result);
  return {std::move(result).heights(), dropped};
}

HeightMap low_passed(const HeightMap& map, double wavevector) {
  require_not_negative("wavevector", wavevector, "rad/m");
  const Grid& grid = map.grid;
  Modes modes(map);
  for_half_spectrum(grid, [&](int column, int row) {
    const double q = std::hypot(asperity::wavevector(column, grid.length_x),
                                asperity::wavevector(row, grid.length_y));
    if (!is_in_band(q, 0.0, wavevector))
      modes.at(column, row) = 0.0;
  });
  return std::move(modes).heights();
}

} // namespace asperity::surfaces
