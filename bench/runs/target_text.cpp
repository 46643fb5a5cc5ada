#include "bench/runs/target_text.hpp"

#include "bench/pages/bench_report.hpp"

#include <fmt/format.h>

namespace asperity::bench {
namespace {

std::string numbers_of(const TargetOutcome& outcome, const TargetCheck& check) {
  return fmt::format("target {}, predicted {}, found {}",
                     per_cent(outcome.target), per_cent(check.predicted),
                     per_cent(check.found));
}

} // namespace

void print_outcome(const TargetOutcome& outcome) {
  if (!outcome.problem.empty()) {
    fmt::print("target error: {}\n", outcome.problem);
    return;
  }
  for (const std::string& words : outcome.earlier)
    fmt::print("target error, earlier attempt: {}\n", words);
  fmt::print("target error: {}; predicted {:.3g} s of CPU time\n",
             outcome.chosen, outcome.predicted_cpu_time);
  for (const TargetCheck& check : outcome.checks)
    fmt::print("{} of {} ({}): {}: {}\n", check.quantity, check.method,
               check.estimator, numbers_of(outcome, check),
               check.is_met ? "met" : "MISSED");
}

results::Provenance facts_of(const TargetOutcome& outcome) {
  results::Provenance facts{{"target error", per_cent(outcome.target)},
                            {"target error, verified", outcome.finer}};
  for (std::size_t i = 0; i < outcome.earlier.size(); ++i)
    facts.emplace_back(fmt::format("target error, before ({})", i + 1),
                       outcome.earlier[i]);
  for (const TargetCheck& check : outcome.checks)
    facts.emplace_back(
        fmt::format("target error, {} of {}", check.quantity, check.method),
        fmt::format("{}: {} ({})", numbers_of(outcome, check),
                    check.is_met ? "met" : "missed", check.estimator));
  return facts;
}

} // namespace asperity::bench
