#include "suite/robustness/shapes.hpp"

#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// A wave of unit amplitude in a random direction.
struct Wave {
  double along_x = 0.0; ///< waves per side
  double along_y = 0.0;
  double phase = 0.0; ///< [2 pi]
};

std::array<Wave, 4> draw_waves(const Draft& draft) {
  std::array<Wave, 4> waves;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const auto count = [&](const char* axis) {
      return std::floor(
          draft.uniform(fmt::format("terraces {} {}", axis, i), -2.0, 3.0));
    };
    waves[i] = {count("x"), count("y"),
                draft.uniform(fmt::format("terraces {}", i), 0.0, 1.0)};
  }
  return waves;
}

double roughness(const std::array<Wave, 4>& waves, double x, double y) {
  double height = 0.0;
  int harmonic = 0;
  for (const Wave& wave : waves)
    height += std::cos(
        2.0 * std::numbers::pi *
        (++harmonic * (wave.along_x * x + wave.along_y * y) + wave.phase));
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
  const std::array<Wave, 4> waves = draw_waves(draft);
  surfaces::HeightMap map{{points, points, length, length}, {}};
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      map.heights.push_back(
          shape == "spike"      ? (ix == 0 && iy == 0 ? 1.0 : 0.0)
          : shape == "step"     ? (2 * ix < points ? 1.0 : 0.0)
          : shape == "sawtooth" ? ix % std::max(2, points / 4)
          : shape == "checkerboard"
              ? ((ix + iy) % 2 == 0 ? 1.0 : -1.0)
              : roughness(waves, 1.0 * ix / points, 1.0 * iy / points));
  if (shape == "terraces")
    cut_terraces(map.heights);
  surfaces::remove_mean(map);
  const double slope = surfaces::statistics(map).rms_slope;
  for (double& height : map.heights)
    height *= rms_slope / slope;
  return map;
}

} // namespace asperity::robustness
