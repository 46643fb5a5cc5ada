// The tables of summary.json that only some results have.
#include "base/json.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/study_pages.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;
using results::CurvePoint;
using results::MethodRecord;

/// Sums over the load steps of all realisations; for properties of the
/// finite-element model (unknowns, memory), the maximum.
struct BlockCost {
  double unknowns = 0.0, memory = 0.0, setup_time = 0.0, step_time = 0.0;
  double fewest_unknowns = std::numeric_limits<double>::infinity();
  int steps = 0, iterations = 0;
  double linear_iterations = 0.0, setups = 0.0;
};

BlockCost block_cost_of(const MethodRecord& method) {
  BlockCost cost;
  for (const results::Curve& curve : method.realizations) {
    cost.setup_time += curve.setup_cpu_time;
    for (const CurvePoint& point : curve.points) {
      ++cost.steps;
      cost.unknowns = std::fmax(cost.unknowns, point[columns::unknowns]);
      if (point[columns::unknowns] > 0.0)
        cost.fewest_unknowns =
            std::min(cost.fewest_unknowns, point[columns::unknowns]);
      cost.memory = std::fmax(cost.memory, point[columns::memory]);
      cost.step_time += point.cpu_time;
      cost.iterations += point.iterations;
      cost.linear_iterations += point[columns::linear_iterations];
      cost.setups += point[columns::preconditioner_setups];
    }
  }
  return cost;
}

Json block_cost_row(const MethodRecord& method) {
  const BlockCost cost = block_cost_of(method);
  const bool has_block = cost.unknowns > 0.0;
  const auto a_step = [&](double sum) {
    return cost.steps == 0 ? not_a_number : sum / cost.steps;
  };
  return {
      {"method", method.name},
      {"unknowns", has_block ? cost.unknowns : not_a_number},
      {"fewest_unknowns", cost.fewest_unknowns < cost.unknowns
                              ? cost.fewest_unknowns
                              : not_a_number},
      {"setup_cpu_time [s]", cost.setup_time},
      {"iterations", a_step(cost.iterations)},
      {"linear_iterations",
       has_block ? a_step(cost.linear_iterations) : not_a_number},
      {"preconditioner_setups", has_block ? a_step(cost.setups) : not_a_number},
      {"step_cpu_time [s]", a_step(cost.step_time)},
      {"memory [B]", cost.memory > 0.0 ? cost.memory : not_a_number}};
}

/// Each finite-element method and the half-spaces, if one method solved a full
/// 3-D block.
Json block_costs(const results::Result& result) {
  Json rows = Json::array();
  if (std::ranges::any_of(result.methods, [](const MethodRecord& method) {
        return block_cost_of(method).unknowns > 0.0;
      }))
    for (const MethodRecord& method : result.methods)
      if (method.kind == "fem" || method.kind == "halfspace")
        rows.push_back(block_cost_row(method));
  return rows;
}

/// Returns the converged row of a step, or null.
const CurvePoint* converged_row(const MethodRecord& method, int step) {
  if (method.realizations.empty())
    return nullptr;
  for (const CurvePoint& row : method.realizations.front().points)
    if (row.step == step && row.status == results::StepStatus::converged)
      return &row;
  return nullptr;
}

/// The first half-space with free boundaries beside the first periodic one, at
/// each load step of realisation 0.
Json boundaries(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  const MethodRecord* free = nullptr;
  const MethodRecord* periodic = nullptr;
  for (const MethodRecord& method : result.methods) {
    if (method.kind != "halfspace")
      continue;
    const bool is_free = has_free_boundaries(*entry.contact_case, method);
    const MethodRecord*& first = is_free ? free : periodic;
    if (first == nullptr)
      first = &method;
  }
  Json rows = Json::array();
  if (free == nullptr || periodic == nullptr || free->realizations.empty() ||
      result.surfaces.empty())
    return rows;
  const double height = result.surfaces.front().rms_height;
  for (const CurvePoint& row : free->realizations.front().points) {
    const CurvePoint* const other = converged_row(*periodic, row.step);
    if (other == nullptr || row.status != results::StepStatus::converged)
      continue;
    rows.push_back(
        {{"pressure [E*]", row.nominal_pressure / result.contact_modulus},
         {"area_free", row.area_fraction},
         {"area_periodic", other->area_fraction},
         {"area_difference", other->area_fraction / row.area_fraction - 1.0},
         {"gap_free [h_rms]", row.mean_gap / height},
         {"gap_periodic [h_rms]", other->mean_gap / height},
         {"iterations_free", row.iterations},
         {"iterations_periodic", other->iterations}});
  }
  return rows;
}

/// Each converged load step of realisation 0 that has a stiffness, or whose
/// centre of pressure is more than 1e-6 of the side off the middle.
Json stiffness(const results::Result& result) {
  Json rows = Json::array();
  for (const MethodRecord& method : result.methods) {
    const results::SurfaceRecord* const surface = surface_of(result, method, 0);
    if (surface == nullptr || method.realizations.empty())
      continue;
    const double side = surface->grid.length_x;
    const auto distance = [side](double metres) { // 0 if it is roundoff
      return std::abs(metres) < 1e-9 * side ? 0.0 : metres;
    };
    for (const CurvePoint& point : method.realizations.front().points) {
      const bool is_shown =
          point.status == results::StepStatus::converged &&
          (std::isfinite(
               point[columns::tangential_stiffness]) || // of a full block
           std::hypot(point[columns::pressure_centre.x],
                      point[columns::pressure_centre.y]) > 1e-6 * side);
      if (!is_shown)
        continue;
      rows.push_back(
          {{"method", method.name},
           {"pressure [E*]", point.nominal_pressure / result.contact_modulus},
           {"normal [N/m]", point[columns::normal_stiffness]},
           {"tangential [N/m]", point[columns::tangential_stiffness]},
           {"ratio", point[columns::tangential_stiffness] /
                         point[columns::normal_stiffness]},
           {"centre_x [m]", distance(point[columns::pressure_centre.x])},
           {"centre_y [m]", distance(point[columns::pressure_centre.y])}});
    }
  }
  return rows;
}

/// The mean along y, unless that along x has the same four digits.
Json skipped(const results::Result& result) {
  Json rows = Json::array();
  for (const results::Skipped& one : result.skipped)
    rows.push_back({{"what", one.what}, {"why", one.why}});
  return rows;
}

} // namespace

Json page_summary(const ReportEntry& entry) {
  Json json = summary_data(entry.summary,
                           warnings_of(*entry.result, *entry.contact_case));
  json["contact_against_load"] = contact_against_load(entry);
  json["boundaries"] = boundaries(entry);
  json["stiffness"] = stiffness(*entry.result);
  for (const StudyPages* const study : study_pages())
    if (study->add_tables != nullptr)
      study->add_tables(entry, json);
  json["block_costs"] = block_costs(*entry.result);
  json["skipped"] = skipped(*entry.result);
  return json;
}

} // namespace asperity::reports
