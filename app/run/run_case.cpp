#include "app/run/run_case.hpp"

#include "app/cache/case_keys.hpp"
#include "app/methods/chosen.hpp"
#include "app/methods/shared_load_steps.hpp"
#include "app/methods/shared_surface.hpp"
#include "app/plan/memory_check.hpp"
#include "app/plan/plan.hpp"
#include "app/plan/preparation.hpp"
#include "app/plan/skipped.hpp"
#include "app/run/interrupt.hpp"
#include "app/run/last_run.hpp"
#include "app/run/method_job.hpp"
#include "app/run/mpi_world.hpp"
#include "app/run/provenance_of_run.hpp"
#include "app/run/stress_tables.hpp"
#include "app/run/studies.hpp"
#include "cases/reader/case_hash.hpp"
#include "cases/reader/locking.hpp"
#include "input/input_error.hpp"
#include "md/engines.hpp"
#include "results/provenance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using cases::MethodSpec;

constexpr int rate_probe_points = 256;

/// Returns the inputs that the text of the case does not determine.
results::Inputs inputs_of(const cases::Case& contact_case) {
  results::Inputs inputs = input_hashes(contact_case);
  inputs["program"] = results::build_stamp();
  return inputs;
}

/// Prepares the output folder: puts the output of the last run aside, or leaves
/// it for a run that resumes it. Returns the folder.
const fs::path& prepared(const cases::Case& contact_case,
                         const RunOptions& options,
                         const std::vector<MethodSpec>& methods,
                         std::optional<LastRun>& last_run) {
  std::vector<std::string> folders;
  for (const MethodSpec& method : methods)
    for (const int r :
         realizations_of(contact_case, method, options.realizations))
      folders.push_back(files_of_method(method.name, r));
  if (!options.resume || !fs::exists(options.folder / "result.h5"))
    last_run.emplace(options.folder, folders);
  return options.folder;
}

/// One run of a case, from the surfaces to the completed result file.
class Run {
public:
  /// @param last_run  receives the output of the last run, unless it is resumed
  Run(const cases::Case& contact_case, const RunOptions& options,
      std::vector<MethodSpec> methods, std::optional<LastRun>& last_run)
      : case_(contact_case),
        methods_(std::move(methods)),
        only_(options.realizations),
        pool_(options.threads),
        builds_by_rows_(has_surfaces_by_rows(case_, methods_, n_mpi_ranks())),
        surfaces_(case_, methods_, only_, build_by_rows()),
        writer_(prepared(case_, options, methods_, last_run),
                {case_.name, case_.title, case_.text, cases::case_hash(case_),
                 case_.material.contact_modulus, options.reference,
                 inputs_of(case_)},
                options.resume ? results::ResultWriter::Mode::resume
                               : results::ResultWriter::Mode::create),
        cache_(options.cache != nullptr ? *options.cache : no_cache_),
        keys_(case_, program_identity()),
        solvers_(case_, cache_, keys_),
        progress_(work_to_do(options), case_.material.contact_modulus),
        context_{
            case_,   options.folder, cache_,    keys_, surfaces_,
            writer_, solvers_,       progress_, pool_, steps_with_fields(case_),
            tally_} {}

  RunOutcome execute();

private:
  std::vector<int> realizations(const MethodSpec& method) const {
    return realizations_of(case_, method, only_);
  }

  bool has_realization(int r) const {
    return only_.empty() || only_.contains(r);
  }

  int threads_a_rank() const {
    return std::max(1, pool_.threads() / n_ranks_on_machine());
  }

  BuildByRows build_by_rows() const;
  RemainingWork work_to_do(const RunOptions& options) const;
  int n_steps(const MethodSpec& method) const; ///< that remain to be done
  void record_surface(int realization);
  void record_own_surface(const MethodSpec& method, int realization);
  void begin();
  bool runs_alone(const MethodSpec& method, int realization);
  void run_jobs();
  std::vector<results::Skipped> skipped() const;

  const cases::Case& case_;
  std::vector<MethodSpec> methods_;
  std::set<int> only_; ///< realisations; empty: all
  WorkerPool pool_;
  bool builds_by_rows_; ///< no rank holds a whole surface
  CaseSurfaces surfaces_;
  results::ResultWriter writer_;
  Cache no_cache_;
  Cache& cache_;
  CaseKeys keys_;
  MethodFactory solvers_;
  Progress progress_;
  Tally tally_;
  RunContext context_;
};

int Run::n_steps(const MethodSpec& method) const {
  int steps = 0;
  for (const int r : realizations(method))
    for (std::size_t step = 0; step < case_.load.targets.size(); ++step)
      steps += writer_.has_step(method.name, r, static_cast<int>(step)) ? 0 : 1;
  return steps;
}

/// Returns the steps to do with their predicted times.
RemainingWork Run::work_to_do(const RunOptions& options) const {
  const Plan plan = make_plan(case_, options, rate_probe_points);
  std::map<std::string, MethodWork> work;
  for (const PlannedMethod& planned : plan.methods) {
    const int n_left = std::max(planned.steps - planned.kept_steps, 1);
    work[planned.name].step_time =
        (planned.setup_time + planned.step_time) / n_left;
  }
  for (const MethodSpec& method : methods_)
    work[method.name].steps = n_steps(method);
  const double ratio = plan.wall_time / plan.cpu_time;
  return {work, std::isfinite(ratio) && ratio > 0.0 ? ratio : 1.0};
}

/// Returns how ranks build a surface, or nothing if this process does.
BuildByRows Run::build_by_rows() const {
  if (!builds_by_rows_)
    return {};
  return [this](const SurfaceSource& source) {
    return surface_by_rows(source, case_.material.contact_modulus,
                           threads_a_rank());
  };
}

void Run::record_surface(int realization) {
  const SurfaceOfCase& surface =
      surfaces_.whole()[static_cast<std::size_t>(realization)];
  if (surface.source)
    writer_.record_surface(realization, surface.record,
                           heights_by_rows(*surface.source, threads_a_rank()));
  else
    writer_.record_surface(realization, surface.record);
}

void Run::record_own_surface(const MethodSpec& method, int realization) {
  const results::SurfaceRecord record =
      surfaces_.record_of(method, realization);
  if (builds_by_rows_ && method.needs_surface())
    writer_.record_own_surface(
        method.name, realization, record,
        heights_by_rows(*surfaces_.of(method, realization).source,
                        threads_a_rank()));
  else
    writer_.record_own_surface(method.name, realization, record);
}

void Run::begin() {
  for (const std::string& warning :
       cases::locking_warnings(case_.material, methods_))
    fmt::print(stderr, "warning: {}\n", warning);
  for (const std::string& warning :
       cases::interpolation_warnings(case_, methods_))
    fmt::print(stderr, "warning: {}\n", warning);
  const auto by_rows =
      std::ranges::find_if(surfaces_.whole(), [](const SurfaceOfCase& surface) {
        return surface.source.has_value();
      });
  if (by_rows != surfaces_.whole().end())
    fmt::print("{}\n", rows_sentence(*by_rows->source, n_mpi_ranks()));
  for (std::size_t i = 0; i < surfaces_.whole().size(); ++i)
    if (const int r = static_cast<int>(i); has_realization(r))
      record_surface(r);
  for (const MethodSpec& method : methods_) {
    const MethodDescription description = describe(method, case_.material);
    writer_.begin_method(method.name, description.kind, description.text);
    if (has_own_surface(case_, method))
      for (const int r : realizations(method))
        record_own_surface(method, r);
  }
}

/// Returns whether a job must run after the others, one at a time.
bool Run::runs_alone(const MethodSpec& method, int realization) {
  const int ranks = n_mpi_ranks();
  if (ranks == 1 || !method.has_fields())
    return describe(method, case_.material).runs_alone;
  const Grid& grid = surfaces_.of(method, realization).record.grid;
  if (!is_shared_by_ranks(method, grid, ranks)) {
    if (const std::string why = obstacle_to_sharing(method, grid, ranks);
        !why.empty())
      fmt::print("{}, realization {}: rank 0 solves it alone, because {}\n",
                 method.name, realization, why);
    return describe(method, case_.material).runs_alone;
  }
  fmt::print("{}, realization {}: {} ranks share the rows of the surface\n",
             method.name, realization, ranks);
  writer_.record_provenance(
      {{"ranks of " + method.name, std::to_string(ranks)}});
  return true;
}

void Run::run_jobs() {
  std::vector<WorkerPool::Job> jobs;
  std::vector<WorkerPool::Job> lone_jobs;
  for (const MethodSpec& method : methods_)
    for (const int r : realizations(method))
      (runs_alone(method, r) ? lone_jobs : jobs).push_back([this, &method, r] {
        MethodJob(context_, method, r).run();
      });
  if (const MethodSpec* studied = cases::study_theory(methods_);
      studied != nullptr && has_realization(0))
    jobs.push_back([this, studied] {
      const Progress::Activity studies(progress_, "tables of the studies");
      run_studies(context_, *studied);
    });
  pool_.run(jobs);
  for (const WorkerPool::Job& job : lone_jobs)
    pool_.run({&job, 1});
}

/// Lists the work that was skipped because the case does not need it or because
/// it is cached, and evaluations that failed. The machine is probed on a small
/// grid, which takes some hundredths of a second.
std::vector<results::Skipped> Run::skipped() const {
  MachineRates rates(rate_probe_points);
  const std::size_t first =
      only_.empty() ? 0U : static_cast<std::size_t>(*only_.begin());
  const Grid grid = surfaces_.whole().empty()
                        ? grid_of_case(case_, methods_)
                        : surfaces_.whole()[first].record.grid;
  std::vector<results::Skipped> list =
      skipped_by_case({case_, methods_, grid}, rates);
  for (const auto& [thing, work] : tally_.kept())
    list.push_back({work.steps == 0
                        ? thing
                        : fmt::format("{}: {} steps", thing, work.steps),
                    "in the cache", work.cpu_time, 0.0});
  for (const results::Skipped& failure : tally_.failures())
    list.push_back(failure);
  return list;
}

RunOutcome Run::execute() {
  RunClock clock;
  writer_.record_provenance(
      provenance_at_start(case_, pool_.threads(), surfaces_.map_facts()));
  begin();
  run_jobs();
  const bool was_interrupted = is_interrupted();
  if (!was_interrupted && !surfaces_.whole().empty() && has_realization(0)) {
    const Progress::Activity stress(progress_, "subsurface stress");
    record_stress_inside(case_, methods_, surfaces_.whole().front().scales,
                         {pool_.threads(), n_mpi_ranks(), threads_a_rank()},
                         writer_, tally_);
  }
  if (tally_.uses_fem)
    writer_.record_provenance(provenance_of_fem());
  writer_.record_provenance(
      {{"steps computed", std::to_string(tally_.computed_steps)},
       {"steps from the cache", std::to_string(tally_.kept_steps())},
       {"steps computed again for what follows them",
        std::to_string(tally_.repeated_steps)}});
  writer_.record_skipped(skipped());
  writer_.record_provenance(clock.facts(largest_peak_memory()));
  writer_.record_provenance(
      {{"writing CPU time", fmt::format("{:.4f} s", writer_.cpu_time())}});
  writer_.finish(was_interrupted ? "interrupted" : "complete");
  progress_.end();
  fmt::print("{} steps: {} computed, {} from the cache\n",
             tally_.computed_steps + tally_.kept_steps(),
             tally_.computed_steps.load(), tally_.kept_steps());
  for (const std::string& problem : cache_.problems())
    fmt::print(stderr, "{}\n", problem);
  return {was_interrupted, tally_.failed_steps, tally_.computed_steps,
          tally_.kept_steps()};
}

} // namespace

RunOutcome run_case(const cases::Case& contact_case,
                    const RunOptions& options) {
  std::vector<MethodSpec> methods =
      chosen_methods(contact_case, options.methods, options.is_exact);
  for (const MethodSpec& method : methods)
    if (const auto* md = std::get_if<mechanics::MdSettings>(&method.settings))
      md::require_engine(*md);
  require_computable(contact_case, methods,
                     grid_of_case(contact_case, methods));
  require_memory(contact_case, options);
  std::optional<LastRun> last_run;
  const auto put_back = [&] {
    if (last_run)
      last_run->put_back(options.cache != nullptr && options.cache->is_on());
  };
  try {
    const RunOutcome outcome =
        Run(contact_case, options, std::move(methods), last_run).execute();
    if (last_run)
      last_run->end();
    return outcome;
  } catch (const input::InputError&) { // after the result was closed
    put_back();
    throw;
  } catch (const std::domain_error&) {
    put_back();
    throw;
  } catch (...) {
    if (last_run)
      last_run->end();
    throw;
  }
}

} // namespace asperity::app
