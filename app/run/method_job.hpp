#pragma once

// Runs one method on one realisation: reads cached steps, computes the others,
// and writes each step as soon as it is done.

#include "app/cache/case_keys.hpp"
#include "app/methods/methods.hpp"
#include "app/methods/step_chain.hpp"
#include "app/methods/worker_pool.hpp"
#include "app/run/progress.hpp"
#include "results/result_writer.hpp"

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

namespace asperity::app {

/// The work that the cache saved for one method.
struct KeptWork {
  int steps = 0;
  double cpu_time = 0.0; ///< steps and set-up [s]
};

/// Counters that the jobs update while they run.
class Tally {
public:
  std::atomic<int> computed_steps = 0;
  std::atomic<int> failed_steps = 0;   ///< not converged
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

  mutable std::mutex mutex_;
  std::map<std::string, KeptWork> kept_;
  std::vector<results::Skipped> failures_;
};

/// The objects that the jobs of one run share.
struct RunContext {
  const cases::Case& contact_case;
  std::filesystem::path folder;
  Cache& cache;
  const CaseKeys& keys;
  const CaseSurfaces& surfaces;
  results::ResultWriter& writer;
  MethodFactory& solvers;
  Progress& progress;
  const WorkerPool& pool;
  std::set<std::size_t> field_steps; ///< steps whose fields are saved
  Tally& tally;
};

/// Words on an unfinished load step of a full block.
std::string words_on(const fem::BlockProgress& work);

class MethodJob {
public:
  /// All arguments must outlive the job.
  MethodJob(const RunContext& context, const cases::MethodSpec& method,
            int realization);

  /// Runs the job. It ends early when the run is interrupted.
  void run();

private:
  bool needs_maps(std::size_t step) const;
  bool needs_section(std::size_t step) const;
  std::vector<std::size_t> take_kept();
  void take(std::size_t step, CachedStep& kept,
            std::vector<results::CurvePoint>& rows);
  void record(results::CurvePoint& row, StepAnswer& answer, std::size_t step);
  void describe_found(const std::string& found);
  void compute_theory(const std::vector<std::size_t>& steps);
  void compute_elastic(const std::vector<std::size_t>& steps);
  std::unique_ptr<StepSolver> set_up();
  std::string activity_text(const std::string& part) const;
  bool go_to(StepSolver& solver, std::size_t next, std::size_t step);
  bool compute_step(StepSolver& solver, std::size_t step, double setup_time);
  Resources resources() const;

  const RunContext& context_;
  const cases::MethodSpec& method_;
  int realization_;
  Cache no_cache_;
  StepChain chain_;
};

} // namespace asperity::app
