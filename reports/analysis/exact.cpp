#include "reports/analysis/exact.hpp"

#include "base/shown_number.hpp"
#include "reports/analysis/stress_quantities.hpp"
#include "reports/numbers/fits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace asperity::reports {
namespace {

using results::CurvePoint;

// Converts a row of a method into the quantities of the exact solution.
ExactPoint answer_of(const CurvePoint& point,
                     const mechanics::SurfaceSpec& surface,
                     double contact_modulus, double surface_top, bool is_free) {
  ExactPoint answer;
  answer.mean_gap = point.mean_gap;
  answer.area_fraction = point.area_fraction_corrected;
  if (!surface.is_indenter())
    return answer;
  const double side = surface.length.value_or(not_a_number);
  answer.contact_radius =
      side * std::sqrt(answer.area_fraction / std::numbers::pi);
  answer.approach =
      surface_top - point.mean_gap +
      approach_excess(surface, contact_modulus,
                      point.nominal_pressure * side * side, is_free);
  return answer;
}

struct LargestErrors {
  double mean_gap = not_a_number;
  double area_fraction = not_a_number;
  double contact_radius = not_a_number;
  double approach = not_a_number;
};

void widen(double& largest, double error) {
  largest = std::fmax(largest, std::abs(error)); // ignores NaN
}

LargestErrors errors_of(const results::Result& result,
                        const mechanics::SurfaceSpec& surface,
                        const results::MethodRecord& method, bool is_free,
                        bool is_finite) {
  const double modulus = result.contact_modulus;
  const results::SurfaceRecord* map = surface_of(result, method, 0);
  const double top = map == nullptr ? not_a_number : map->highest;
  LargestErrors largest;
  for (const CurvePoint& row :
       loading_rows(method.realizations.front().points)) {
    const ExactPoint exact =
        exact_point(surface, modulus, row.nominal_pressure, top, is_free);
    const ExactPoint answer = answer_of(row, surface, modulus, top, is_free);
    const double height =
        surface.is_indenter() ? exact.approach : surface.amplitude;
    if (is_finite && !surface.is_indenter())
      continue;
    widen(largest.area_fraction, answer.area_fraction - exact.area_fraction);
    widen(largest.contact_radius,
          answer.contact_radius / exact.contact_radius - 1.0);
    if (is_finite)
      continue; // such a block yields otherwise than a half-space
    widen(largest.mean_gap, (answer.mean_gap - exact.mean_gap) / height);
    widen(largest.approach, answer.approach / exact.approach - 1.0);
  }
  return largest;
}

/// Adds to estimates of a punch from which load on it is not compared.
/// @param last  largest nominal pressure of the method [Pa]
void note_recess(double touching, double last,
                 std::initializer_list<Estimate*> estimates) {
  if (last < touching)
    return;
  for (Estimate* const estimate : estimates)
    estimate->remark =
        fmt::format("{}below {}, where the recess of the punch touches",
                    estimate->has_value() ? "largest over the load steps "
                                          : "there is no load step ",
                    quantity_text(touching, "Pa"));
}

double last_load(const results::MethodRecord& method) {
  double last = 0.0;
  for (const CurvePoint& row : loading_rows(method.realizations.front().points))
    last = std::fmax(last, row.nominal_pressure);
  return last;
}

} // namespace

Estimate largest_estimate(double largest, const char* missing) {
  return single_number(largest, "largest over the loads with an exact solution",
                       missing);
}

void add_exact_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          MethodSummary& summary) {
  if (method.kind == "theory" || method.realizations.empty())
    return; // Persson's theory does not apply to a single shape
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const bool is_free = has_free_boundaries(contact_case, method);
  const bool is_finite = has_free_sides(contact_case, method);
  const LargestErrors errors =
      errors_of(result, surface, method, is_free, is_finite);
  const auto missing = [&](const char* otherwise) {
    return is_finite ? not_with_free_sides
           : is_free && !surface.is_indenter()
               ? "there is no exact solution with free boundaries"
               : otherwise;
  };
  auto& quantities = summary.quantities;
  quantities["area_error"] = largest_estimate(
      errors.area_fraction, missing("no load has an exact contact fraction"));
  if (surface.is_indenter()) {
    quantities["contact_radius_error"] = largest_estimate(
        errors.contact_radius, "no load has an exact contact radius");
    quantities["approach_error"] = largest_estimate(
        errors.approach,
        missing(surface.tilt != 0.0
                    ? "of a tilted punch only the moment is known"
                : surface_of(result, method, 0) == nullptr
                    ? "the surface is not in the result"
                    : "no load has an exact approach"));
    note_recess(touching_pressure(surface, result.contact_modulus, is_free),
                last_load(method),
                {&quantities["area_error"], &quantities["contact_radius_error"],
                 &quantities["approach_error"]});
    add_stress_quantities(result, contact_case, method, summary);
    return;
  }
  quantities["mean_gap_error"] = largest_estimate(
      errors.mean_gap, missing("no exact mean gap is known for this shape"));
}

} // namespace asperity::reports
