#pragma once

// The solver of the load steps of an elastic method, in this process or on all
// ranks of mpirun.

#include "contact/solvers/load_sequence.hpp"
#include "run/methods/curve_row.hpp"

#include <memory>
#include <vector>

namespace asperity::methods {

/// What a loading path is made of besides the operator and the heights.
struct LoadStepsSetting {
  mechanics::ContactInterface interface;
  double gap_tolerance = 0.0; ///< [m] > 0
  int max_iterations = 0;
  int threads = 1;         ///< of each process
  double rms_height = 0.0; ///< unit of the residual [m]
  /// What the observables need; weights and rows are those of the operator.
  Observation observation = {};
  double saved_setup_time = 0.0; ///< see StepSolver
};

/// Solves the load steps on one surface, see contact::LoadSequence; on a
/// quarter of it if the heights equal their mirror images, as those of a
/// mirrored map do (contact/operators/mirrored_operator.hpp). If ranks share
/// the rows of the operator, the heights are those of this rank, and all calls
/// are collective, as are those that pass the maps of an answer and the state
/// to rank 0; a state is read on rank 0.
std::unique_ptr<StepSolver>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting);

} // namespace asperity::methods
