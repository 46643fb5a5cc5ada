#include "suite/bench/runs/bench_runner.hpp"

#include "base/cpu_clock.hpp"
#include "base/ranks/convolution.hpp"
#include "results/result_reader.hpp"
#include "results/types/method_columns.hpp"
#include "run/child_run.hpp"
#include "run/exit_code.hpp"
#include "run/interrupt.hpp"
#include "suite/bench/analysis/bench_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::bench {
namespace {

namespace fs = std::filesystem;

constexpr double mebibyte = 1024.0 * 1024.0;

BenchTime time_of(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const std::size_t n = times.size();
  return {0.5 * (times[(n - 1) / 2] + times[n / 2]), times.front(),
          times.back()};
}

/// Returns the number at the beginning of a provenance entry of the run; 0 if
/// there is none.
double number_in(const results::Result& result, const std::string& name) {
  for (const auto& [key, fact] : result.provenance)
    if (key == name)
      return std::stod(fact);
  return 0.0;
}

BenchPhases phases_of(const results::Result& result,
                      const results::MethodRecord& method, double cpu_time) {
  BenchPhases phases;
  double step_time = 0.0;
  for (const results::Curve& curve : method.realizations) {
    phases.setup += curve.setup_cpu_time;
    for (const results::CurvePoint& row : curve.points) {
      step_time += row.cpu_time;
      // NaN counts as 0
      phases.transforms += std::fmax(row[columns::transform_time], 0.0);
      phases.observation += std::fmax(row[columns::observation_time], 0.0);
    }
  }
  // Its set-up time contains the time of all its rows.
  if (method.kind == "theory")
    phases.setup = std::max(phases.setup - step_time, 0.0);
  phases.solving =
      std::max(step_time - phases.transforms - phases.observation, 0.0);
  phases.writing = number_in(result, "writing CPU time");
  phases.rest =
      std::max(cpu_time - phases.setup - phases.steps() - phases.writing, 0.0);
  return phases;
}

} // namespace

struct BenchRunner::Once : BenchRun {
  ChildEnd end;
  double peak_memory = 0.0; ///< [B]
  Grid grid;
};

BenchRunner::BenchRunner(const cases::Case& contact_case,
                         BenchRunnerOptions options)
    : case_(contact_case),
      options_(std::move(options)),
      start_(std::chrono::steady_clock::now()) {
  fs::create_directories(options_.folder);
}

bool BenchRunner::is_spent() const {
  const std::chrono::duration<double> spent =
      std::chrono::steady_clock::now() - start_;
  return spent.count() > options_.budget;
}

BenchRunner::Once BenchRunner::run_once(const BenchPoint& point) {
  const fs::path folder = options_.folder / fmt::format("run-{}", ++n_runs_);
  const fs::path log = options_.folder / "last-run.log";
  std::vector<std::string> overrides = options_.common;
  overrides.insert(overrides.end(), point.overrides.begin(),
                   point.overrides.end());
  std::vector<std::string> words =
      run::words_of_run(options_.case_file, overrides, {{point.method}, true});
  words.insert(words.end(), {"--no-report", "--no-cache", "--threads", "1",
                             "--out", folder.string()});
  Once once;
  once.end = run::run_self(words, log);
  const bool has_result = once.end.exit_code == run::exit_good ||
                          once.end.exit_code == run::exit_not_converged;
  if (!has_result) {
    once.problem = fmt::format("ended with exit code {}: {}",
                               once.end.exit_code, run::end_of_log(log));
    fs::remove_all(folder);
    return once;
  }
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  const results::MethodRecord* method = result.method(point.method);
  if (method == nullptr || method->realizations.empty()) {
    fs::remove_all(folder);
    once.problem = "the result does not contain this method";
    return once;
  }
  for (const results::CurvePoint& row : method->rows()) {
    ++once.steps;
    once.failed_steps += row.status == results::StepStatus::not_converged;
    once.iterations += row.iterations;
    once.transforms += static_cast<int>(row[columns::transforms]);
    once.unknowns =
        std::fmax(once.unknowns, row[columns::unknowns]); // ignores NaN
  }
  once.peak_memory = mebibyte * number_in(result, "peak memory");
  once.phases = phases_of(result, *method, once.end.cpu_time);
  once.answer = answer_of(result, case_, point.method);
  fs::remove_all(folder); // no map is read any more
  if (!result.surfaces.empty())
    once.grid = result.surfaces.front().grid;
  if (std::isnan(once.unknowns) &&
      (method->kind == "fem" || method->kind == "halfspace"))
    once.unknowns = static_cast<double>(once.grid.size());
  return once;
}

double BenchRunner::transform_pair(const Grid& grid) {
  const auto [known, is_new] =
      transform_pairs_.try_emplace({grid.points_x, grid.points_y}, 0.0);
  if (!is_new)
    return known->second;
  Convolution<float> convolution(grid);
  const Convolution<float>::Symbol symbol =
      convolution.arranged([](int /*jx*/, std::span<double> of_jy) {
        std::ranges::fill(of_jy, 1.0);
      });
  std::vector<float> field(grid.size(), 1.0F);
  std::vector<double> times;
  constexpr int tries = 9; // the first is the warm-up
  for (int i = 0; i < tries; ++i) {
    const CpuClock clock;
    convolution.apply(field, symbol, field);
    times.push_back(clock.seconds());
  }
  known->second = time_of({times.begin() + 1, times.end()}).median;
  return known->second;
}

void BenchRunner::run(BenchPoint& point) {
  std::vector<Once> runs{run_once(point)};
  if (const std::string& problem = runs.front().problem; !problem.empty()) {
    point.problem = problem;
    return;
  }
  const bool is_once = point.is_reference || is_spent();
  for (int i = 0; i < options_.repeats && !is_once && !run::is_interrupted();
       ++i) {
    Once again = run_once(point);
    if (!again.problem.empty())
      break;
    point.is_repeatable = point.is_repeatable &&
                          have_same_bits(runs.front().answer, again.answer);
    runs.push_back(std::move(again));
  }
  point.has_warm_up = runs.size() > 1;
  const std::span<const Once> timed =
      std::span(runs).subspan(point.has_warm_up ? 1 : 0);
  std::vector<double> wall;
  std::vector<double> cpu;
  for (const Once& one : timed) {
    wall.push_back(one.end.wall_time);
    cpu.push_back(one.end.cpu_time);
    point.peak_memory = std::max(point.peak_memory, one.peak_memory);
  }
  point.repeats = static_cast<int>(timed.size());
  point.wall = time_of(wall);
  point.cpu = time_of(cpu);
  const Once& middle = *std::min_element(
      timed.begin(), timed.end(), [&](const Once& a, const Once& b) {
        return std::abs(a.end.cpu_time - point.cpu.median) <
               std::abs(b.end.cpu_time - point.cpu.median);
      });
  static_cast<BenchRun&>(point) = middle;
  if (middle.transforms > 0 && middle.grid.size() > 0)
    point.transform_pair = transform_pair(middle.grid);
}

} // namespace asperity::bench
