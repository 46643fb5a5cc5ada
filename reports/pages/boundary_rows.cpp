// Compares half-spaces with free and with periodic boundaries on the same
// surface, as rows of the page.
#include "base/shown_number.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;

/// Returns the converged row of a step, or null.
const CurvePoint* converged_row(const results::MethodRecord& method, int step) {
  if (method.realizations.empty())
    return nullptr;
  for (const CurvePoint& row : method.realizations.front().points)
    if (row.step == step && row.status == results::StepStatus::converged)
      return &row;
  return nullptr;
}

kainjow::mustache::data boundary_row(const CurvePoint& free,
                                     const CurvePoint& periodic,
                                     double contact_modulus,
                                     double rms_height) {
  const auto percent = [](double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
  };
  kainjow::mustache::data row;
  row.set("pressure",
          fmt::format("{:.3g}", free.nominal_pressure / contact_modulus));
  row.set("area_free", percent(free.area_fraction));
  row.set("area_periodic", percent(periodic.area_fraction));
  row.set(
      "area_ratio",
      fmt::format(
          "{:+.2g} %",
          Shown{100.0 * (periodic.area_fraction / free.area_fraction - 1.0)}));
  row.set("gap_free", fmt::format("{:.4g}", Shown{free.mean_gap / rms_height}));
  row.set("gap_periodic",
          fmt::format("{:.4g}", Shown{periodic.mean_gap / rms_height}));
  row.set("iterations_free", std::to_string(free.iterations));
  row.set("iterations_periodic", std::to_string(periodic.iterations));
  return row;
}

} // namespace

kainjow::mustache::list boundary_rows(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  const results::MethodRecord* free = nullptr;
  const results::MethodRecord* periodic = nullptr;
  for (const results::MethodRecord& method : result.methods) {
    if (method.kind != "halfspace")
      continue;
    const bool is_free = has_free_boundaries(*entry.contact_case, method);
    const results::MethodRecord*& first = is_free ? free : periodic;
    if (first == nullptr)
      first = &method;
  }
  kainjow::mustache::list rows;
  if (free == nullptr || periodic == nullptr || free->realizations.empty() ||
      result.surfaces.empty())
    return rows;
  for (const CurvePoint& row : free->realizations.front().points) {
    const CurvePoint* const other = converged_row(*periodic, row.step);
    if (other != nullptr && row.status == results::StepStatus::converged)
      rows.push_back(boundary_row(row, *other, result.contact_modulus,
                                  result.surfaces.front().rms_height));
  }
  return rows;
}

} // namespace asperity::reports
