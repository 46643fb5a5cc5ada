#pragma once

// The interface between an elastic method and the solver of its load steps,
// which runs in this process or on all ranks of mpirun.

#include "app/methods/curve_row.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <memory>
#include <vector>

namespace asperity::app {

/// A loading path on one surface, see contact::LoadSequence.
class LoadSteps {
public:
  virtual ~LoadSteps() = default;

  /// Solves and evaluates a step. If the target needs no maps, the fields may
  /// be left out.
  virtual StepAnswer solve(const StepTarget& target) = 0;

  /// The numbers of contact::LoadSequence::memory().
  virtual SavedState memory() const = 0;

  virtual void recall(const StateReader& memory) = 0;
};

/// What a loading path is made of besides the operator and the heights.
struct LoadStepsSetting {
  mechanics::ContactInterface interface;
  double gap_tolerance = 0.0; ///< [m] > 0
  int max_iterations = 0;
  int threads = 1;         ///< of each process
  double rms_height = 0.0; ///< unit of the residual [m]
  /// What the observables need; weights, rows and border are those of the
  /// operator.
  Observation observation = {};
};

/// Solves the load steps in this process, or, if ranks share the rows of the
/// operator, the share of this rank: heights, fields and memory then have its
/// rows, and all calls are collective.
std::unique_ptr<LoadSteps>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting);

} // namespace asperity::app
