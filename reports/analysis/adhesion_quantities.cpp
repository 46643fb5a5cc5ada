#include "reports/analysis/exact.hpp"
#include "results/types/method_columns.hpp"
#include "theory/exact/adhesive_sphere.hpp"
#include "theory/exact/westergaard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::reports {

std::vector<results::CurvePoint> converged_rows(const results::Curve& curve) {
  std::vector<results::CurvePoint> rows;
  for (const results::CurvePoint& row : curve.points)
    if (row.status == results::StepStatus::converged)
      rows.push_back(row);
  return rows;
}

double largest_tension(std::span<const results::CurvePoint> rows) {
  double largest = 0.0;
  for (const results::CurvePoint& row : rows)
    largest = std::max({largest, -row.nominal_pressure,
                        std::fmax(0.0, -row[columns::jump_pressure])});
  return largest;
}

std::string why_more_may_hold(std::span<const results::CurvePoint> rows) {
  const double tension = largest_tension(rows);
  if (!(tension > 0.0))
    return "";
  if (rows.back().nominal_pressure == -tension)
    return "because the faces hold it at the end of the path";
  return std::ranges::all_of(rows,
                             [](const results::CurvePoint& row) {
                               return row.nominal_pressure < 0.0;
                             })
             ? "because the path never presses the faces"
             : "";
}

namespace {

using results::CurvePoint;

/// The largest tension of a path over E*, which one that was interrupted has
/// not reached, and one whose loads all press does not show.
FittedValue pull_off(const results::Curve& curve,
                     const cases::Case& contact_case, double contact_modulus) {
  const std::size_t steps = contact_case.load.targets.size();
  if (curve.points.size() < steps)
    return {.reason = fmt::format("the path has {} of its {} steps",
                                  curve.points.size(), steps)};
  const std::vector<CurvePoint> rows = converged_rows(curve);
  if (std::ranges::all_of(rows, [](const CurvePoint& row) {
        return row.nominal_pressure > 0.0;
      }))
    return {.reason = "no load of the path pulls"};
  return {.value = largest_tension(rows) / contact_modulus};
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

/// The first state without load of a part of a path, whose energy is a minimum
/// over the mean gap.
struct UnloadedState {
  double area = not_a_number;   ///< A/A_0 [1]
  double gap = not_a_number;    ///< mean gap [m]
  double energy = not_a_number; ///< U [J/m^2] per nominal area
};

/// Returns the first state of this part of a path at which the pressure is
/// zero; between two rows by linear interpolation, with U' = -p.
UnloadedState unloaded_state(const std::vector<CurvePoint>& rows,
                             bool is_unloading) {
  const auto energy_of = [](const CurvePoint& row) {
    return row.elastic_energy + row[columns::adhesive_energy];
  };
  double largest = 0.0;
  for (const CurvePoint& row : rows)
    largest = std::max(largest, std::abs(row.nominal_pressure));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CurvePoint& row = rows[i];
    if (row.is_unloading != is_unloading)
      continue;
    if (std::abs(row.nominal_pressure) <= 1e-9 * largest &&
        row.area_fraction > 0.0) // otherwise a tension has parted the faces
      return {row.area_fraction, row.mean_gap, energy_of(row)};
    if (i == 0)
      continue;
    const CurvePoint& last = rows[i - 1];
    const double step = row.mean_gap - last.mean_gap;
    const double rise = row.nominal_pressure - last.nominal_pressure;
    const double part = -last.nominal_pressure / rise;
    if (part > 0.0 && part < 1.0 && rise * step < 0.0)
      return {std::lerp(last.area_fraction, row.area_fraction, part),
              last.mean_gap + part * step,
              energy_of(last) - 0.5 * last.nominal_pressure * part * step};
  }
  return {};
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

/// Adds the states without load on the way in and on the way out.
void add_unloaded_states(const results::Result& result,
                         const results::MethodRecord& method,
                         double work_of_adhesion, MethodSummary& summary) {
  for (const bool is_unloading : {false, true}) {
    const std::string part = is_unloading ? "retraction" : "approach";
    const std::string reason = "no state without load on the " + part;
    std::vector<FittedValue> areas, gaps, works;
    const std::size_t count = method.realizations.size();
    areas.reserve(count);
    gaps.reserve(count);
    works.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const UnloadedState state =
          unloaded_state(converged_rows(method.realizations[i]), is_unloading);
      const auto* const surface = surface_of(result, method, i);
      areas.push_back({.value = state.area, .reason = reason});
      gaps.push_back({.value = surface == nullptr
                                   ? not_a_number
                                   : state.gap / surface->rms_height,
                      .reason = reason});
      works.push_back(
          {.value = -state.energy / work_of_adhesion, .reason = reason});
    }
    summary.quantities["unloaded_area_" + part] = mean_over_realizations(areas);
    summary.quantities["unloaded_gap_" + part] = mean_over_realizations(gaps);
    summary.quantities["effective_work_" + part] =
        mean_over_realizations(works);
  }
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
  const mechanics::ContactInterface law =
      *adhesion_of(result, contact_case, method);
  if (contact_case.surface.kind != mechanics::SurfaceKind::sphere ||
      law.law != mechanics::ContactLaw::dugdale)
    return;
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

/// Returns the largest |p - p_other| of equal steps, at equal mean gaps, over
/// the largest tension of the other rows; NaN if there are none.
/// @param rows, others  in the order of the path
double largest_difference(const std::vector<CurvePoint>& rows,
                          const std::vector<CurvePoint>& others) {
  double difference = not_a_number;
  for (const CurvePoint& row : rows) {
    const auto other =
        std::ranges::lower_bound(others, row.step, {}, &CurvePoint::step);
    if (other != others.end() && other->step == row.step &&
        std::abs(row.mean_gap - other->mean_gap) <=
            1e-6 * std::abs(other->mean_gap))
      difference = std::fmax(
          difference, std::abs(row.nominal_pressure - other->nominal_pressure));
  }
  return difference / largest_tension(others);
}

/// Adds the difference from the first other method with adhesion, if that is
/// before this one.
void add_difference(const results::Result& result,
                    const cases::Case& contact_case,
                    const results::MethodRecord& method,
                    MethodSummary& summary) {
  const auto first = std::ranges::find_if(
      result.methods, [&](const results::MethodRecord& other) {
        return is_adhesive(contact_case, other);
      });
  if (first->name == method.name)
    return;
  const std::size_t count =
      std::min(method.realizations.size(), first->realizations.size());
  double difference = not_a_number;
  for (std::size_t i = 0; i < count; ++i)
    difference = std::fmax(
        difference, largest_difference(converged_rows(method.realizations[i]),
                                       converged_rows(first->realizations[i])));
  Estimate& largest = summary.quantities["adhesive_difference"];
  largest = largest_estimate(
      difference, "no steps at the same mean gap as the first method");
  if (largest.has_value())
    largest.remark = "largest over the loads at equal mean gaps";
}

} // namespace

void add_adhesion_quantities(const results::Result& result,
                             const cases::Case& contact_case,
                             const results::MethodRecord& method,
                             MethodSummary& summary) {
  const auto law = adhesion_of(result, contact_case, method);
  if (!law)
    return;
  const double work = law->work_of_adhesion;
  std::vector<FittedValue> tension;
  std::vector<FittedValue> dissipated;
  tension.reserve(method.realizations.size());
  dissipated.reserve(method.realizations.size());
  double error = not_a_number;
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const bool is_wave = surface.kind == mechanics::SurfaceKind::wave_1d;
  for (const results::Curve& curve : method.realizations) {
    const std::vector<CurvePoint> rows = converged_rows(curve);
    tension.push_back(pull_off(curve, contact_case, result.contact_modulus));
    dissipated.push_back({.value = dissipated_energy(rows) / work});
    if (is_wave)
      error =
          std::fmax(error, wave_error(rows,
                                      {surface.amplitude, surface.wavelength,
                                       result.contact_modulus},
                                      work));
  }
  add_unloaded_states(result, method, work, summary);
  summary.quantities["pull_off_pressure"] = mean_over_realizations(tension);
  Estimate& lost = summary.quantities["dissipated_energy"];
  lost = mean_over_realizations(dissipated);
  if (!lost.has_value())
    lost.remark = "the path does not return to the gap where it began";
  if (is_wave)
    summary.quantities["adhesive_wave_error"] =
        largest_estimate(error, "no step has a partial contact");
  add_sphere_error(result, contact_case, method, summary);
  add_difference(result, contact_case, method, summary);
}

} // namespace asperity::reports
