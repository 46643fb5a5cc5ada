#pragma once

// From a method's settings to something that answers load steps: half-space,
// condensed block or full block behind one face. Owns the operators that
// several runs share.

#include "app/cache/cache.hpp"
#include "app/cache/case_keys.hpp"
#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "fem/plugin.hpp"
#include "results/observables/area_estimate.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace asperity::app {

MethodDescription describe(const cases::HalfspaceSettings& settings);
MethodDescription describe(const cases::FemSettings& settings);

/// What finite elements with these settings add to the counted area.
results::AreaCoefficients area_coefficients(const cases::FemSettings& settings);

/// What a method makes of a block that is not uniform: its layers, or that it
/// does without them; empty for a uniform block.
std::string material_words(const cases::MethodSpec& method,
                           const cases::MaterialSpec& material);

/// Of half-space and condensed finite elements. Makes solvers; operators of
/// equal block and grid are set up once and shared. Safe to call from any
/// thread.
class SolverFactory {
public:
  /// @param cache  where operators are looked for and left; it and the keys
  ///               outlive the factory
  SolverFactory(const cases::MaterialSpec& material, Cache& cache,
                const CaseKeys& keys);

  /// @param threads  that set-up and transforms may use
  std::unique_ptr<StepSolver> make(const cases::MethodSpec& method,
                                   const SurfaceOfCase& surface, int threads);

private:
  /// An operator, and what its set-up would have cost had none been kept [s].
  struct Face {
    std::unique_ptr<contact::SurfaceOperator> elasticity;
    double saved_setup_time = 0.0;
  };

  Face shared_operator(const cases::MethodSpec& method,
                       const SurfaceOfCase& surface, int threads);
  Face build_operator(const cases::MethodSpec& method,
                      const SurfaceOfCase& surface, int threads);

  fem::BlockRequest request(const cases::FemSettings& settings,
                            const SurfaceOfCase& surface, int threads) const;

  cases::MaterialSpec material_;
  Cache& cache_;
  const CaseKeys& keys_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<contact::SurfaceOperator>> operators_;
};

} // namespace asperity::app
