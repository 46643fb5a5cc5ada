#include "run/sweeps/sweep_plan.hpp"

#include "base/available_memory.hpp"
#include "input/input_error.hpp"
#include "methods/worker_pool.hpp"
#include "run/plan/memory_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::run {

double SweepPlan::cpu_time() const {
  double sum = 0.0;
  for (const Plan& point : points)
    sum += point.cpu_time;
  return sum;
}

double SweepPlan::wall_time() const {
  double longest = 0.0;
  for (const Plan& point : points)
    longest = std::max(longest, point.wall_time);
  return std::max(longest,
                  cpu_time() / std::min(threads, std::max(beside(), 1)));
}

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
                          const RunOptions& options, int largest_probe) {
  SweepPlan plan;
  plan.threads = methods::WorkerPool(options.threads).threads();
  plan.available_memory = available_memory();
  MachineRates rates(largest_probe);
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    plan.points.push_back(
        make_plan(sweep.points[i].contact_case, options, rates));
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
  std::string text = fmt::format("{}: {}\n{:>5} {:>7} {:>7} {:>8} {:>8}  {}\n",
                                 sweep.name, sweep.title, "point", "steps",
                                 "cached", "CPU", "memory", "values");
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const Plan& point = plan.points[i];
    int steps = 0;
    int kept = 0;
    for (const PlannedMethod& method : point.methods) {
      steps += method.steps;
      kept += method.kept_steps;
    }
    text += fmt::format("{:>5} {:>7} {:>7} {:>8} {:>8}  {}\n", i, steps, kept,
                        time_text(point.cpu_time), size_text(point.memory),
                        point_label(sweep.keys, sweep.points[i].choice));
  }
  double factor = 1.0;
  for (const Plan& point : plan.points)
    factor = std::max(factor, point.factor);
  return text + fmt::format(
                    "predicted: {} points, {} beside each other, CPU {}, {} on "
                    "{} thread{}, within a factor of {:g} (not including the "
                    "report)\n",
                    plan.points.size(), plan.beside(),
                    time_text(plan.cpu_time()), time_text(plan.wall_time()),
                    plan.threads, plan.threads == 1 ? "" : "s", factor);
}

} // namespace asperity::run
