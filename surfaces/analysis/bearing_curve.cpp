#include "surfaces/analysis/bearing_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace asperity::surfaces {
namespace {

constexpr std::size_t ratio_steps = 1000;     // of the material ratio
constexpr std::size_t core_ratio_steps = 400; // 40 %

std::vector<BearingPoint> curve_of(const HeightMap& map) {
  std::vector<double> sorted = map.heights;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const double mean = mean_height(map);
  const auto last = static_cast<double>(sorted.size() - 1);
  std::vector<BearingPoint> points;
  for (std::size_t i = 0; i <= ratio_steps; ++i) {
    const double ratio = static_cast<double>(i) / ratio_steps;
    const double place = ratio * last;
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double share = place - static_cast<double>(below);
    points.push_back(
        {ratio,
         sorted[below] + share * (sorted[above] - sorted[below]) - mean});
  }
  return points;
}

/// First step of the part of 40 % that loses the least height.
std::size_t flattest_part(const std::vector<BearingPoint>& points) {
  std::size_t best = 0;
  double least = points[0].height - points[core_ratio_steps].height;
  for (std::size_t i = 1; i + core_ratio_steps < points.size(); ++i) {
    const double fall = points[i].height - points[i + core_ratio_steps].height;
    if (fall < least) {
      least = fall;
      best = i;
    }
  }
  return best;
}

void add_line(BearingCurve& curve) {
  const std::size_t first = flattest_part(curve.points);
  const double count = core_ratio_steps + 1.0;
  double mean_ratio = 0.0;
  double mean_height = 0.0;
  for (std::size_t i = first; i <= first + core_ratio_steps; ++i) {
    mean_ratio += curve.points[i].material_ratio / count;
    mean_height += curve.points[i].height / count;
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = first; i <= first + core_ratio_steps; ++i) {
    const double offset = curve.points[i].material_ratio - mean_ratio;
    covariance += offset * (curve.points[i].height - mean_height);
    variance += offset * offset;
  }
  const double slope = covariance / variance;
  curve.upper = mean_height - slope * mean_ratio;
  curve.lower = curve.upper + slope;
  curve.core_height = -slope;
}

/// Integral over the material ratio of the positive part of `excess`, which is
/// linear between the points.
double area_of(const std::vector<BearingPoint>& points,
               const std::function<double(const BearingPoint&)>& excess) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double one = excess(points[i]);
    const double other = excess(points[i + 1]);
    const double larger = std::max(one, other);
    const double smaller = std::min(one, other);
    if (larger <= 0.0)
      continue;
    sum += smaller >= 0.0 ? 0.5 * (larger + smaller)
                          : 0.5 * larger * larger / (larger - smaller);
  }
  return sum / ratio_steps;
}

/// Material ratio at which the falling curve meets a height.
double ratio_at(const std::vector<BearingPoint>& points, double height) {
  if (points.front().height <= height)
    return 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (points[i + 1].height <= height) {
      const double fall = points[i].height - points[i + 1].height;
      const double share =
          fall > 0.0 ? (points[i].height - height) / fall : 0.0;
      return points[i].material_ratio + share / ratio_steps;
    }
  return 1.0;
}

} // namespace

double BearingCurve::height_at(double material_ratio) const {
  const double place = std::clamp(material_ratio, 0.0, 1.0) * ratio_steps;
  const std::size_t below =
      std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double share = place - static_cast<double>(below);
  return points[below].height +
         share * (points[below + 1].height - points[below].height);
}

BearingCurve bearing_curve(const HeightMap& map) {
  BearingCurve curve;
  curve.points = curve_of(map);
  add_line(curve);
  curve.peak_ratio = ratio_at(curve.points, curve.upper);
  curve.valley_ratio = ratio_at(curve.points, curve.lower);
  if (curve.peak_ratio > 0.0)
    curve.peak_height =
        2.0 *
        area_of(curve.points,
                [&](const BearingPoint& p) { return p.height - curve.upper; }) /
        curve.peak_ratio;
  if (curve.valley_ratio < 1.0)
    curve.valley_depth =
        2.0 *
        area_of(curve.points,
                [&](const BearingPoint& p) { return curve.lower - p.height; }) /
        (1.0 - curve.valley_ratio);
  return curve;
}

} // namespace asperity::surfaces
