#include "suite/bench/runs/bench.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "input/reader/read_case.hpp"
#include "results/provenance.hpp"
#include "run/arguments/case_library.hpp"
#include "run/interrupt.hpp"
#include "run/methods/chosen.hpp"
#include "run/output_folder.hpp"
#include "run/plan/preparation.hpp"
#include "run/plan/skipped.hpp"
#include "run/progress.hpp"
#include "run/result_outputs.hpp"
#include "suite/bench/analysis/bench_analysis.hpp"
#include "suite/bench/pages/bench_report.hpp"
#include "suite/bench/runs/bench_runner.hpp"
#include "suite/bench/runs/target_error.hpp"
#include "suite/bench/settings/bench_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace asperity::bench {
namespace {

namespace fs = std::filesystem;

struct Subject {
  fs::path file;
  std::vector<std::string> overrides; ///< from quick.set and from the user
  cases::Case contact_case;
};

Subject subject_of(const BenchCommand& command) {
  const run::FoundCases found = run::find_cases(command.contact_case);
  if (!found.collection.empty())
    throw input::InputError("bench: " + found.collection +
                            " is a collection; name one of its cases");
  Subject subject{found.cases.front().file, {}, {}};
  if (command.is_quick)
    subject.overrides = run::quick_overrides(subject.file);
  subject.overrides.insert(subject.overrides.end(), command.overrides.begin(),
                           command.overrides.end());
  subject.contact_case =
      cases::read_case(subject.file.string(), subject.overrides);
  return subject;
}

void print_point(std::size_t i, std::size_t n, const BenchPoint& point) {
  if (point.problem.empty())
    fmt::print("[{}/{}] {}, {}: {:.3g} s CPU ({:.3g} to {:.3g}, n = {}), {} "
               "iterations, {:.0f} MiB\n",
               i + 1, n, point.method, point.label, point.cpu.median,
               point.cpu.least, point.cpu.largest, point.repeats,
               point.iterations, point.peak_memory / 1048576.0);
  else
    fmt::print("[{}/{}] {}, {}: {}\n", i + 1, n, point.method, point.label,
               point.problem);
  std::fflush(stdout);
}

/// True for settings that occur only in series other than those over points.
bool is_optional(const BenchPlan& plan, std::size_t point) {
  return std::none_of(plan.series.begin(), plan.series.end(),
                      [&](const BenchSeries& series) {
                        return series.axis == "surface.points" &&
                               std::find(series.points.begin(),
                                         series.points.end(),
                                         point) != series.points.end();
                      }) &&
         !plan.points[point].is_own;
}

Bench bench_of(const Subject& subject, BenchPlan plan) {
  Bench bench;
  bench.case_name = subject.contact_case.name;
  bench.case_title = subject.contact_case.title;
  bench.case_hash = cases::case_hash(subject.contact_case);
  bench.case_text = subject.contact_case.text;
  bench.provenance = results::program_facts();
  bench.provenance.emplace_back("started", results::utc_now());
  bench.remarks = std::move(plan.remarks);
  bench.points = std::move(plan.points);
  bench.series = std::move(plan.series);
  bench.reference.series = plan.reference_series;
  return bench;
}

void run_points(Bench& bench, const BenchPlan& plan, BenchRunner& runner) {
  const auto begin = std::chrono::steady_clock::now();
  std::string left_out;
  bool is_once = false;
  for (std::size_t i = 0; i < bench.points.size(); ++i) {
    BenchPoint& point = bench.points[i];
    if (run::is_interrupted()) {
      point.problem = "interrupted before it was run";
      continue;
    }
    if (runner.is_spent() && is_optional(plan, i)) {
      point.problem = "skipped: the time budget was used up";
      left_out +=
          (left_out.empty() ? "" : ", ") + point.method + " " + point.label;
      continue;
    }
    is_once = is_once || (runner.is_spent() && !point.is_reference);
    runner.run(point);
    print_point(i, bench.points.size(), point);
    // As if the settings that remain took as long as the others.
    if (const std::string left =
            run::remaining_text(begin, i + 1, bench.points.size());
        !left.empty())
      fmt::print("{} of {} settings, {}\n", i + 1, bench.points.size(), left);
    std::fflush(stdout);
  }
  if (is_once)
    bench.remarks.emplace_back(
        "The time budget was used up before the end: settings with n = 1 were "
        "run once, without a warm-up run.");
  if (!left_out.empty())
    bench.remarks.push_back(
        "Skipped because the time budget was used up: " + left_out +
        ". Increase it with --budget; --quick limits it to "
        "60 s.");
}

void print_fronts(const Bench& bench) {
  for (const std::string& quantity : bench.quantities) {
    const auto& front = bench.fronts.at(quantity);
    for (const std::size_t i : front)
      fmt::print("{}: error {} in {:.3g} s of CPU time with {}, {}\n", quantity,
                 per_cent(bench.points[i].errors.at(quantity)),
                 bench.points[i].cpu.median, bench.points[i].method,
                 bench.points[i].label);
  }
}

} // namespace

double read_target_error(const std::string& text) {
  const auto [number, rest] = number_and_rest(text);
  const std::string unit = trimmed(rest);
  const double share = unit == "%" ? number / 100.0 : number;
  if ((!unit.empty() && unit != "%") || !(share > 0.0 && share < 1.0))
    throw input::InputError(
        "--target-error " + text +
        ": expected a relative error between 0 and 1, such as 1% or 0.01");
  return share;
}

run::ExitCode bench_case(const BenchCommand& command) {
  const double target = command.target_error.empty()
                            ? 0.0
                            : read_target_error(command.target_error);
  const Subject subject = subject_of(command);
  const cases::Case& contact_case = subject.contact_case;
  const std::vector<cases::MethodSpec> methods =
      methods::chosen_methods(contact_case, {command.methods});
  run::require_computable(contact_case, methods,
                          run::grid_of_case(contact_case, methods));
  const BenchPlan plan = bench_plan_of(
      contact_case, {command.methods, command.is_quick, command.realizations});
  const fs::path folder = command.out.empty()
                              ? fs::path("out") / contact_case.name / "bench"
                              : fs::path(command.out);
  const run::OutputFolder lock(
      folder, "bench " + contact_case.name,
      {"bench.json", "bench.csv", "report.html", "figures/", "runs/"},
      run::input_files(contact_case));
  run::catch_interrupts();
  std::vector<std::string> common = subject.overrides;
  common.insert(common.end(), plan.common.begin(), plan.common.end());
  BenchRunner runner(
      contact_case,
      {subject.file, common, folder / "runs",
       command.is_quick ? 1 : command.repeats,
       command.is_quick ? std::min(command.budget, 60.0) : command.budget});
  fmt::print("{}: {} settings, each run {} on one thread\n", contact_case.name,
             plan.points.size(), command.is_quick ? "twice" : "several times");
  Bench bench = bench_of(subject, plan);
  run_points(bench, plan, runner);
  analyse(bench, contact_case);
  if (target > 0.0 && !run::is_interrupted()) {
    cases::Case asked = contact_case;
    asked.methods = methods::chosen_methods(asked, {command.methods});
    TargetSearch search(asked, {subject.file, common, folder / "runs", 1, 1e9});
    bench.targets.push_back(search.run(target));
    print_outcome(bench.targets.back());
  }
  bench.provenance.emplace_back("finished", results::utc_now());
  print_fronts(bench);
  run::print_undrawn(write_bench_report(bench, folder));
  fmt::print("report: {}\n", (folder / "report.html").string());
  if (run::is_interrupted())
    return run::exit_interrupted;
  return std::ranges::any_of(
             bench.points,
             [](const BenchPoint& point) { return point.problem.empty(); })
             ? run::exit_good
             : run::exit_internal; // no setting has a result
}

} // namespace asperity::bench
