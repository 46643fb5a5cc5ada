// `asperity check`: tests results against the expectations of their cases, for
// CI jobs.
#include "input/input_error.hpp"
#include "reports/analysis/verdict.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/case_run.hpp"
#include "run/cli/checks.hpp"
#include "run/cli/run_command.hpp"
#include "run/cli/sweep_commands.hpp"
#include "run/interrupt.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/output_folder.hpp"
#include "run/result_outputs.hpp"
#include "run/run_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Options of `asperity check`.
struct CheckCommand {
  std::vector<std::string> targets; ///< results (file or folder), or cases
  std::string junit;                ///< file for JUnit XML; empty: none
  RunCommand run; ///< of targets that are cases, without their names
};

/// Throws before anything runs if the JUnit file cannot be written there.
void require_junit_folder(const std::string& junit) {
  if (junit.empty())
    return;
  fs::path folder = fs::absolute(junit).parent_path();
  while (!fs::exists(folder) && folder.has_relative_path())
    folder = folder.parent_path(); // the rest will be created
  if (!fs::is_directory(folder))
    throw input::InputError("--junit " + junit + ": " + folder.string() +
                            " is no folder");
  if (fs::is_directory(junit))
    throw input::InputError("--junit " + junit +
                            ": is a folder, but must be a file");
  run::require_own_file("--junit", junit, reports::junit_root);
}

/// Throws if an option for cases was given and no target is a case.
void require_a_case(const RunCommand& command) {
  const std::vector<std::string> words = command.options.words();
  const std::string option = !command.methods.names.empty() ? "--methods"
                             : !words.empty()               ? words.front()
                             : !command.overrides.empty()   ? "--set"
                             : command.is_quick             ? "--quick"
                             : !command.out.empty()         ? "--out"
                                                            : "";
  if (!option.empty())
    throw input::InputError(option +
                            " applies to cases, which are run, but each target "
                            "is a result");
}

/// Checks one target after another.
class TargetChecker {
public:
  TargetChecker(const CheckCommand& command, Checks& checks)
      : command_(command),
        checks_(checks),
        cache_(methods::cache_folder(),
               command.run.uses_cache ? methods::cache_size() : 0) {}

  /// Reads the cases among the targets.
  void read() {
    std::vector<std::string> words;
    std::vector<run::NamedCases> read;
    for (const std::string& target : command_.targets)
      guard(target, [&] {
        if (run::is_result(target) && !fs::exists(target))
          throw input::InputError(target + ": there is no such file");
        if (!run::is_result(target) && !is_sweep_folder(target)) {
          read.push_back(run::read_named_cases_or_sweep(
              target, command_.run.overrides, command_.run.is_quick,
              command_.run.options));
          words.push_back(target);
        }
      });
    run::name_apart(read, words);
    for (std::size_t i = 0; i < words.size(); ++i)
      to_run_.emplace(words[i], std::move(read[i]));
    if (words.empty() && failed_.empty())
      require_a_case(command_.run);
  }

  void run() {
    for (const std::string& target : command_.targets) {
      target_ = target;
      if (run::is_interrupted()) {
        checks_.add_problem(target, "interrupted", run::exit_interrupted);
        return;
      }
      if (!failed_.contains(target))
        guard(target, [&] { check(target); });
      if (is_cut_short_)
        return;
      checks_.end_target(target, failed_.contains(target));
    }
  }

  /// Returns the target, or the case, that is being read or checked.
  const std::string& target() const { return target_; }

private:
  /// Works on a target. What makes it fail is printed and recorded, and the
  /// other targets are checked all the same.
  template <class Work>
  void guard(const std::string& target, const Work& work) {
    target_ = target;
    try {
      work();
    } catch (const std::exception& error) {
      const Failure failure = failure_of(error);
      fmt::print(stderr, "{}\n", failure.text);
      checks_.add_problem(target_, failure.text, failure.exit_code);
      failed_.insert(target);
    }
  }

  void check(const std::string& target) {
    const auto named = to_run_.find(target);
    if (named == to_run_.end() && is_sweep_folder(target)) {
      check_sweep_folder(target, checks_);
    } else if (named == to_run_.end()) {
      results::require_readable(target);
      checks_.add(target, run::summary_of(results::read_result(
                              target, results::MapsInFile::large)));
    } else {
      check_cases(named->second);
    }
  }

  void check_cases(const run::NamedCases& named) {
    const RunCommand& run = command_.run;
    const std::size_t n_targets = command_.targets.size();
    if (named.sweep) {
      check_named_sweep(*named.sweep, run,
                        folder_of(named.sweep->sweep.name, run.out, n_targets),
                        checks_);
      is_cut_short_ = run::is_interrupted();
    }
    for (const run::ReadCase& read : named.cases) {
      target_ = read.found.name;
      const fs::path folder = folder_of_part(named, read, run.out, n_targets);
      const run::OutputFolder lock(folder, "check " + read.found.name,
                                   run::run_outputs(read.contact_case),
                                   run::input_files(read.contact_case));
      const CaseEnd ended = run_into_folder(
          read.contact_case,
          {folder, run.methods, false, run.threads, read.reference, &cache_},
          {});
      if (ended.outcome.is_interrupted) {
        checks_.add_problem(read.found.name, "interrupted",
                            run::exit_interrupted);
        is_cut_short_ = true;
        return;
      }
      checks_.add(folder, *ended.summary);
    }
  }

  const CheckCommand& command_;
  Checks& checks_;
  methods::Cache cache_;
  std::map<std::string, run::NamedCases> to_run_;
  std::set<std::string> failed_;
  std::string target_;
  bool is_cut_short_ = false; ///< the run of a case was interrupted
};

/// Checks results against the expectations of their cases. All cases among the
/// targets are read before the first one is run. A target that cannot be read
/// or run is reported, and the others are checked. The JUnit file is written
/// however the command ends.
///
/// @throws input::InputError  the folder of the JUnit file does not exist, two
///                            cases have one folder, or an option for cases is
///                            given without a case
run::ExitCode check_targets(const CheckCommand& command) {
  require_junit_folder(command.junit);
  run::catch_interrupts();
  Checks checks;
  TargetChecker checker(command, checks);
  try {
    checker.read();
    checker.run();
  } catch (const std::exception& error) { // still report what was found
    checks.add_problem(checker.target(), error.what(),
                       failure_of(error).exit_code);
    checks.end(command.junit);
    throw;
  }
  return checks.end(command.junit);
}

} // namespace

void add_check(CommandLine& line) {
  auto [command, check] =
      line.add<CheckCommand>("check",
                             "Check results against the expectations of\n"
                             "their cases; exit 1 if one is not met.",
                             check_targets);
  command
      ->add_option("target", check.targets,
                   "results (files or folders), or cases, which are run\n"
                   "first")
      ->required();
  command->add_option("--junit", check.junit,
                      "write the outcome to this file as JUnit XML,\n"
                      "however the command ends");
  add_methods(command, check.run.methods.names);
  add_case_options(command, check.run.options);
  add_overrides(command, check.run.overrides);
  command->add_option("--out", check.run.out,
                      "output folder (default: out/<case>)");
  add_quick(command, check.run.is_quick);
  command->add_flag("!--no-cache", check.run.uses_cache,
                    "compute every step; do not read or write the cache");
  add_threads(command, check.run.threads);
  command->add_flag("--quiet", line.output.is_quiet,
                    "print only expectations that are not met, and\n"
                    "errors");
  add_json(command, line.output, "the summaries");
  line.on_cases.insert("check");
  add_example(command, "check polymer --junit check.xml");
}

} // namespace asperity::cli
