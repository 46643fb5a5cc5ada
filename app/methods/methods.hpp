#pragma once

// One door to every method that answers with maps. Owns which solver stands
// behind which settings.

#include "app/methods/atomic_method.hpp"
#include "app/methods/elastic_method.hpp"
#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"

#include <filesystem>
#include <memory>

namespace asperity::app {

MethodDescription describe(const cases::MethodSpec& method,
                           const cases::MaterialSpec& material);

/// What a solver may use of the machine.
struct Resources {
  int threads = 1;               ///< for set-up and steps
  std::filesystem::path scratch; ///< a folder of its own, made when needed
  md::Watch watch = {};          ///< called while a long step is at work
};

/// Safe to call from any thread.
class MethodFactory {
public:
  /// @param cache  where operators are looked for and left; all outlive it
  MethodFactory(const cases::Case& rough_case, Cache& cache,
                const CaseKeys& keys);

  /// Of any method but a theory. `surface` is the method's own, see
  /// CaseSurfaces::of, and must outlive the solver, as the case must.
  /// @throws cases::CaseError  settings that do not go together
  std::unique_ptr<StepSolver> make(const cases::MethodSpec& method,
                                   const SurfaceOfCase& surface,
                                   int realization, const Resources& resources);

private:
  const cases::Case& case_;
  SolverFactory elastic_;
};

} // namespace asperity::app
