#include "run/distributed/task_needs.hpp"

#include "run/plan/plan.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::run {
namespace {

constexpr int time_probe_points = 1024; // as for the plan of one case

/// Keeps the larger prediction; one that does not exist is kept, too.
void keep_larger(double& largest, double value) {
  if (std::isnan(value) || value > largest)
    largest = value;
}

RunOptions options_of_task(const PartRequest& request, int threads) {
  RunOptions options{{}, request.methods, false, threads};
  options.is_exact = request.is_exact;
  return options;
}

TaskNeeds needs_for_realizations(const cases::Case& contact_case,
                                 const std::vector<PartRecord>& records,
                                 int threads) {
  MachineRates rates(time_probe_points);
  TaskNeeds needs;
  for (const PartRecord& record : records) {
    RunOptions options = options_of_task(record.request, threads);
    options.realizations = {record.members.begin(), record.members.end()};
    const Plan plan = make_plan(contact_case, options, rates);
    keep_larger(needs.time, plan.factor * plan.wall_time);
    keep_larger(needs.memory, plan.factor * plan.memory);
  }
  return needs;
}

/// Points run beside each other, each on one thread at least.
TaskNeeds needs_for_points(const cases::CaseSweep& sweep,
                           const std::vector<PartRecord>& records,
                           int threads) {
  MachineRates rates(time_probe_points);
  TaskNeeds needs;
  for (const PartRecord& record : records) {
    double time = 0.0;
    double memory = 0.0;
    for (const std::size_t point : record.members) {
      const Plan plan =
          make_plan(sweep.points[point].contact_case,
                    options_of_task(record.request, threads), rates);
      time += plan.factor * plan.cpu_time;
      keep_larger(memory, plan.factor * plan.memory);
    }
    keep_larger(needs.time, time);
    keep_larger(needs.memory,
                memory * std::min(static_cast<double>(threads),
                                  static_cast<double>(record.members.size())));
  }
  return needs;
}

} // namespace

TaskNeeds task_needs(const NamedCases& named,
                     const std::vector<PartRecord>& records, int threads) {
  return named.sweep ? needs_for_points(named.sweep->sweep, records, threads)
                     : needs_for_realizations(named.cases.front().contact_case,
                                              records, threads);
}

} // namespace asperity::run
