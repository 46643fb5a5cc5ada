#include "reports/analysis/stress_quantities.hpp"

#include "reports/analysis/exact.hpp"
#include "theory/exact/hertz.hpp"

#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <limits>

namespace asperity::reports {

std::string stress_table_name(const std::string& method) {
  return "stress-inside-" + method;
}

std::string stress_sections_name(const std::string& method) {
  return "stress-sections-" + method;
}

std::string stress_section_name(const std::string& method) {
  return "stress-section-" + method;
}

HertzStrength hertz_strength(double poisson_ratio) {
  // With E* = 3/4 and F = R = 1, a = 1 and p_0 = 3/(2 pi).
  const theory::HertzContact contact = theory::hertz_contact(1.0, 1.0, 0.75);
  const auto [depth, lowest] = boost::math::tools::brent_find_minima(
      [&](double z) {
        const theory::AxisStress stress =
            theory::hertz_axis_stress(contact, z, poisson_ratio);
        return -std::abs(stress.radial - stress.axial);
      },
      0.0, 2.0, std::numeric_limits<double>::digits / 2);
  return {-lowest / contact.peak_pressure, depth};
}

void add_stress_quantities(const results::Result& result,
                           const cases::Case& contact_case,
                           const results::MethodRecord& method,
                           MethodSummary& summary) {
  const results::Table* table = result.table(stress_table_name(method.name));
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (table == nullptr || surface.kind != mechanics::SurfaceKind::sphere ||
      !contact_case.material.poisson_ratio)
    return;
  const double side = surface.length.value_or(not_a_number);
  const HertzStrength exact =
      hertz_strength(*contact_case.material.poisson_ratio);
  const std::vector<double> pressures = table->values("nominal_pressure");
  const std::vector<double> strengths = table->values("von_mises");
  const std::vector<double> depths = table->values("depth");
  if (strengths.size() != pressures.size() || depths.size() != pressures.size())
    return; // not a table in the expected format
  double strength_error = not_a_number;
  double depth_error = not_a_number;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const bool is_free = has_free_boundaries(contact_case, method);
    if (!(exact_point(surface, result.contact_modulus, pressures[i], 0.0,
                      is_free)
              .contact_radius > 0.0))
      continue;
    const theory::HertzContact contact = sphere_contact(
        surface, result.contact_modulus, pressures[i] * side * side, is_free);
    const double strength = exact.von_mises * contact.peak_pressure;
    const double depth = exact.depth * contact.contact_radius;
    strength_error =
        std::fmax(strength_error, std::abs(strengths[i] / strength - 1.0));
    depth_error = std::fmax(depth_error, std::abs(depths[i] / depth - 1.0));
  }
  const char* const missing = "no saved map has an exact stress";
  summary.quantities["von_mises_error"] =
      largest_estimate(strength_error, missing);
  summary.quantities["von_mises_depth_error"] =
      largest_estimate(depth_error, missing);
}

} // namespace asperity::reports
