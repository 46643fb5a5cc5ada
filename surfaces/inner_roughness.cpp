#include "surfaces/inner_roughness.hpp"

#include "base/special_numbers.hpp"
#include "surfaces/analysis/local_differences.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::surfaces {
namespace {

/// The mean over a rectangle about the centre of a function f(r), which is 0
/// below `from`. The part of the circle of radius r that is inside is found
/// from both half sides.
template <class Function>
double mean_beyond(double from, double half_x, double half_y,
                   const Function& f) {
  constexpr int intervals = 20000;
  const double corner = std::hypot(half_x, half_y);
  const double step = (corner - from) / intervals;
  const auto outside = [](double half, double r) {
    return r > half ? 4.0 * std::acos(half / r) : 0.0; // angle [rad]
  };
  double sum = 0.0;
  for (int i = 0; i < intervals; ++i) {
    const double r = from + (i + 0.5) * step;
    const double angle =
        2.0 * std::numbers::pi - outside(half_x, r) - outside(half_y, r);
    sum += f(r) * r * std::max(angle, 0.0) * step;
  }
  return sum / (4.0 * half_x * half_y);
}

} // namespace

std::optional<mechanics::Roughness>
exact_roughness(const mechanics::SurfaceSpec& surface, double length_x,
                double length_y) {
  using enum mechanics::SurfaceKind;
  const double flat = surface.radius, edge = surface.edge_radius;
  switch (surface.kind) {
  case sphere:
    return mechanics::Roughness{std::hypot(length_x, length_y) /
                                    (std::sqrt(12.0) * surface.radius),
                                1.0 / surface.radius};
  case cone:
    return mechanics::Roughness{surface.slope, not_a_number};
  case punch:
    return mechanics::Roughness{not_a_number, not_a_number};
  case rounded_punch: {
    const auto mean = [&](const auto& f) {
      return mean_beyond(flat, 0.5 * length_x, 0.5 * length_y, f);
    };
    return mechanics::Roughness{
        std::sqrt(
            mean([&](double r) { return std::pow((r - flat) / edge, 2); })),
        std::sqrt(mean([&](double r) {
          return std::pow((1.0 + (r - flat) / r) / (2.0 * edge), 2);
        }))};
  }
  default:
    return std::nullopt;
  }
}

bool is_judged_inside(const mechanics::SurfaceSpec& surface, bool is_free) {
  return surface.form_radius.has_value() ||
         (is_free && surface.kind == mechanics::SurfaceKind::measured);
}

double inner_curvature(const HeightMap& map) {
  if (std::min(map.grid.points_x, map.grid.points_y) < 3)
    return not_a_number;
  return local_differences(map, 1, 1, false).rms_curvature();
}

} // namespace asperity::surfaces
