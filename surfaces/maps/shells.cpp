#include "surfaces/maps/shells.hpp"

#include "base/require.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

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
  std::map<std::int64_t, Sums> sums;
  double total = 0.0;
  for_each_mode(map, [&](const ModePower& mode) {
    Sums& shell = sums[shell_number(mode.wavevector / longest, relative_width)];
    shell.power += mode.power;
    shell.square_slope += mode.wavevector * mode.wavevector * mode.power;
    shell.modes += mode.modes;
    total += mode.power;
  });

  std::vector<Shell> shells;
  for (const auto& [number, shell] : sums)
    if (shell.power > 1e-28 * total)
      shells.push_back({std::sqrt(shell.square_slope / shell.power),
                        shell.power, shell.modes});
  return shells;
}

double shell_density(const Shell& shell, const Grid& grid) {
  const double two_pi = 2.0 * std::numbers::pi;
  return shell.mean_square_height * grid.area() /
         (two_pi * two_pi * shell.modes);
}

} // namespace asperity::surfaces
