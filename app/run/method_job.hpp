#pragma once

// Runs one method on one realisation: reads cached steps, computes the others,
// and writes each step as soon as it is done.

#include "app/cache/case_keys.hpp"
#include "app/methods/methods.hpp"
#include "app/methods/step_chain.hpp"
#include "app/methods/worker_pool.hpp"
#include "app/run/progress.hpp"
#include "app/run/tally.hpp"
#include "results/result_writer.hpp"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::app {

/// The objects that the jobs of one run share.
struct RunContext {
  const cases::Case& contact_case;
  std::filesystem::path folder;
  Cache& cache;
  const CaseKeys& keys;
  const CaseSurfaces& surfaces;
  results::ResultWriter* writer; ///< null on other ranks than rank 0
  MethodFactory& solvers;
  Progress& progress;
  const WorkerPool& pool;
  std::set<std::size_t> field_steps; ///< steps whose fields are saved
  Tally& tally;
  RootWork& root;     ///< of the ranks that run the case
  int threads_a_rank; ///< for methods that they share
};

/// Words on an unfinished load step of a full block.
std::string words_on(const fem::BlockProgress& work);

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
  results::Change change_of(const StepAnswer& answer) const;
  void record(results::Change change);
  void keep_and_record(StepSolver& solver, StepAnswer& answer,
                       double setup_time);
  void describe_found(const std::string& found);
  void compute_theory(const std::vector<std::size_t>& steps);
  void compute_elastic(const std::vector<std::size_t>& steps);
  std::unique_ptr<StepSolver> set_up();
  std::string activity_text(const std::string& part) const;
  bool is_to_end();
  bool go_to(StepSolver& solver, std::size_t next, std::size_t step);
  bool compute_step(StepSolver& solver, std::size_t step, double setup_time);
  Resources resources() const;

  const RunContext& context_;
  const cases::MethodSpec& method_;
  int realization_;
  RootWork& root_;
  Cache no_cache_;
  StepChain chain_;
};

} // namespace asperity::app
