#include "results/observables/contact_stiffness.hpp"

#include "base/require.hpp"
#include "base/special_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asperity::results {
namespace {

struct Point {
  double u;
  double ln_p;
};

/// Change of ln p below which two steps have one load: their difference is that
/// of the solver's errors.
constexpr double one_load = 1e-6;

/// The slope of the line through two points; NaN if they have one load.
double line_slope(const Point& a, const Point& b) {
  const double change = b.ln_p - a.ln_p;
  return std::abs(change) > one_load ? change / (b.u - a.u) : not_a_number;
}

/// Returns the slope at u of the parabola through three points (Newton's form);
/// NaN if two of them have one load.
double parabola_slope(const std::array<Point, 3>& points, double u) {
  const auto& [a, b, c] = points;
  if (std::isnan(line_slope(a, c)))
    return not_a_number;
  const double slope_ab = line_slope(a, b);
  const double slope_bc = line_slope(b, c);
  const double curvature = (slope_bc - slope_ab) / (c.u - a.u);
  return slope_ab + curvature * ((u - a.u) + (u - b.u));
}

double log_slope(std::span<const double> u, std::span<const double> p,
                 std::size_t i) {
  const auto point = [&](std::size_t j) { return Point{u[j], std::log(p[j])}; };
  if (u.size() == 2)
    return line_slope(point(0), point(1));
  const std::size_t first =
      std::clamp(i, std::size_t{1}, u.size() - 2) - std::size_t{1};
  return parabola_slope({point(first), point(first + 1), point(first + 2)},
                        u[i]);
}

} // namespace

std::vector<double>
contact_stiffness(std::span<const double> mean_gap,
                  std::span<const double> nominal_pressure) {
  if (nominal_pressure.size() != mean_gap.size())
    refuse_argument("nominal_pressure.size()",
                    static_cast<double>(nominal_pressure.size()),
                    "equal to " + std::to_string(mean_gap.size()));
  std::vector<double> stiffness(mean_gap.size(), not_a_number);
  if (mean_gap.size() < 2)
    return stiffness;
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    const double slope = log_slope(mean_gap, nominal_pressure, i);
    if (std::isfinite(slope)) // a logarithm or quotient may not be finite
      stiffness[i] = -nominal_pressure[i] * slope;
  }
  return stiffness;
}

void fill_contact_stiffness(std::vector<CurvePoint>& points) {
  for (const bool is_unloading : {false, true}) {
    std::vector<CurvePoint*> branch;
    std::vector<double> mean_gap;
    std::vector<double> nominal_pressure;
    for (CurvePoint& point : points)
      if (point.is_unloading == is_unloading) {
        branch.push_back(&point);
        mean_gap.push_back(point.mean_gap);
        nominal_pressure.push_back(point.nominal_pressure);
      }
    const std::vector<double> stiffness =
        contact_stiffness(mean_gap, nominal_pressure);
    for (std::size_t i = 0; i < branch.size(); ++i)
      if (std::isnan(branch[i]->contact_stiffness))
        branch[i]->contact_stiffness = stiffness[i];
  }
}

} // namespace asperity::results
