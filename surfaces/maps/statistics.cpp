#include "surfaces/maps/statistics.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"
#include "surfaces/maps/mode_power.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::surfaces {
namespace {

/// Adds moments and extreme values, which need no transform.
void add_heights(const HeightMap& map, Statistics& result) {
  const double mean = mean_height(map);
  double square = 0.0;
  double cube = 0.0;
  double fourth = 0.0;
  for (const double node : map.heights) {
    const double height = node - mean;
    square += height * height;
    cube += height * height * height;
    fourth += height * height * height * height;
  }
  const auto count = static_cast<double>(map.heights.size());
  square /= count;
  result.rms_height = rms_height(map.heights);
  result.skewness = cube / count / (square * result.rms_height);
  result.kurtosis = fourth / count / (square * square);
  const auto [lowest, highest] =
      std::minmax_element(map.heights.begin(), map.heights.end());
  result.lowest = *lowest - mean;
  result.highest = *highest - mean;
}

} // namespace

Statistics statistics(const HeightMap& map) {
  Statistics result;
  add_heights(map, result);
  double square_slope = 0.0;
  double square_laplacian = 0.0;
  for_each_mode(map, [&](const ModePower& mode) {
    const double square = mode.wavevector * mode.wavevector;
    square_slope += square * mode.power;
    square_laplacian += square * square * mode.power;
  });
  result.rms_slope = std::sqrt(square_slope);
  result.rms_curvature = 0.5 * std::sqrt(square_laplacian);
  return result;
}

std::vector<HeightBin> height_distribution(const HeightMap& map, int bins) {
  if (bins < 1)
    refuse_argument("bins", bins, ">= 1");
  const auto [lowest, highest] =
      std::minmax_element(map.heights.begin(), map.heights.end());
  const double width = (*highest - *lowest) / bins;
  if (!(width > 0.0))
    return {};

  const double mean = mean_height(map);
  std::vector<HeightBin> distribution(static_cast<std::size_t>(bins));
  for (std::size_t i = 0; i < distribution.size(); ++i)
    distribution[i].height =
        *lowest - mean + (static_cast<double>(i) + 0.5) * width;
  const double share = 1.0 / (static_cast<double>(map.heights.size()) * width);
  for (const double height : map.heights) {
    const int bin = static_cast<int>((height - *lowest) / width);
    // The highest node belongs to the last bin.
    distribution[static_cast<std::size_t>(std::min(bin, bins - 1))].density +=
        share;
  }
  return distribution;
}

} // namespace asperity::surfaces
