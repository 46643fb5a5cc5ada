#include "reports/analysis/exact.hpp"
#include "theory/exact/adhesive_sphere.hpp"
#include "theory/exact/westergaard.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::reports {
namespace {

using results::CurvePoint;

std::vector<CurvePoint> converged_rows(const results::Curve& curve) {
  std::vector<CurvePoint> rows;
  for (const CurvePoint& row : curve.points)
    if (row.status == results::StepStatus::converged)
      rows.push_back(row);
  return rows;
}

double largest_tension(const std::vector<CurvePoint>& rows) {
  double largest = 0.0;
  for (const CurvePoint& row : rows)
    largest = std::max(
        {largest, -row.nominal_pressure, std::fmax(0.0, -row.jump_pressure)});
  return largest;
}

/// -sum p du by the trapezoidal rule [J/m^2]; NaN for a path that does not
/// return.
double dissipated_energy(const std::vector<CurvePoint>& rows) {
  if (rows.size() < 3 || !rows.back().is_unloading ||
      std::abs(rows.back().mean_gap - rows.front().mean_gap) >
          1e-3 * std::abs(rows.front().mean_gap))
    return not_a_number;
  double work = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    work -= 0.5 * (rows[i].nominal_pressure + rows[i - 1].nominal_pressure) *
            (rows[i].mean_gap - rows[i - 1].mean_gap);
  return work;
}

double wave_error(const std::vector<CurvePoint>& rows,
                  const theory::WestergaardContact& wave,
                  double work_of_adhesion) {
  double largest = not_a_number;
  for (const CurvePoint& row : rows)
    if (row.area_fraction > 0.0 && row.area_fraction < 1.0)
      largest = std::fmax(largest,
                          std::abs(row.nominal_pressure -
                                   wave.adhesive_pressure(row.area_fraction,
                                                          work_of_adhesion)) /
                              wave.full_contact_pressure());
  return largest;
}

double sphere_error(const std::vector<CurvePoint>& rows,
                    const theory::MaugisSphere& sphere, double nominal_area) {
  double largest = not_a_number;
  for (const CurvePoint& row : rows)
    if (row.area_fraction > 0.0) {
      const double radius =
          std::sqrt(row.area_fraction * nominal_area / std::numbers::pi);
      largest =
          std::fmax(largest, std::abs(row.nominal_pressure * nominal_area -
                                      sphere.contact(radius).load) /
                                 sphere.pull_off_force());
    }
  return largest;
}

/// Adds the largest error of a sphere with Dugdale's law.
void add_sphere_error(const results::Result& result,
                      const cases::Case& contact_case,
                      const results::MethodRecord& method,
                      MethodSummary& summary) {
  const results::SurfaceRecord* const surface = surface_of(result, method, 0);
  const mechanics::ContactSettings& contact =
      *spec_of(contact_case, method)->contact();
  if (contact_case.surface.kind != mechanics::SurfaceKind::sphere ||
      contact.law != mechanics::ContactLaw::dugdale || surface == nullptr)
    return;
  const mechanics::ContactInterface law =
      contact.in_si({.contact_modulus = result.contact_modulus,
                     .length = surface->grid.length_x,
                     .spacing = surface->grid.spacing_x()});
  const theory::MaugisSphere sphere({contact_case.surface.radius,
                                     result.contact_modulus,
                                     law.work_of_adhesion},
                                    -law.pressure_bounds().smallest);
  double error = not_a_number;
  for (const results::Curve& curve : method.realizations)
    error = std::fmax(error, sphere_error(converged_rows(curve), sphere,
                                          surface->grid.area()));
  summary.quantities["adhesive_sphere_error"] =
      largest_estimate(error, "no step has a contact");
}

} // namespace

void add_adhesion_quantities(const results::Result& result,
                             const cases::Case& contact_case,
                             const results::MethodRecord& method,
                             MethodSummary& summary) {
  if (!is_adhesive(contact_case, method))
    return;
  const double work =
      spec_of(contact_case, method)->contact()->work_of_adhesion;
  std::vector<FittedValue> tension;
  std::vector<FittedValue> dissipated;
  tension.reserve(method.realizations.size());
  dissipated.reserve(method.realizations.size());
  double error = not_a_number;
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const bool is_wave = surface.kind == mechanics::SurfaceKind::wave_1d;
  for (const results::Curve& curve : method.realizations) {
    const std::vector<CurvePoint> rows = converged_rows(curve);
    tension.push_back(
        {.value = largest_tension(rows) / result.contact_modulus});
    dissipated.push_back({.value = dissipated_energy(rows) / work});
    if (is_wave)
      error =
          std::fmax(error, wave_error(rows,
                                      {surface.amplitude, surface.wavelength,
                                       result.contact_modulus},
                                      work));
  }
  summary.quantities["pull_off_pressure"] = mean_over_realizations(tension);
  Estimate& lost = summary.quantities["dissipated_energy"];
  lost = mean_over_realizations(dissipated);
  if (!lost.has_value())
    lost.remark = "the path does not return to the gap where it began";
  if (is_wave)
    summary.quantities["adhesive_wave_error"] =
        largest_estimate(error, "no step has a partial contact");
  add_sphere_error(result, contact_case, method, summary);
}

} // namespace asperity::reports
