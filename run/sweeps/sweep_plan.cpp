#include "run/sweeps/sweep_plan.hpp"

#include "base/available_memory.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "methods/worker_pool.hpp"
#include "run/plan/memory_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::run {

int SweepPlan::beside() const {
  double largest = 0.0;
  for (const Plan& point : points)
    largest = std::fmax(largest, point.memory);
  const double fitting =
      largest > 0.0 ? std::floor(available_memory / largest) : 1.0;
  const double most = std::min(static_cast<double>(threads),
                               static_cast<double>(points.size()));
  return std::max(1, static_cast<int>(std::min(most, fitting)));
}

SweepPlan make_sweep_plan(const cases::CaseSweep& sweep,
                          const RunOptions& options) {
  SweepPlan plan;
  plan.threads = methods::WorkerPool(options.threads).threads();
  plan.available_memory = available_memory();
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    plan.points.push_back(make_plan(sweep.points[i].contact_case, options));
    if (const std::string refusal = refusal_of(plan.points.back());
        !refusal.empty())
      throw input::InputError(fmt::format(
          "{}: point {} of [sweep], {}, {}", sweep.path, i,
          point_label(sweep.keys, sweep.points[i].choice), refusal));
  }
  return plan;
}

std::string sweep_plan_text(const SweepPlan& plan,
                            const cases::CaseSweep& sweep) {
  std::string text =
      fmt::format("{}: {}\n{:>5} {:>7} {:>7} {:>9}  {}\n", sweep.name,
                  sweep.title, "point", "steps", "cached", "memory", "values");
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    int steps = 0;
    int kept = 0;
    for (const PlannedMethod& method : plan.points[i].methods) {
      steps += method.steps;
      kept += method.kept_steps;
    }
    text += fmt::format("{:>5} {:>7} {:>7} {:>9}  {}\n", i, steps, kept,
                        bytes_text(plan.points[i].memory),
                        point_label(sweep.keys, sweep.points[i].choice));
  }
  return text + fmt::format("{} points, {} beside each other on {} thread{}\n",
                            plan.points.size(), plan.beside(), plan.threads,
                            plan.threads == 1 ? "" : "s");
}

} // namespace asperity::run
