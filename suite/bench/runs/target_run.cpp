#include "suite/bench/runs/target_run.hpp"

#include "input/reader/case_hash.hpp"
#include "input/reader/read_case.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "suite/bench/analysis/bench_answer.hpp"
#include "suite/bench/pages/bench_report.hpp"
#include "suite/bench/settings/bench_plan.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace asperity::bench {
namespace {

BenchRunnerOptions search_options(const cases::Case& contact_case,
                                  const std::filesystem::path& file,
                                  std::vector<std::string> overrides,
                                  const std::filesystem::path& folder) {
  for (std::string& one : common_overrides(contact_case, 1))
    overrides.push_back(std::move(one));
  return {file, std::move(overrides), folder / "target-error", 1,
          std::numeric_limits<double>::infinity()};
}

} // namespace

TargetRun::TargetRun(const cases::Case& contact_case,
                     std::filesystem::path file,
                     std::vector<std::string> overrides,
                     const std::filesystem::path& folder, double target)
    : file_(std::move(file)),
      overrides_(std::move(overrides)),
      lengths_(
          common_overrides(contact_case, contact_case.surface.realizations)),
      search_(contact_case,
              search_options(contact_case, file_, overrides_, folder)) {
  fmt::print("{}: searching for the cheapest setting with an error below {}\n",
             contact_case.name, per_cent(target));
  outcome_ = search_.choose(target);
  if (is_chosen())
    print_choice();
  else
    fmt::print("{}\n", outcome_.problem);
}

void TargetRun::print_choice() const {
  fmt::print("chosen: {}; predicted {:.3g} s of CPU time per realisation\n",
             outcome_.chosen, outcome_.predicted_cpu_time);
}

bool TargetRun::choose_again() {
  const bool is_again = search_.choose_again(outcome_);
  fmt::print("{}\n", outcome_.earlier.back());
  if (is_again)
    print_choice();
  return is_again;
}

cases::Case TargetRun::chosen_case() const {
  std::vector<std::string> overrides = overrides_;
  overrides.insert(overrides.end(), lengths_.begin(), lengths_.end());
  overrides.insert(overrides.end(), outcome_.overrides.begin(),
                   outcome_.overrides.end());
  return cases::read_case(file_.string(), overrides);
}

bool TargetRun::verify(const cases::Case& chosen,
                       const std::filesystem::path& folder) {
  results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  std::map<std::string, BenchAnswer> answers;
  for (results::MethodRecord& method : result.methods)
    if (!method.realizations.empty())
      method.realizations.resize(1); // as in the finer runs
  for (const results::MethodRecord& method : result.methods)
    answers[method.name] = answer_of(result, chosen, method.name);
  search_.verify(outcome_, answers);
  return outcome_.is_met();
}

void TargetRun::record(const std::filesystem::path& folder) const {
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  print_outcome(outcome_);
  results::ResultWriter writer(
      folder,
      {result.case_name, result.case_title, result.case_text, result.case_hash,
       result.contact_modulus, result.reference, results::inputs_of(result)},
      results::ResultWriter::Mode::resume);
  writer.record_provenance(facts_of(outcome_));
  writer.finish(result.status);
}

} // namespace asperity::bench
