#include "suite/robustness/shapes.hpp"

#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// A few waves in random directions.
double roughness(const Draft& draft, double x, double y) {
  double height = 0.0;
  for (int i = 0; i < 4; ++i) {
    const auto waves = [&](const char* axis) {
      return std::floor(
          draft.uniform(fmt::format("terraces {} {}", axis, i), -2.0, 3.0));
    };
    height +=
        std::cos(2.0 * std::numbers::pi *
                 ((i + 1) * (waves("x") * x + waves("y") * y) +
                  draft.uniform(fmt::format("terraces {}", i), 0.0, 1.0)));
  }
  return height;
}

/// Rounds every height to one of a few equidistant levels between the lowest
/// and the highest.
void cut_terraces(std::vector<double>& heights) {
  constexpr int terrace_heights = 4;
  const auto [lowest, highest] = std::ranges::minmax(heights);
  if (highest == lowest) // of waves that are all constant
    heights.front() += 1.0;
  const double step = std::max(highest - lowest, 1.0) / (terrace_heights - 1);
  for (double& height : heights)
    height = std::round((height - lowest) / step) * step;
}

} // namespace

surfaces::HeightMap map_of_shape(const std::string& shape, int points,
                                 double length, double rms_slope,
                                 const Draft& draft) {
  surfaces::HeightMap map{{points, points, length, length}, {}};
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      map.heights.push_back(
          shape == "spike"      ? (ix == 0 && iy == 0 ? 1.0 : 0.0)
          : shape == "step"     ? (2 * ix < points ? 1.0 : 0.0)
          : shape == "sawtooth" ? ix % std::max(2, points / 4)
          : shape == "checkerboard"
              ? ((ix + iy) % 2 == 0 ? 1.0 : -1.0)
              : roughness(draft, 1.0 * ix / points, 1.0 * iy / points));
  if (shape == "terraces")
    cut_terraces(map.heights);
  surfaces::remove_mean(map);
  const double slope = surfaces::statistics(map).rms_slope;
  for (double& height : map.heights)
    height *= rms_slope / slope;
  return map;
}

} // namespace asperity::robustness
