#include "run/sweeps/sweep_run.hpp"

#include "base/atomic_file.hpp"
#include "base/available_memory.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "run/child_run.hpp"
#include "run/interrupt.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/worker_pool.hpp"
#include "run/plan/plan.hpp"
#include "run/progress.hpp"
#include "run/sweeps/memory_budget.hpp"
#include "run/sweeps/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <set>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class SweepRun {
public:
  SweepRun(const cases::CaseSweep& sweep, const SweepRunOptions& options,
           SweepPlan plan)
      : sweep_(sweep),
        options_(options),
        plan_(std::move(plan)),
        budget_(plan_.available_memory),
        outcome_{record_of(sweep)},
        chosen_(options.points) {
    for (std::size_t i = 0; options.points.empty() && i < sweep.points.size();
         ++i)
      chosen_.push_back(i);
  }

  SweepOutcome execute() {
    prepare();
    std::vector<methods::WorkerPool::Job> jobs;
    for (std::size_t place = 0; place < chosen_.size(); ++place)
      jobs.push_back([this, place] { run_point(place); });
    start_ = Clock::now();
    methods::WorkerPool(plan_.threads).run(jobs);
    outcome_.is_interrupted = is_interrupted();
    return std::move(outcome_);
  }

private:
  void prepare() {
    write_record(outcome_.record, options_.folder);
    options_.write_case();
    std::set<std::string> warnings;
    for (const Plan& point : plan_.points)
      warnings.insert(point.warnings.begin(), point.warnings.end());
    for (const std::string& warning : warnings)
      fmt::print(stderr, "warning: {}\n", warning);
  }

  void run_point(std::size_t place) {
    const std::size_t i = chosen_[place];
    if (is_interrupted()) {
      outcome_.record.points[i].problem = "has not run, because the sweep was "
                                          "interrupted";
      return;
    }
    const fs::path folder = options_.folder / reports::point_folder(i);
    fs::create_directories(folder);
    const cases::Case& contact_case = sweep_.points[i].contact_case;
    const EarlierRun earlier =
        options_.resume ? earlier_run(contact_case,
                                      methods::chosen_methods(contact_case,
                                                              options_.methods),
                                      folder)
                        : EarlierRun{};
    std::string& hash = outcome_.record.points[i].case_hash;
    if (earlier.state == RunState::complete &&
        (options_.points.empty() || earlier.case_hash == hash)) {
      hash = earlier.case_hash;
      finish(i, ChildEnd{0, "", 0.0, 0.0}, "is complete already");
      return;
    }
    const MemoryBudget::Share share(budget_, plan_.points[i].memory);
    const ChildEnd end =
        run_self(words_of(place, earlier.state), folder / "log.txt");
    finish(i, end, "");
  }

  /// The last points share the threads that would otherwise be idle.
  int threads_of(std::size_t place) const {
    const std::size_t left = chosen_.size() - place;
    const auto workers =
        std::min(left, static_cast<std::size_t>(plan_.beside()));
    return std::max(1, plan_.threads / static_cast<int>(workers));
  }

  std::vector<std::string> words_of(std::size_t place, RunState state) const {
    const std::size_t i = chosen_[place];
    std::vector<std::string> overrides = options_.overrides;
    const std::vector<std::string>& own = sweep_.points[i].overrides;
    overrides.insert(overrides.end(), own.begin(), own.end());
    std::vector<std::string> words =
        words_of_run(options_.case_file, overrides, options_.methods);
    words.insert(words.end(),
                 {"--out",
                  (options_.folder / reports::point_folder(i)).string(),
                  "--threads", std::to_string(threads_of(place))});
    if (!options_.has_reports)
      words.emplace_back("--no-report");
    if (!options_.uses_cache)
      words.emplace_back("--no-cache");
    if (state == RunState::to_resume)
      words.emplace_back("--resume");
    return words;
  }

  void finish(std::size_t i, const ChildEnd& end, const std::string& remark) {
    const std::lock_guard lock(mutex_);
    const auto code = static_cast<ExitCode>(
        end.exit_code < 0 || end.exit_code > exit_interrupted ? exit_internal
                                                              : end.exit_code);
    reports::PointRecord& point = outcome_.record.points[i];
    if (code == exit_interrupted)
      point.problem = "was interrupted";
    else if (code != exit_good && code != exit_not_converged)
      point.problem = fmt::format(
          "{}: {}", end.failure,
          end_of_log(options_.folder / reports::point_folder(i) / "log.txt"));
    outcome_.worst = std::max(outcome_.worst, code);
    ++n_done_;
    const std::string words =
        !point.problem.empty()       ? point.problem
        : code == exit_not_converged ? "some steps did not converge"
        : !remark.empty()            ? remark
                                     : fmt::format("{:.1f} s", end.wall_time);
    const std::string left = remaining_text(start_, n_done_, chosen_.size());
    fmt::print("{:>4}/{} point {:03}  {}  {}{}{}\n", n_done_, chosen_.size(), i,
               outcome_.record.label(i), words, left.empty() ? "" : "; ", left);
    std::fflush(stdout);
  }

  const cases::CaseSweep& sweep_;
  const SweepRunOptions& options_;
  SweepPlan plan_;
  MemoryBudget budget_;
  std::mutex mutex_; ///< for outcome_ and n_done_
  SweepOutcome outcome_;
  std::vector<std::size_t> chosen_; ///< points that are run
  std::size_t n_done_ = 0;
  Clock::time_point start_;
};

/// Leaves out the folder that all paths begin with, up to its last '/'.
void leave_out_common_folder(std::vector<std::string>& paths) {
  std::string common = paths.front();
  for (const std::string& path : paths)
    common.resize(static_cast<std::size_t>(
        std::ranges::mismatch(common, path).in1 - common.begin()));
  const std::size_t slash = common.rfind('/');
  if (slash == std::string::npos || common.front() != '"')
    return;
  for (std::string& path : paths)
    path.erase(1, slash); // after the quote
}

} // namespace

reports::SweepRecord record_of(const cases::CaseSweep& sweep) {
  reports::SweepRecord record{
      sweep.name, sweep.title, sweep.combine, sweep.keys, {}};
  for (cases::SweptKey& key : record.keys)
    if (key.key == "surface.file")
      leave_out_common_folder(key.values);
  for (const cases::SweptPoint& point : sweep.points)
    record.points.push_back(
        {point.choice, cases::case_hash(point.contact_case)});
  return record;
}

void write_record(const reports::SweepRecord& record, const fs::path& folder) {
  write_file_atomically(folder / reports::sweep_file,
                        text_of_json(reports::record_json(record), 2) + "\n");
}

SweepOutcome run_sweep(const cases::CaseSweep& sweep,
                       const SweepRunOptions& options) {
  RunOptions run{{}, options.methods, options.resume, options.threads};
  methods::Cache cache(methods::cache_folder(),
                       options.uses_cache ? methods::cache_size() : 0);
  run.cache = &cache;
  return SweepRun(sweep, options, make_sweep_plan(sweep, run)).execute();
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
