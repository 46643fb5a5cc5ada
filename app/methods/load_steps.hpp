#pragma once

// The interface between an elastic method and the solver of its load steps,
// which runs in this process or on all ranks of mpirun.

#include "contact/solvers/load_sequence.hpp"

#include <memory>
#include <span>
#include <vector>

namespace asperity::app {

/// A loading path on one surface, see contact::LoadSequence. All fields have
/// all nodes of the grid.
class LoadSteps {
public:
  virtual ~LoadSteps() = default;
  virtual contact::ContactSolution
  solve(const mechanics::LoadTarget& target) = 0;

  /// Returns the CPU time of this process in the operator during the last
  /// solve() [s].
  virtual double transform_time() const = 0;

  virtual std::vector<double> memory() const = 0;
  virtual void recall(std::span<const double> memory) = 0;

  /// The operator, of which displacement() can be called between two steps.
  virtual contact::SurfaceOperator& elasticity() = 0;
};

/// What a loading path is made of besides the operator and the heights.
struct LoadStepsSetting {
  mechanics::ContactInterface interface;
  double gap_tolerance = 0.0; ///< [m] > 0
  int max_iterations = 0;
  int threads = 1; ///< of each process
};

/// Solves the load steps in this process.
std::unique_ptr<LoadSteps>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting);

} // namespace asperity::app
