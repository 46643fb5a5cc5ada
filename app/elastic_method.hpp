#pragma once

// From a method's settings to something that answers load steps: half-space,
// condensed block or full block behind one face. Owns the operators that
// several runs share.

#include "app/surfaces_of_case.hpp"
#include "contact/load_sequence.hpp"
#include "fem/plugin.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace asperity::app {

/// One elastic method on one realisation.
class StepSolver {
public:
  virtual ~StepSolver() = default;
  virtual contact::ContactSolution solve(const contact::LoadTarget& target) = 0;

  /// 1/k [m/Pa] of a penalty that stays, 0 for a hard wall.
  virtual double local_compliance() const = 0;

  /// As contact::SurfaceOperator has them.
  virtual std::span<const double> nodal_weights() const = 0;
};

/// What a method is, in words for the report, and what corrects its area.
struct MethodDescription {
  std::string kind;              ///< theory | halfspace | fem
  std::string text;              ///< one line
  double area_coefficient = 0.0; ///< see results::corrected_area_fraction
  bool runs_alone = false;       ///< its library allows one run at a time
};

/// @throws cases::CaseError  settings that do not go together
MethodDescription describe(const cases::MethodSpec& method);

/// Makes solvers; operators of equal block and grid are set up once and
/// shared. Safe to call from any thread.
class SolverFactory {
public:
  explicit SolverFactory(const cases::MaterialSpec& material);

  /// @param threads  that set-up and transforms may use
  std::unique_ptr<StepSolver> make(const cases::MethodSpec& method,
                                   const SurfaceOfCase& surface, int threads);

private:
  std::unique_ptr<contact::SurfaceOperator>
  shared_operator(const cases::MethodSpec& method, const SurfaceOfCase& surface,
                  int threads);
  std::unique_ptr<contact::SurfaceOperator>
  build_operator(const cases::MethodSpec& method, const SurfaceOfCase& surface,
                 int threads) const;

  fem::BlockRequest request(const cases::FemSettings& settings,
                            const SurfaceOfCase& surface, int threads) const;

  cases::MaterialSpec material_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<contact::SurfaceOperator>> operators_;
};

} // namespace asperity::app
