// Compares the cost of full 3-D finite-element models with each other and with
// the condensed model, as rows of the page.
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

/// Sums over the load steps of all realisations; for properties of the
/// finite-element model (unknowns, memory), the maximum.
struct BlockCost {
  double unknowns = 0.0, memory = 0.0, setup_time = 0.0, step_time = 0.0;
  double fewest_unknowns = std::numeric_limits<double>::infinity();
  int steps = 0, iterations = 0, linear_iterations = 0, setups = 0;
};

BlockCost block_cost_of(const MethodRecord& method) {
  BlockCost cost;
  for (const results::Curve& curve : method.realizations) {
    cost.setup_time += curve.setup_cpu_time;
    for (const CurvePoint& point : curve.points) {
      ++cost.steps;
      cost.unknowns = std::fmax(cost.unknowns, point.unknowns);
      if (point.unknowns > 0.0)
        cost.fewest_unknowns = std::min(cost.fewest_unknowns, point.unknowns);
      cost.memory = std::fmax(cost.memory, point.memory);
      cost.step_time += point.cpu_time;
      cost.iterations += point.iterations;
      cost.linear_iterations += point.linear_iterations;
      cost.setups += point.preconditioner_setups;
    }
  }
  return cost;
}

/// The unknowns of the finite-element model, whose mesh may change from step to
/// step.
std::string unknowns_text(const BlockCost& cost) {
  if (!(cost.unknowns > 0.0))
    return "contact surface only";
  return cost.fewest_unknowns < cost.unknowns
             ? fmt::format("{:.0f} to {:.0f}", cost.fewest_unknowns,
                           cost.unknowns)
             : fmt::format("{:.0f}", cost.unknowns);
}

std::string a_step(double sum, int steps) {
  return steps == 0 ? "–" : fmt::format("{:.3g}", sum / steps);
}

kainjow::mustache::data row_of(const MethodRecord& method) {
  const BlockCost cost = block_cost_of(method);
  const bool has_block = cost.unknowns > 0.0;
  kainjow::mustache::data row;
  row.set("name", method.name);
  row.set("unknowns", unknowns_text(cost));
  row.set("setup", fmt::format("{:.2g} s", cost.setup_time));
  row.set("iterations", a_step(cost.iterations, cost.steps));
  row.set("linear_iterations",
          has_block ? a_step(cost.linear_iterations, cost.steps) : "–");
  row.set("setups", has_block ? a_step(cost.setups, cost.steps) : "–");
  row.set("step", a_step(cost.step_time, cost.steps) + " s");
  row.set("memory", cost.memory > 0.0
                        ? fmt::format("{:.3g} MB", 1e-6 * cost.memory)
                        : "–");
  return row;
}

} // namespace

kainjow::mustache::list block_cost_rows(const results::Result& result) {
  kainjow::mustache::list rows;
  const bool has_full_block =
      std::ranges::any_of(result.methods, [](const MethodRecord& method) {
        return block_cost_of(method).unknowns > 0.0;
      });
  if (has_full_block)
    for (const MethodRecord& method : result.methods)
      if (method.kind == "fem" || method.kind == "halfspace")
        rows.push_back(row_of(method));
  return rows;
}

} // namespace asperity::reports
