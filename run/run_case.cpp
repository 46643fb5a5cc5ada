#include "run/run_case.hpp"

#include "base/json.hpp"
#include "base/peak_memory.hpp"
#include "base/ranks/rank_sums.hpp"
#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "input/reader/locking.hpp"
#include "input/reader/read_case.hpp"
#include "input/types/omissions.hpp"
#include "md/engines.hpp"
#include "results/provenance.hpp"
#include "run/interrupt.hpp"
#include "run/method_job.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/sharing.hpp"
#include "run/mpi_world.hpp"
#include "run/plan/plan.hpp"
#include "run/plan/preparation.hpp"
#include "run/plan/skipped.hpp"
#include "run/provenance_of_run.hpp"
#include "run/stress_tables.hpp"
#include "run/studies.hpp"
#include "surfaces/maps/edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;
using cases::MethodSpec;

/// Returns the inputs that the text of the case does not determine.
results::Inputs inputs_of(const cases::Case& contact_case) {
  results::Inputs inputs = methods::input_hashes(contact_case);
  inputs["program"] = results::build_stamp();
  return inputs;
}

/// One run of a case, from the surfaces to the completed result file.
class Run {
public:
  /// @param root  of the ranks that run the case together, which take part in
  ///              the methods that they share
  Run(const cases::Case& contact_case, const RunOptions& options,
      std::vector<MethodSpec> methods, RootWork& root)
      : case_(contact_case),
        methods_(std::move(methods)),
        only_(options.realizations),
        pool_(options.threads),
        root_(root),
        surfaces_(
            case_, methods_, only_,
            methods::surfaces_of_rank_0(root_, case_.material.contact_modulus)),
        writer_(open_result(options)),
        cache_(options.cache != nullptr ? *options.cache : no_cache_),
        keys_(root.is_root()
                  ? methods::CaseKeys(case_, methods::program_identity())
                  : methods::CaseKeys(case_, "", {})),
        solvers_(case_, cache_, keys_),
        progress_(work_to_do(), case_.material.contact_modulus),
        tally_(root.is_root()),
        context_{case_,           options.folder,
                 cache_,          keys_,
                 surfaces_,       writer_.get(),
                 solvers_,        progress_,
                 pool_,           methods::steps_with_fields(case_),
                 tally_,          root_,
                 threads_a_rank()} {}

  RunOutcome execute();

private:
  std::vector<int> realizations(const MethodSpec& method) const {
    return methods::realizations_of(case_, method, only_);
  }

  bool has_realization(int r) const {
    return only_.empty() || only_.contains(r);
  }

  int threads_a_rank() const {
    return std::max(1, pool_.threads() / n_ranks_on_machine());
  }

  std::unique_ptr<results::ResultWriter> open_result(const RunOptions& options);
  RemainingWork work_to_do();
  int n_steps(const MethodSpec& method) const; ///< that remain to be done
  void record_surface(int realization);
  void record_own_surface(const MethodSpec& method, int realization);
  void warn() const;
  void begin();
  bool is_shared(const MethodSpec& method, int realization) const;
  void tell_who_solves(const MethodSpec& method, int realization);
  void run_jobs();
  methods::WorkerPool::Job job_of_rank_0(const MethodSpec& method,
                                         int realization);
  std::vector<results::Skipped> skipped() const;
  void record_counts();
  void finish(const RunClock& clock, double peak, bool was_interrupted);

  const cases::Case& case_;
  std::vector<MethodSpec> methods_;
  std::set<int> only_; ///< realisations; empty: all
  methods::WorkerPool pool_;
  RootWork& root_;
  methods::CaseSurfaces surfaces_;
  std::unique_ptr<results::ResultWriter> writer_; ///< on rank 0
  RootWork alone_; ///< for methods that rank 0 solves
  methods::Cache no_cache_;
  methods::Cache& cache_;
  methods::CaseKeys keys_;
  methods::MethodFactory solvers_;
  Progress progress_;
  Tally tally_;
  RunContext context_;
};

/// Opens the result on rank 0.
std::unique_ptr<results::ResultWriter>
Run::open_result(const RunOptions& options) {
  std::unique_ptr<results::ResultWriter> writer;
  root_.act([&] {
    writer = std::make_unique<results::ResultWriter>(
        options.folder,
        results::CaseInfo{case_.name, case_.title, case_.text,
                          cases::case_hash(case_),
                          case_.material.contact_modulus, options.reference,
                          inputs_of(case_)},
        options.resume ? results::ResultWriter::Mode::resume
                       : results::ResultWriter::Mode::create);
  });
  return writer;
}

int Run::n_steps(const MethodSpec& method) const {
  int steps = 0;
  for (const int r : realizations(method))
    for (std::size_t step = 0; step < case_.load.targets.size(); ++step)
      steps +=
          writer_->has_step(method.name, r, static_cast<int>(step)) ? 0 : 1;
  return steps;
}

/// Returns the steps to do, on rank 0.
RemainingWork Run::work_to_do() {
  std::map<std::string, int> steps;
  root_.act([&] {
    for (const MethodSpec& method : methods_)
      steps[method.name] = n_steps(method);
  });
  return RemainingWork(steps);
}

void Run::record_surface(int realization) {
  const methods::SurfaceOfCase& surface =
      surfaces_.whole()[static_cast<std::size_t>(realization)];
  root_.act([&] { writer_->record_surface(realization, surface.record); });
}

void Run::record_own_surface(const MethodSpec& method, int realization) {
  root_.act([&] {
    writer_->record_own_surface(method.name, realization,
                                surfaces_.record_of(method, realization));
  });
}

void Run::warn() const {
  for (const std::string& warning : cases::warnings_about(case_, methods_))
    fmt::print(stderr, "warning: {}\n", warning);
  for (const MethodSpec& method : methods_)
    for (const cases::Omission& one : cases::omissions(case_, method))
      fmt::print("{}: {}\n", method.name, one.sentence());
  if (const auto found = surfaces_.map_facts())
    for (const std::string& warning : surfaces::warnings_of(found->faults))
      fmt::print(stderr, "warning: {}: {}\n", case_.name, warning);
}

void Run::begin() {
  root_.act([&] {
    writer_->record_provenance(
        provenance_at_start(case_, pool_.threads(), surfaces_.map_facts()));
    warn();
  });
  for (std::size_t i = 0; i < surfaces_.whole().size(); ++i)
    if (const int r = static_cast<int>(i); has_realization(r))
      record_surface(r);
  for (const MethodSpec& method : methods_) {
    root_.act([&] {
      const methods::MethodDescription description =
          methods::describe(method, case_.material);
      writer_->begin_method(method.name, description.kind, description.text,
                            name_of(method.contact_criterion(0.0).field));
    });
    if (surfaces_.has_own(method))
      for (const int r : realizations(method))
        record_own_surface(method, r);
  }
}

/// Returns whether all ranks solve a method together.
bool Run::is_shared(const MethodSpec& method, int realization) const {
  if (root_.ranks() == nullptr || !method.has_fields())
    return false;
  return methods::is_full_block(method) ||
         methods::is_shared_by_ranks(
             method, surfaces_.of(method, realization).record.grid,
             root_.ranks()->size());
}

/// On rank 0.
void Run::tell_who_solves(const MethodSpec& method, int realization) {
  const int ranks = n_mpi_ranks();
  if (ranks == 1 || !method.has_fields() || methods::is_full_block(method))
    return;
  if (is_shared(method, realization)) {
    fmt::print("{}, realization {}: {} ranks share the rows of the surface\n",
               method.name, realization, ranks);
    writer_->record_provenance(
        {{"ranks of " + method.name, std::to_string(ranks)}});
    return;
  }
  const std::string why = methods::obstacle_to_sharing(
      method, surfaces_.of(method, realization).record.grid, ranks);
  if (!why.empty())
    fmt::print("{}, realization {}: rank 0 solves it alone, because {}\n",
               method.name, realization, why);
}

/// Runs the jobs of rank 0 beside each other, then those that must run alone.
void Run::run_jobs() {
  std::vector<methods::WorkerPool::Job> jobs;
  std::vector<methods::WorkerPool::Job> lone_jobs;
  for (const MethodSpec& method : methods_)
    for (const int r : realizations(method)) {
      root_.act([&] { tell_who_solves(method, r); });
      if (is_shared(method, r))
        lone_jobs.push_back([this, &method, r] {
          const methods::WorkerPool::Job job = [&] {
            MethodJob(context_, method, r, root_).run();
          };
          pool_.run({&job, 1});
        });
      else if (methods::describe(method, case_.material).runs_alone)
        lone_jobs.push_back([this, job = job_of_rank_0(method, r)] {
          root_.act([&] { pool_.run({&job, 1}); });
        });
      else
        jobs.push_back(job_of_rank_0(method, r));
    }
  if (const MethodSpec* studied = cases::study_theory(case_.surface, methods_);
      studied != nullptr && has_realization(0))
    jobs.push_back([this, studied] {
      const Progress::Activity studies(progress_, "tables of the studies");
      run_studies(context_, *studied);
    });
  root_.act([&] { pool_.run(jobs); });
  for (const methods::WorkerPool::Job& job : lone_jobs)
    job();
}

methods::WorkerPool::Job Run::job_of_rank_0(const MethodSpec& method,
                                            int realization) {
  return [this, &method, realization] {
    MethodJob(context_, method, realization, alone_).run();
  };
}

/// Lists the work that was skipped because the case does not need it or because
/// it is cached, and evaluations that failed.
std::vector<results::Skipped> Run::skipped() const {
  const std::size_t first =
      only_.empty() ? 0U : static_cast<std::size_t>(*only_.begin());
  Grid grid = surfaces_.whole().empty() ? grid_of_case(case_, methods_)
                                        : surfaces_.whole()[first].record.grid;
  if (!methods::presses_images(case_, methods_))
    grid = surfaces::grid_with_edges(grid, case_.surface.edges);
  std::vector<results::Skipped> list = skipped_by_case({case_, methods_, grid});
  for (const auto& [thing, work] : tally_.kept())
    list.push_back({work.steps == 0
                        ? thing
                        : fmt::format("{}: {} steps", thing, work.steps),
                    fmt::format("in the cache; took {} of CPU time",
                                time_text(work.cpu_time))});
  for (const results::Skipped& failure : tally_.failures())
    list.push_back(failure);
  return list;
}

void Run::record_counts() {
  if (tally_.uses_fem)
    writer_->record_provenance(provenance_of_fem());
  writer_->record_provenance(
      {{"steps computed", std::to_string(tally_.computed_steps)},
       {"steps from the cache", std::to_string(tally_.kept_steps())},
       {"steps computed again for what follows them",
        std::to_string(tally_.repeated_steps)}});
  writer_->record_skipped(skipped());
}

/// @param peak  of the memory of a rank [B]
void Run::finish(const RunClock& clock, double peak, bool was_interrupted) {
  writer_->record_provenance(clock.facts(peak));
  writer_->record_provenance(
      {{"writing CPU time", fmt::format("{:.4f} s", writer_->cpu_time())}});
  writer_->finish(was_interrupted ? "interrupted" : "complete");
  progress_.end();
  fmt::print("{} steps: {} computed, {} from the cache\n",
             tally_.computed_steps + tally_.kept_steps(),
             tally_.computed_steps.load(), tally_.kept_steps());
  for (const std::string& problem : cache_.problems())
    fmt::print(stderr, "{}\n", problem);
}

RunOutcome Run::execute() {
  RunClock clock;
  begin();
  run_jobs();
  const bool was_interrupted = root_.value(is_interrupted);
  if (!was_interrupted && !surfaces_.whole().empty() && has_realization(0)) {
    const Progress::Activity stress(progress_, "subsurface stress");
    root_.act([&] {
      record_stress_inside(context_, methods_,
                           surfaces_.whole().front().scales);
    });
  }
  if (!was_interrupted && has_realization(0))
    record_map_tables(context_, methods_);
  root_.act([&] { record_counts(); });
  const double peak = rank_max(root_.ranks(), peak_memory());
  root_.act([&] { finish(clock, peak, was_interrupted); });
  return {was_interrupted, tally_.failed_steps, tally_.computed_steps,
          tally_.kept_steps()};
}

/// How the other ranks are told of a run.
std::string text_of(const cases::Case& contact_case, const RunOptions& options,
                    const std::vector<MethodSpec>& methods) {
  std::vector<std::string> names;
  names.reserve(methods.size());
  for (const MethodSpec& method : methods)
    names.push_back(method.name);
  return text_of_json(
      nlohmann::ordered_json{
          {"case", contact_case.text},
          {"path", contact_case.path},
          {"folder", options.folder.string()},
          {"methods", names},
          {"threads", methods::WorkerPool(options.threads).threads()},
          {"realizations", options.realizations}},
      -1);
}

/// Runs the case on all ranks if they share one of its methods.
RunOutcome run_together(const cases::Case& contact_case,
                        const RunOptions& options,
                        const std::vector<MethodSpec>& methods,
                        const Grid& grid) {
  if (!methods::is_run_by_ranks(contact_case, methods, grid, n_mpi_ranks())) {
    RootWork alone;
    return Run(contact_case, options, methods, alone).execute();
  }
  RunOutcome outcome;
  const fem::FemModule& fem_module = fem::load_fem_module();
  fem_module.on_all_ranks(text_of(contact_case, options, methods), [&] {
    RootWork root(&fem_module.rank_group());
    outcome = Run(contact_case, options, methods, root).execute();
  });
  return outcome;
}

} // namespace

Grid require_runnable(const cases::Case& contact_case,
                      const std::vector<MethodSpec>& methods) {
  for (const MethodSpec& method : methods)
    if (const auto* md = std::get_if<mechanics::MdSettings>(&method.settings))
      md::require_engine(*md);
  const Grid grid = grid_of_case(contact_case, methods);
  require_computable(contact_case, methods, grid);
  return grid;
}

RunOutcome run_case(const cases::Case& contact_case,
                    const RunOptions& options) {
  const std::vector<MethodSpec> methods =
      methods::chosen_methods(contact_case, options.methods);
  const Grid grid = require_runnable(contact_case, methods);
  require_memory(contact_case, options);
  return run_together(contact_case, options, methods, grid);
}

void follow_run(const std::string& text) {
  const nlohmann::ordered_json run = json_of_text(text);
  const cases::Case contact_case =
      cases::read_case_text(run.at("case"), run.at("path"));
  RunOptions options{run.at("folder").get<std::string>(),
                     {run.at("methods"), true},
                     false,
                     run.at("threads")};
  options.realizations = run.at("realizations").get<std::set<int>>();
  RootWork root(&fem::load_fem_module().rank_group());
  Run(contact_case, options,
      methods::chosen_methods(contact_case, options.methods), root)
      .execute();
}

} // namespace asperity::run
