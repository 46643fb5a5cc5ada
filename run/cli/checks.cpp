#include "run/cli/checks.hpp"

#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "input/input_error.hpp"
#include "reports/analysis/verdict.hpp"
#include "run/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace asperity::cli {
namespace {

/// Returns the lines of the expectations of a result that are not met.
std::string lines_not_met(const reports::Summary& summary) {
  std::string text;
  for (const reports::Verdict& verdict : summary.verdicts)
    if (!verdict.is_passed() && verdict.outcome != reports::Outcome::skipped)
      text += fmt::format("{}: {}\n", summary.case_name,
                          reports::check_line(verdict));
  return text;
}

} // namespace

run::ExitCode worse(run::ExitCode one, run::ExitCode other) {
  return std::max(one, other);
}

Failure failure_of(const std::exception& error) {
  if (const auto* of_file =
          dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    const std::error_code& code = of_file->code();
    return {fmt::format("asperity: {}: {}", of_file->path1().string(),
                        code.message()),
            code == std::errc::filename_too_long ||
                    code == std::errc::too_many_symbolic_link_levels
                ? run::exit_bad_input
                : run::exit_internal};
  }
  if (dynamic_cast<const input::InputError*>(&error) != nullptr ||
      dynamic_cast<const std::domain_error*>(&error) != nullptr ||
      dynamic_cast<const UnusableFolder*>(&error) != nullptr)
    return {error.what(), run::exit_bad_input};
  return {fmt::format("asperity: {}", error.what()), run::exit_internal};
}

void print_verdicts(const reports::Summary& summary) {
  for (const reports::Verdict& verdict : summary.verdicts)
    fmt::print("{}\n", reports::check_line(verdict));
  for (const reports::PublishedValue& published : summary.published)
    if (!published.ours.empty())
      fmt::print("{}\n", reports::published_line(published));
  for (const auto& method : summary.methods) {
    if (method.cost.failed_steps > 0)
      fmt::print("{}: {} of {} steps did not converge\n", method.name,
                 method.cost.failed_steps, method.cost.steps);
    for (const std::string& problem : method.problems)
      fmt::print("{}: could not be computed: {}\n", method.name, problem);
  }
}

run::ExitCode exit_code_of(const reports::Summary& summary) {
  const bool has_failed_steps = std::any_of(
      summary.methods.begin(), summary.methods.end(),
      [](const auto& method) { return method.cost.failed_steps > 0; });
  if (has_failed_steps)
    return run::exit_not_converged;
  return summary.all_ok() ? run::exit_good : run::exit_expectation_failed;
}

run::ExitCode print_findings(const reports::Summary& summary,
                             const std::filesystem::path& folder) {
  print_verdicts(summary);
  for (const std::string& answer : summary.answers)
    fmt::print("{}\n", answer);
  if (const std::string parts = reports::parts_sentence(summary.interval_parts);
      !parts.empty())
    fmt::print("{}\n", parts);
  fmt::print("report: {}\n", (folder / "report.html").string());
  return exit_code_of(summary);
}

void Checks::add(const std::filesystem::path& folder,
                 reports::Summary summary) {
  fmt::print("{}\n", summary.case_name);
  print_verdicts(summary);
  if (run::wants_quiet())
    run::emit_answer(lines_not_met(summary));
  const run::ExitCode exit_code = exit_code_of(summary);
  answer_.add(summary.case_name, folder, exit_code, &summary);
  end_ = worse(end_, exit_code);
  why_nothing_ = reports::why_nothing_checked(summary);
  if (why_nothing_.empty())
    has_checked_ = true;
  else
    fmt::print("{}\n", why_nothing_);
  summaries_.push_back(std::move(summary));
}

void Checks::add_problem(const std::string& case_name,
                         const std::string& problem, run::ExitCode exit_code) {
  reports::Summary summary;
  summary.case_name = case_name;
  reports::Verdict verdict;
  verdict.quantity = "run";
  verdict.estimate.remark = problem;
  answer_.add(case_name, "", exit_code, nullptr, problem);
  summary.verdicts.push_back(std::move(verdict));
  summaries_.push_back(std::move(summary));
  end_ = worse(end_, exit_code);
}

void Checks::end_target(const std::string& target, bool has_failed) {
  if (!has_checked_ && !has_failed) {
    fmt::print(stderr, "{}: {}\n", target, why_nothing_);
    end_ = worse(end_, run::exit_bad_input);
  }
  has_checked_ = false;
}

run::ExitCode Checks::end(const std::string& junit) const {
  if (!junit.empty()) {
    std::filesystem::create_directories(
        std::filesystem::absolute(junit).parent_path());
    write_file_atomically(junit, reports::junit_xml(summaries_));
  }
  answer_.print(end_);
  return end_;
}

} // namespace asperity::cli
