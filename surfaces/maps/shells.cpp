#include "surfaces/maps/shells.hpp"

#include "base/require.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr double exact_up_to = 8.0; // in units of the smallest |q|
constexpr double resolution = 1e-7; // relative difference of distinct |q|
constexpr std::int64_t first_logarithmic = 1'000'000'000;

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

double smallest_wavevector(const Grid& grid) {
  return wavevector(1, std::max(grid.length_x, grid.length_y));
}

/// What a column of the half spectrum adds to a shell.
struct ColumnShell {
  std::int64_t number = 0;
  Sums sums;
};

/// The shells of a column, ascending.
std::vector<ColumnShell> column_shells(const Grid& grid, int jx,
                                       std::span<const double> power,
                                       double relative_width) {
  const double longest = smallest_wavevector(grid);
  const int height = grid.points_y;
  std::vector<ColumnShell> shells;
  for (int jy = jx == 0 ? 1 : 0; jy <= height / 2; ++jy) {
    const double q = mode_wavevector(grid, jx, jy);
    const std::int64_t number = shell_number(q / longest, relative_width);
    if (shells.empty() || shells.back().number != number)
      shells.push_back({number, {}});
    Sums& sums = shells.back().sums;
    const bool has_opposite = jy > 0 && 2 * jy < height;
    const double both =
        power[static_cast<std::size_t>(jy)] +
        (has_opposite ? power[static_cast<std::size_t>(height - jy)] : 0.0);
    sums.power += both;
    sums.square_slope += q * q * both;
    sums.modes += modes_in_column(grid, jx) * (has_opposite ? 2 : 1);
  }
  return shells;
}

/// The numbers of the shells of a grid, ascending.
std::vector<std::int64_t> shells_of(const Grid& grid, double relative_width) {
  const double longest = smallest_wavevector(grid);
  std::vector<std::int64_t> numbers; // below the logarithmic ones
  std::vector<bool> is_shell;        // from first_logarithmic on
  for (int jx = 0; jx <= grid.points_x / 2; ++jx)
    for (int jy = jx == 0 ? 1 : 0; jy <= grid.points_y / 2; ++jy) {
      const std::int64_t number =
          shell_number(mode_wavevector(grid, jx, jy) / longest, relative_width);
      if (number < first_logarithmic) {
        numbers.push_back(number);
        continue;
      }
      const auto place = static_cast<std::size_t>(number - first_logarithmic);
      if (place >= is_shell.size())
        is_shell.resize(place + place / 2 + 1);
      is_shell[place] = true;
    }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (std::size_t place = 0; place < is_shell.size(); ++place)
    if (is_shell[place])
      numbers.push_back(first_logarithmic + static_cast<std::int64_t>(place));
  return numbers;
}

/// The shells of all columns.
/// @param each  each(take) calls take(jx, power) in the order of the columns
template <class EachColumn>
std::vector<Shell> shells_of_columns(const Grid& grid, double relative_width,
                                     const EachColumn& each) {
  require_between("relative_width", relative_width, 1e-6, 1e3, "1");
  const std::vector<std::int64_t> numbers = shells_of(grid, relative_width);
  std::vector<Sums> sums(numbers.size());
  each([&](int jx, std::span<const double> power) {
    for (const ColumnShell& shell :
         column_shells(grid, jx, power, relative_width)) {
      const auto place = std::ranges::lower_bound(numbers, shell.number);
      Sums& sum = sums[static_cast<std::size_t>(place - numbers.begin())];
      sum.power += shell.sums.power;
      sum.square_slope += shell.sums.square_slope;
      sum.modes += shell.sums.modes;
    }
  });
  double total = 0.0;
  for (const Sums& sum : sums)
    total += sum.power;
  std::vector<Shell> shells;
  for (const Sums& sum : sums)
    if (sum.power > 1e-28 * total)
      shells.push_back(
          {std::sqrt(sum.square_slope / sum.power), sum.power, sum.modes});
  return shells;
}

} // namespace

std::vector<Shell> spectral_shells(const HeightMap& map,
                                   double relative_width) {
  return shells_of_columns(map.grid, relative_width,
                           [&](const auto& take) { each_column(map, take); });
}

std::vector<Shell> spectral_shells(const Grid& grid, const HeightRows& heights,
                                   int threads, double relative_width) {
  return shells_of_columns(grid, relative_width, [&](const auto& take) {
    each_column(grid, heights, threads, take);
  });
}

double shell_density(const Shell& shell, const Grid& grid) {
  const double two_pi = 2.0 * std::numbers::pi;
  return shell.mean_square_height * grid.area() /
         (two_pi * two_pi * shell.modes);
}

namespace {

/// Joins shells whose q differ by at most this factor from 1.
std::vector<Shell> joined_shells(std::span<const Shell> shells,
                                 double relative_width) {
  std::vector<Shell> joined;
  joined.reserve(shells.size());
  double first = 0.0; // q of the first of the shells that are being joined
  for (const Shell& shell : shells) {
    if (shell.wavevector > (1.0 + relative_width) * first) {
      first = shell.wavevector;
      joined.push_back(shell);
      continue;
    }
    Shell& last = joined.back();
    const double power = last.mean_square_height + shell.mean_square_height;
    last.wavevector =
        std::sqrt((last.mean_square_height * std::pow(last.wavevector, 2) +
                   shell.mean_square_height * std::pow(shell.wavevector, 2)) /
                  power);
    last.mean_square_height = power;
    last.modes += shell.modes;
  }
  return joined;
}

} // namespace

IsotropicSpectrum spread_spectrum(std::span<const Shell> shells,
                                  double mode_area) {
  constexpr double least_inner = 0.05;   // of q^2
  constexpr double relative_width = 0.1; // the theory takes time for each kink
  // Changes of C at the squares of the radii of all annuli.
  std::map<double, double> changes;
  IsotropicSpectrum spectrum;
  for (const Shell& shell : joined_shells(shells, relative_width)) {
    const double square = shell.wavevector * shell.wavevector;
    const double half_width =
        std::min(0.5 * shell.modes * mode_area / std::numbers::pi,
                 (1.0 - least_inner) * square);
    const double density =
        shell.mean_square_height / (2.0 * std::numbers::pi * half_width);
    changes[square - half_width] += density;
    changes[square + half_width] -= density;
    spectrum.mean_square_height += shell.mean_square_height;
    spectrum.mean_square_slope += square * shell.mean_square_height;
  }

  std::vector<double> densities;
  densities.reserve(changes.size());
  spectrum.kinks.reserve(changes.size());
  double density = 0.0;
  for (const auto& [square, change] : changes) {
    density += change;
    spectrum.kinks.push_back(std::sqrt(square));
    densities.push_back(std::max(density, 0.0)); // roundoff between annuli
  }
  spectrum.density = [ends = spectrum.kinks,
                      densities = std::move(densities)](double q) {
    if (!is_in_band(q, ends.front(), ends.back()))
      return 0.0;
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, q);
    return densities[static_cast<std::size_t>(after - ends.begin() - 1)];
  };
  return spectrum;
}

} // namespace asperity::surfaces
