#include "reports/analysis/exact.hpp"
#include "results/types/method_columns.hpp"
#include "theory/exact/contact_stiffness.hpp"
#include "theory/exact/punches.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;

struct StiffnessErrors {
  double normal = not_a_number;
  double tangential = not_a_number;
};

StiffnessErrors stiffness_errors(std::span<const CurvePoint> rows,
                                 const mechanics::SurfaceSpec& surface,
                                 const theory::ContactArray& array) {
  StiffnessErrors largest;
  for (const CurvePoint& row : rows) {
    const double radius = exact_point(surface, array.contact_modulus,
                                      row.nominal_pressure, 0.0, false)
                              .contact_radius;
    if (!(row[columns::normal_stiffness] > 0.0 &&
          row[columns::tangential_stiffness] > 0.0 && radius > 0.0))
      continue;
    const theory::StiffnessPair found = theory::stiffness_alone(
        {row[columns::normal_stiffness], row[columns::tangential_stiffness]},
        array);
    const theory::StiffnessPair exact = theory::halfspace_stiffness(
        radius, array.contact_modulus, array.poisson);
    largest.normal =
        std::fmax(largest.normal, std::abs(found.normal / exact.normal - 1.0));
    largest.tangential =
        std::fmax(largest.tangential,
                  std::abs(found.tangential / exact.tangential - 1.0));
  }
  return largest;
}

bool has_stiffness(const CurvePoint& row) {
  return std::isfinite(row[columns::normal_stiffness]);
}

void add_stiffness_errors(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          const mechanics::FemSettings& block,
                          MethodSummary& summary) {
  const std::vector<CurvePoint> rows =
      loading_rows(method.realizations.front().points);
  if (std::ranges::none_of(rows, has_stiffness))
    return;
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const double side = surface.length.value_or(not_a_number);
  const mechanics::Scales scales{result.contact_modulus, side,
                                 side / surface.points.value_or(1), 0.0, 0.0};
  StiffnessErrors errors;
  if (!has_free_sides(contact_case, method) &&
      contact_case.material.poisson_ratio)
    errors = stiffness_errors(rows, surface,
                              {side, block.block.depth.in_si(scales),
                               result.contact_modulus,
                               *contact_case.material.poisson_ratio});
  summary.quantities["normal_stiffness_error"] =
      largest_estimate(errors.normal, not_with_free_sides);
  summary.quantities["tangential_stiffness_error"] =
      largest_estimate(errors.tangential, not_with_free_sides);
}

/// Adds the largest relative error of the moment over the rows in which the
/// whole end is in contact: its edge lifts if the approach is less than 2 a
/// tilt.
void add_moment_error(const results::Result& result,
                      const cases::Case& contact_case,
                      const results::MethodRecord& method,
                      MethodSummary& summary) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  Estimate& error = summary.quantities["moment_error"];
  error.remark = not_with_free_sides;
  if (has_free_sides(contact_case, method))
    return;
  const double side = surface.length.value_or(not_a_number);
  const theory::FlatPunch punch(surface.radius, result.contact_modulus);
  const double exact = punch.moment(surface.tilt);
  double largest = not_a_number;
  for (const CurvePoint& row :
       loading_rows(method.realizations.front().points)) {
    const double load = row.nominal_pressure * side * side;
    if (exact_point(surface, result.contact_modulus, row.nominal_pressure, 0.0,
                    has_free_boundaries(contact_case, method))
            .contact_radius > 0.0)
      largest = std::fmax(
          largest,
          std::abs(load * row[columns::pressure_centre.x] / exact - 1.0));
  }
  error =
      largest_estimate(largest, "no load presses the whole end into contact");
}

} // namespace

void add_stiffness_quantities(const results::Result& result,
                              const cases::Case& contact_case,
                              const results::MethodRecord& method,
                              MethodSummary& summary) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (method.realizations.empty())
    return;
  const auto* const block =
      settings_of<mechanics::FemSettings>(contact_case, method);
  if (surface.tilt != 0.0) {
    add_moment_error(result, contact_case, method, summary);
    return;
  }
  if (block != nullptr)
    add_stiffness_errors(result, contact_case, method, *block, summary);
}

} // namespace asperity::reports
