#pragma once

// The common interface to all methods that produce fields. It selects the
// solver for the settings of a method.

#include "base/ranks/root_work.hpp"
#include "fem/plugin.hpp"
#include "run/methods/atomic_method.hpp"
#include "run/methods/elastic_method.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <filesystem>
#include <memory>

namespace asperity::methods {

MethodDescription describe(const cases::MethodSpec& method,
                           const mechanics::MaterialSpec& material);

/// The resources of the machine that a solver may use.
struct Resources {
  int threads = 1;                  ///< for set-up and steps
  std::filesystem::path scratch;    ///< private folder, created when needed
  md::Watch watch = {};             ///< called during long steps of atoms
  RootWork* root = nullptr;         ///< of the ranks that solve the method
  int threads_a_rank = 1;           ///< for a half-space that the ranks share
  fem::BlockWatch block_watch = {}; ///< called during steps of full blocks
};

/// Creates the solvers of all methods. The class is thread-safe.
class MethodFactory {
public:
  /// @param contact_case  the case; must outlive the factory
  /// @param cache       cache of operators; must outlive the factory
  /// @param keys        cache keys; must outlive the factory
  MethodFactory(const cases::Case& contact_case, Cache& cache,
                const CaseKeys& keys);

  /// The same without a cache.
  explicit MethodFactory(const cases::Case& contact_case);

  /// Creates the solver of any method except a theory.
  ///
  /// @param surface  the surface of the method, see CaseSurfaces::of(). It must
  ///                 outlive the solver, and so must the case.
  /// @throws input::InputError  settings contradict each other
  std::unique_ptr<StepSolver> make(const cases::MethodSpec& method,
                                   const SurfaceOfCase& surface,
                                   int realization, const Resources& resources);

  /// Returns the operator behind a half-space or condensed method.
  std::unique_ptr<contact::SurfaceOperator>
  operator_of(const cases::MethodSpec& method, const SurfaceOfCase& surface,
              int threads) {
    return elastic_.operator_of(method, surface, threads);
  }

private:
  struct NoCache;

  const cases::Case& case_;
  std::shared_ptr<NoCache> none_; ///< null: there is one
  SolverFactory elastic_;
};

} // namespace asperity::methods
