#include "app/run_case.hpp"

#include "app/cpu_clock.hpp"
#include "app/interrupt.hpp"
#include "app/methods.hpp"
#include "app/progress.hpp"
#include "app/provenance_of_run.hpp"
#include "app/studies.hpp"
#include "app/theory_method.hpp"
#include "app/worker_pool.hpp"
#include "cases/case_error.hpp"
#include "cases/case_hash.hpp"
#include "cases/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <set>

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using cases::MethodSpec;
using results::CurvePoint;

std::string kind_of(const std::string& method_name) {
  return method_name.substr(0, method_name.find('.'));
}

std::vector<MethodSpec> chosen_methods(const cases::Case& rough_case,
                                       const RunOptions& options) {
  const std::vector<std::string>& names = options.methods;
  std::set<std::string> known;
  for (const MethodSpec& method : rough_case.methods) {
    known.insert(method.name);
    known.insert(kind_of(method.name));
  }
  for (const std::string& name : names)
    if (!known.contains(name))
      throw cases::CaseError(
          "--methods " + name + ": " + rough_case.path +
          " has no such method; nearest: " +
          cases::nearest(name, {known.begin(), known.end()}));
  std::vector<MethodSpec> chosen;
  for (const MethodSpec& method : rough_case.methods)
    if (names.empty() ||
        std::find(names.begin(), names.end(), method.name) != names.end() ||
        (!options.is_exact && std::find(names.begin(), names.end(),
                                        kind_of(method.name)) != names.end()))
      chosen.push_back(method);
  return chosen;
}

/// Load steps, spread evenly over the program, whose maps are kept.
std::set<std::size_t> steps_with_fields(int n_fields, std::size_t n_steps) {
  std::set<std::size_t> steps;
  const std::size_t wanted =
      std::min(n_steps, static_cast<std::size_t>(std::max(n_fields, 0)));
  for (std::size_t k = 0; k < wanted; ++k)
    steps.insert((2 * k + 1) * n_steps / (2 * wanted));
  return steps;
}

StepTarget target_of(const cases::LoadProgram& load, std::size_t step,
                     const cases::Scales& scales) {
  return {load.control, load.targets[step].in_si(scales),
          static_cast<int>(step)};
}

/// A new run keeps the last result under another name, and leaves no table or
/// report of it that would seem to be the new one's.
/// @return the folder
const fs::path& put_last_run_aside(const fs::path& folder) {
  for (const char* name : {"curves.csv", "summary.json", "report.html"})
    fs::remove(folder / name);
  if (!fs::exists(folder / "result.h5"))
    return folder;
  fs::rename(folder / "result.h5", folder / "result.previous.h5");
  fmt::print("the last result is kept as {}\n",
             (folder / "result.previous.h5").string());
  return folder;
}

/// Everything the jobs of one run share.
class Run {
public:
  Run(const cases::Case& rough_case, const RunOptions& options,
      std::vector<MethodSpec> methods)
      : case_(rough_case),
        folder_(options.folder),
        methods_(std::move(methods)),
        pool_(options.threads),
        surfaces_(case_, methods_),
        writer_(options.resume ? options.folder
                               : put_last_run_aside(options.folder),
                {case_.name, case_.title, case_.text, cases::case_hash(case_),
                 case_.material.contact_modulus, options.reference},
                options.resume ? results::ResultWriter::Mode::resume
                               : results::ResultWriter::Mode::create),
        solvers_(case_),
        progress_(n_steps(), case_.material.contact_modulus),
        field_steps_(steps_with_fields(case_.report.fields,
                                       case_.load.targets.size())) {}

  RunOutcome execute();

private:
  int n_steps() const; ///< still to be done
  int n_realizations(const MethodSpec& method) const;
  void begin();
  void run_theory(const MethodSpec& method, int realization);
  void run_elastic(const MethodSpec& method, int realization);
  Resources resources_of(const MethodSpec& method, int realization);
  void run_step(StepSolver& solver, const MethodSpec& method, int realization,
                std::size_t step);

  const cases::Case& case_;
  fs::path folder_;
  std::vector<MethodSpec> methods_;
  WorkerPool pool_;
  CaseSurfaces surfaces_;
  results::ResultWriter writer_;
  MethodFactory solvers_;
  Progress progress_;
  std::set<std::size_t> field_steps_;
  std::atomic<int> failed_steps_ = 0;
};

int Run::n_realizations(const MethodSpec& method) const {
  const auto* theory = std::get_if<cases::TheorySettings>(&method.settings);
  const bool by_formula =
      theory != nullptr && theory->spectrum == cases::TheorySpectrum::formula;
  return by_formula ? 1 : case_.surface.realizations;
}

int Run::n_steps() const {
  int steps = 0;
  for (const MethodSpec& method : methods_)
    for (int r = 0; r < n_realizations(method); ++r)
      for (std::size_t step = 0; step < case_.load.targets.size(); ++step)
        steps +=
            writer_.has_step(method.name, r, static_cast<int>(step)) ? 0 : 1;
  return steps;
}

void Run::begin() {
  for (std::size_t r = 0; r < surfaces_.whole().size(); ++r)
    writer_.record_surface(static_cast<int>(r), surfaces_.whole()[r].record);
  for (const MethodSpec& method : methods_) {
    const MethodDescription description = describe(method);
    writer_.begin_method(method.name, description.kind, description.text);
    if (method.magnification)
      for (int r = 0; r < n_realizations(method); ++r)
        writer_.record_own_surface(method.name, r,
                                   surfaces_.record_of(method, r));
  }
}

RunOutcome Run::execute() {
  RunClock clock;
  writer_.record_provenance(
      provenance_at_start(case_, pool_.threads(), methods_));
  begin();
  std::vector<WorkerPool::Job> jobs;
  std::vector<WorkerPool::Job> lone_jobs;
  for (const MethodSpec& method : methods_)
    for (int r = 0; r < n_realizations(method); ++r) {
      if (std::holds_alternative<cases::TheorySettings>(method.settings))
        jobs.push_back([this, &method, r] { run_theory(method, r); });
      else
        (describe(method).runs_alone ? lone_jobs : jobs)
            .push_back([this, &method, r] { run_elastic(method, r); });
    }
  if (const MethodSpec* studied = cases::study_theory(methods_))
    jobs.push_back([this, studied] { run_studies(case_, *studied, writer_); });
  pool_.run(jobs);
  for (const WorkerPool::Job& job : lone_jobs)
    pool_.run({&job, 1});
  const bool was_interrupted = is_interrupted();
  writer_.record_provenance(clock.facts());
  writer_.record_provenance(
      {{"writing CPU time", fmt::format("{:.4f} s", writer_.cpu_time())}});
  writer_.finish(was_interrupted ? "interrupted" : "complete");
  return {was_interrupted, failed_steps_};
}

void Run::run_theory(const MethodSpec& method, int realization) {
  const auto& settings = std::get<cases::TheorySettings>(method.settings);
  const bool by_formula = settings.spectrum == cases::TheorySpectrum::formula;
  const CpuClock clock;
  const theory::HeightSpectrum spectrum =
      by_formula ? formula_of_case(case_, method)
                 : spectrum_of(surfaces_.of(method, realization));
  const cases::Scales scales = by_formula
                                   ? formula_scales(case_, spectrum)
                                   : surfaces_.of(method, realization).scales;
  std::vector<CurvePoint> rows =
      theory_rows(settings, case_.load, spectrum, scales);
  std::erase_if(rows, [&](const CurvePoint& row) {
    return writer_.has_step(method.name, realization, row.step);
  });
  if (rows.empty())
    return;
  writer_.record_setup_time(method.name, realization, clock.seconds());
  writer_.append_steps(method.name, realization, rows);
  for (const CurvePoint& row : rows) {
    failed_steps_ += row.status == results::StepStatus::not_converged;
    progress_.step_done(method.name, realization, row, scales.rms_height);
  }
}

void Run::run_elastic(const MethodSpec& method, int realization) {
  const std::size_t n_targets = case_.load.targets.size();
  const auto is_done = [&](std::size_t step) {
    return writer_.has_step(method.name, realization, static_cast<int>(step));
  };
  std::size_t first = 0;
  while (first < n_targets && is_done(first))
    ++first;
  if (first == n_targets || is_interrupted())
    return;

  const CpuClock clock(pool_.threads_a_job());
  const std::unique_ptr<StepSolver> solver =
      solvers_.make(method, surfaces_.of(method, realization), realization,
                    resources_of(method, realization));
  writer_.record_setup_time(method.name, realization, clock.seconds());
  if (const std::string found = solver->found_at_setup(); !found.empty())
    writer_.begin_method(method.name, describe(method).kind,
                         describe(method).text + "; " + found);
  for (std::size_t step = first; step < n_targets && !is_interrupted(); ++step)
    if (!is_done(step))
      run_step(*solver, method, realization, step);
}

Resources Run::resources_of(const MethodSpec& method, int realization) {
  return {pool_.threads_a_job(),
          folder_ / fmt::format("{}-{}", method.name, realization),
          [this, &method, realization](const md::Progress& work) {
            progress_.at_work(method.name, realization, work.evaluations,
                              work.energy, work.residual);
            return !is_interrupted();
          }};
}

void Run::run_step(StepSolver& solver, const MethodSpec& method,
                   int realization, std::size_t step) {
  const SurfaceOfCase& surface = surfaces_.of(method, realization);
  const CpuClock clock(pool_.threads_a_job());
  StepAnswer answer = solver.solve(target_of(case_.load, step, surface.scales));
  CurvePoint& row = answer.row;
  const bool has_failed = row.status == results::StepStatus::not_converged;
  if (has_failed && is_interrupted())
    return; // broken off in the middle: the step is still to be done
  row.step = static_cast<int>(step);
  row.is_unloading = case_.load.is_unloading[step];
  row.cpu_time = clock.seconds();
  failed_steps_ += has_failed ? 1 : 0;
  if (realization == 0 && field_steps_.contains(step))
    writer_.append_step_with_fields(method.name, realization, row, answer.grid,
                                    {row.step, row.nominal_pressure,
                                     std::move(answer.pressure),
                                     std::move(answer.gap)});
  else
    writer_.append_step(method.name, realization, row);
  progress_.step_done(method.name, realization, row, surface.scales.rms_height);
}

} // namespace

RunOutcome run_case(const cases::Case& rough_case, const RunOptions& options) {
  std::vector<MethodSpec> methods = chosen_methods(rough_case, options);
  for (const MethodSpec& method : methods)
    if (const auto* md = std::get_if<cases::MdSettings>(&method.settings))
      md::require_engine(*md);
  return Run(rough_case, options, std::move(methods)).execute();
}

} // namespace asperity::app
