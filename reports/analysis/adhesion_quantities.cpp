#include "reports/analysis/exact.hpp"
#include "theory/exact/westergaard.hpp"

#include <algorithm>
#include <cmath>
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
    largest = std::max(largest, -row.nominal_pressure);
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
}

} // namespace asperity::reports
