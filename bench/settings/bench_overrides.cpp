#include "bench/settings/bench_plan.hpp"
#include "bench/settings/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::bench {
namespace {

using cases::MethodSpec;

constexpr int least_points = 16;

/// From this number of points on, transforms of multiples of 16 take about half
/// the time per node of those of odd multiples of 2.
constexpr int large_points = 256;

/// True for 2^a 3^b 5^c, for which the FFT is fast.
bool transforms_well(int points) {
  for (const int factor : {2, 3, 5})
    while (points % factor == 0)
      points /= factor;
  return points == 1;
}

} // namespace

int transformable_points(int least) {
  const int step = least > large_points ? 16 : 2;
  int points = std::max(least_points, (least + step - 1) / step * step);
  while (!transforms_well(points))
    points += step;
  return points;
}

int least_carrying_points(const mechanics::SurfaceSpec& surface) {
  if (!surface.length || !(surface.wavevector_high > 0.0))
    return least_points;
  constexpr double rounding = 1e-9;
  const double waves =
      surface.wavevector_high * *surface.length / (2.0 * std::numbers::pi);
  return transformable_points(
      2 * static_cast<int>(std::floor(waves * (1 + rounding))) + 2);
}

std::vector<std::string> common_overrides(const cases::Case& contact_case,
                                          int realizations) {
  std::vector<std::string> overrides;
  if (contact_case.surface.realizations > realizations)
    overrides.push_back(fmt::format("surface.realizations={}", realizations));
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (surface.length && surface.points)
    for (std::string& one :
         CaseValues(contact_case)
             .without_spacings(*surface.length / *surface.points))
      overrides.push_back(std::move(one));
  return overrides;
}

std::vector<std::string> reference_overrides(const cases::Case& contact_case) {
  const CaseValues values(contact_case);
  const bool has_halfspace = std::any_of(
      contact_case.methods.begin(), contact_case.methods.end(),
      [](const MethodSpec& method) { return method.name == "halfspace"; });
  std::vector<std::string> overrides;
  const auto contact = values.value("halfspace", "contact");
  if (!has_halfspace || (contact && contact->text != "hard"))
    overrides.emplace_back("halfspace.contact=hard");
  if (has_halfspace)
    return overrides;
  for (const MethodSpec& method : contact_case.methods)
    if (kind_of_method(method.name) == "fem") {
      overrides.push_back(
          "halfspace.thickness=" +
          scaled_value(*values.value(method.name, "depth"), 1.0));
      overrides.push_back("halfspace.top=" +
                          values.value(method.name, "top")->text);
      break;
    }
  return overrides;
}

} // namespace asperity::bench
