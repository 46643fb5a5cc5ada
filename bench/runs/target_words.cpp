#include "bench/runs/target_words.hpp"

#include <fmt/format.h>

#include "bench/pages/bench_report.hpp"

namespace asperity::app {
namespace {

using reports::per_cent;

std::string numbers_of(const reports::TargetOutcome& outcome,
                       const reports::Promise& promise) {
  return fmt::format("target {}, predicted {}, found {}",
                     per_cent(outcome.target), per_cent(promise.predicted),
                     per_cent(promise.found));
}

} // namespace

void print_outcome(const reports::TargetOutcome& outcome) {
  if (!outcome.problem.empty()) {
    fmt::print("target error: {}\n", outcome.problem);
    return;
  }
  for (const std::string& words : outcome.earlier)
    fmt::print("target error, earlier attempt: {}\n", words);
  fmt::print("target error: {}; predicted {:.3g} s of CPU time\n",
             outcome.chosen, outcome.predicted_cpu_time);
  for (const reports::Promise& promise : outcome.promises)
    fmt::print("{} of {} ({}): {}: {}\n", promise.quantity, promise.method,
               promise.estimator, numbers_of(outcome, promise),
               promise.is_kept ? "met" : "MISSED");
}

results::Provenance facts_of(const reports::TargetOutcome& outcome) {
  results::Provenance facts{{"target error", per_cent(outcome.target)},
                            {"target error, verified", outcome.finer}};
  for (std::size_t i = 0; i < outcome.earlier.size(); ++i)
    facts.emplace_back(fmt::format("target error, before ({})", i + 1),
                       outcome.earlier[i]);
  for (const reports::Promise& promise : outcome.promises)
    facts.emplace_back(
        fmt::format("target error, {} of {}", promise.quantity, promise.method),
        fmt::format("{}: {} ({})", numbers_of(outcome, promise),
                    promise.is_kept ? "met" : "missed", promise.estimator));
  return facts;
}

} // namespace asperity::app
