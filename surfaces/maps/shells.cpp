#include "surfaces/maps/shells.hpp"

#include "base/require.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>

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

} // namespace

std::vector<Shell> spectral_shells(const HeightMap& map,
                                   double relative_width) {
  require_between("relative_width", relative_width, 1e-6, 1e3, "1");
  const double longest =
      wavevector(1, std::max(map.grid.length_x, map.grid.length_y));
  std::unordered_map<std::int64_t, Sums> sums;
  double total = 0.0;
  // Neighbouring modes are mostly in one shell, which is then not looked up.
  std::int64_t number = -1;
  Sums* shell = nullptr;
  for_each_mode(map, [&](const ModePower& mode) {
    const std::int64_t own =
        shell_number(mode.wavevector / longest, relative_width);
    if (own != number) {
      number = own;
      shell = &sums[own];
    }
    shell->power += mode.power;
    shell->square_slope += mode.wavevector * mode.wavevector * mode.power;
    shell->modes += mode.modes;
    total += mode.power;
  });

  std::vector<Shell> shells;
  const std::map<std::int64_t, Sums> ascending(sums.begin(), sums.end());
  for (const auto& [index, sum] : ascending)
    if (sum.power > 1e-28 * total)
      shells.push_back(
          {std::sqrt(sum.square_slope / sum.power), sum.power, sum.modes});
  return shells;
}

double shell_density(const Shell& shell, const Grid& grid) {
  const double two_pi = 2.0 * std::numbers::pi;
  return shell.mean_square_height * grid.area() /
         (two_pi * two_pi * shell.modes);
}

} // namespace asperity::surfaces
