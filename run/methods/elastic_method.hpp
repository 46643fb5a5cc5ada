#pragma once

// Creates solvers of load steps from the settings of a method: a half-space or
// a condensed block behind one contact surface. The factory owns the operators
// that several runs share.

#include "contact/operators/surface_operator.hpp"
#include "fem/plugin.hpp"
#include "results/observables/area_estimate.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace asperity::methods {

MethodDescription describe(const mechanics::HalfspaceSettings& settings);
MethodDescription describe(const mechanics::FemSettings& settings);

/// Returns the coefficients of the area correction for finite elements with
/// these settings.
results::AreaCoefficients
area_coefficients(const mechanics::FemSettings& settings);

/// Describes how a method treats a block that is not uniform: the layers that
/// it uses, or that it ignores them. The text is empty for a uniform block.
std::string material_text(const cases::MethodSpec& method,
                          const mechanics::MaterialSpec& material);

/// The threads and processes that a solver may use.
struct Workforce {
  int threads = 1; ///< for set-up and transforms in this process
  /// Of mpirun, for blocks that they can share; null: this process alone.
  RankGroup* ranks = nullptr;
  int threads_a_rank = 1; ///< for such a block
};

/// Creates solvers for half-space and condensed finite-element methods.
/// Operators for equal blocks and grids are set up once and shared. The class
/// is thread-safe.
class SolverFactory {
public:
  /// @param material  material of the case
  /// @param cache     cache of operators; must outlive the factory
  /// @param keys      cache keys; must outlive the factory
  SolverFactory(const mechanics::MaterialSpec& material, Cache& cache,
                const CaseKeys& keys);

  std::unique_ptr<StepSolver> make(const cases::MethodSpec& method,
                                   const SurfaceOfCase& surface,
                                   const Workforce& workforce);

  /// Returns the operator behind a half-space or condensed method.
  std::unique_ptr<contact::SurfaceOperator>
  operator_of(const cases::MethodSpec& method, const SurfaceOfCase& surface,
              int threads) {
    return shared_operator(method, surface, threads).elasticity;
  }

private:
  /// An operator, and the set-up time that the cache saved [s].
  struct Face {
    std::unique_ptr<contact::SurfaceOperator> elasticity;
    double saved_setup_time = 0.0;
  };

  Face shared_operator(const cases::MethodSpec& method,
                       const SurfaceOfCase& surface, int threads);
  Face build_operator(const cases::MethodSpec& method,
                      const SurfaceOfCase& surface, int threads);

  std::unique_ptr<contact::SurfaceOperator>
  operator_on_ranks(const cases::MethodSpec& method,
                    const SurfaceOfCase& surface,
                    const Workforce& workforce) const;

  fem::BlockRequest request(const mechanics::FemSettings& settings,
                            const SurfaceOfCase& surface, int threads) const;

  mechanics::MaterialSpec material_;
  Cache& cache_;
  const CaseKeys& keys_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<contact::SurfaceOperator>> operators_;
};

} // namespace asperity::methods
