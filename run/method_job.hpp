#pragma once

// Runs one method on one realisation: reads cached steps, computes the others,
// and writes each step as soon as it is done.

#include "methods/cache/case_keys.hpp"
#include "methods/methods.hpp"
#include "methods/step_chain.hpp"
#include "methods/worker_pool.hpp"
#include "results/result_writer.hpp"
#include "run/flow_of_step.hpp"
#include "run/progress.hpp"
#include "run/tally.hpp"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::run {

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

} // namespace asperity::run
