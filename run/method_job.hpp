#pragma once

// Runs one method on one realisation: reads cached steps, computes the others,
// and writes each step as soon as it is done.

#include "results/result_writer.hpp"
#include "results/types/result.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/methods.hpp"
#include "run/methods/step_chain.hpp"
#include "run/methods/worker_pool.hpp"
#include "run/progress.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity::run {

class Tally;

/// The objects that the jobs of one run share.
struct RunContext {
  const cases::Case& contact_case;
  std::filesystem::path folder;
  methods::Cache& cache;
  const methods::CaseKeys& keys;
  const methods::CaseSurfaces& surfaces;
  results::ResultWriter* writer; ///< null on other ranks than rank 0
  methods::MethodFactory& solvers;
  Progress& progress;
  const methods::WorkerPool& pool;
  std::set<std::size_t> field_steps; ///< steps whose fields are saved
  Tally& tally;
  RootWork& root;     ///< of the ranks that run the case
  int threads_a_rank; ///< for methods that they share
};

/// Words on an unfinished load step of a full block.
std::string progress_text(const fem::BlockProgress& work);

class MethodJob {
public:
  /// All arguments must outlive the job.
  /// @param root  of the ranks that solve the method: all of them run the job
  MethodJob(const RunContext& context, const cases::MethodSpec& method,
            int realization, RootWork& root);

  /// Runs the job. It ends early when the run is interrupted.
  void run();

private:
  bool needs_maps(std::size_t step) const;
  bool needs_section(std::size_t step) const;
  std::vector<std::size_t> take_kept();
  void take(std::size_t step, results::Change kept,
            std::vector<results::CurvePoint>& rows);
  bool has_less_precision(const results::Change& kept) const;
  results::Change change_of(const methods::StepAnswer& answer) const;
  void record(results::Change change);
  void keep_and_record(methods::StepSolver& solver, methods::StepAnswer& answer,
                       double setup_time);
  void study(methods::StepAnswer& answer);
  void describe_found(const std::string& found);
  void compute_theory(const std::vector<std::size_t>& steps);
  void compute_elastic(const std::vector<std::size_t>& steps);
  std::unique_ptr<methods::StepSolver> set_up();
  std::string activity_text(const std::string& part) const;
  bool is_to_end();
  bool go_to(methods::StepSolver& solver, std::size_t next, std::size_t step);
  bool compute_step(methods::StepSolver& solver, std::size_t step,
                    double setup_time);
  methods::Resources resources() const;

  const RunContext& context_;
  const cases::MethodSpec& method_;
  int realization_;
  RootWork& root_;
  methods::Cache no_cache_;
  methods::StepChain chain_;
};

/// The work that the cache saved for one method.
struct KeptWork {
  int steps = 0;
  double cpu_time = 0.0; ///< steps and set-up [s]
};

/// Counters that the jobs update while they run.
class Tally {
public:
  /// @param is_told  whether failures are printed
  explicit Tally(bool is_told = true) : is_told_(is_told) {}

  std::atomic<int> computed_steps = 0;
  std::atomic<int> failed_steps = 0; ///< not converged
  /// Computed again only for the state of the solver after them.
  std::atomic<int> repeated_steps = 0;
  std::atomic<bool> uses_fem = false;

  /// @param thing  name of a method or a table
  void add_kept(const std::string& thing, const KeptWork& work);
  std::map<std::string, KeptWork> kept() const;
  int kept_steps() const;

  /// Returns the result of `compute`, or nothing if it throws. The failed
  /// evaluation of a solved case does not end the run; it is listed with the
  /// skipped work.
  template <class Compute>
  auto attempt(const std::string& what, Compute compute)
      -> std::optional<decltype(compute())> {
    try {
      return compute();
    } catch (const std::exception& error) {
      add_failure(what, error.what());
      return std::nullopt;
    }
  }

  std::vector<results::Skipped> failures() const;

private:
  void add_failure(const std::string& what, const std::string& why);

  bool is_told_;
  mutable std::mutex mutex_;
  std::map<std::string, KeptWork> kept_;
  std::vector<results::Skipped> failures_;
};

} // namespace asperity::run
