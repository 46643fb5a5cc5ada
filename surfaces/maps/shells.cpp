#include "surfaces/maps/shells.hpp"

#include "base/require.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity::surfaces {
namespace {

constexpr double exact_up_to = 8.0; // in units of the smallest |q|
constexpr double resolution = 1e-7; // relative difference of distinct |q|
constexpr std::int64_t first_logarithmic = 1'000'000'000;
constexpr std::int64_t none = -1; // below every shell

/// The index of a shell, ascending with |q|.
/// @param reduced_wavevector  |q| in units of the smallest one, >= 1
std::int64_t shell_number(double reduced_wavevector, double relative_width) {
  if (reduced_wavevector < exact_up_to)
    return std::llround(std::log(reduced_wavevector) / resolution);
  const double steps =
      std::log(reduced_wavevector / exact_up_to) / relative_width;
  return first_logarithmic + static_cast<std::int64_t>(steps);
}

struct Sums {
  double power = 0.0;
  double square_slope = 0.0;
  int modes = 0;
};

} // namespace

ModeShells::ModeShells(const Grid& grid, double relative_width) : grid_(grid) {
  require_between("relative_width", relative_width, 1e-6, 1e3, "1");
  const double longest = wavevector(1, std::max(grid.length_x, grid.length_y));
  // Rows jy and points_y - jy have the same wavevectors.
  const int n_columns = grid.points_x / 2 + 1;
  std::vector<std::int64_t> numbers;
  for (int jy = 0; jy <= grid.points_y / 2; ++jy)
    for (int jx = 0; jx < n_columns; ++jx)
      numbers.push_back(
          jx == 0 && jy == 0
              ? none
              : shell_number(mode_wavevector(grid, jx, jy) / longest,
                             relative_width));
  std::vector<std::int64_t> distinct(numbers.begin() + 1, numbers.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  n_shells_ = distinct.size();
  std::vector<std::int32_t> places; // of the modes of these rows
  places.reserve(numbers.size());
  for (const std::int64_t number : numbers)
    places.push_back(static_cast<std::int32_t>(
        std::lower_bound(distinct.begin(), distinct.end(), number) -
        distinct.begin()));
  for (int jy = 0; jy < grid.points_y; ++jy) {
    const auto row =
        places.begin() +
        std::ptrdiff_t{std::min(jy, grid.points_y - jy)} * n_columns;
    shell_.insert(shell_.end(), row + (jy == 0 ? 1 : 0), row + n_columns);
  }
}

std::vector<Shell> ModeShells::of(const HeightMap& map) const {
  assert(map.grid == grid_);
  std::vector<Sums> sums(n_shells_);
  double total = 0.0;
  auto shell = shell_.begin();
  for_each_mode(map, [&](const ModePower& mode) {
    Sums& own = sums[static_cast<std::size_t>(*shell++)];
    own.power += mode.power;
    own.square_slope += mode.wavevector * mode.wavevector * mode.power;
    own.modes += mode.modes;
    total += mode.power;
  });
  std::vector<Shell> shells;
  for (const Sums& sum : sums)
    if (sum.power > 1e-28 * total)
      shells.push_back(
          {std::sqrt(sum.square_slope / sum.power), sum.power, sum.modes});
  return shells;
}

std::vector<Shell> spectral_shells(const HeightMap& map,
                                   double relative_width) {
  return ModeShells(map.grid, relative_width).of(map);
}

double shell_density(const Shell& shell, const Grid& grid) {
  const double two_pi = 2.0 * std::numbers::pi;
  return shell.mean_square_height * grid.area() /
         (two_pi * two_pi * shell.modes);
}

} // namespace asperity::surfaces
