#pragma once

// This file contains the fields of one contact problem in the unpreconditioned
// method, and the operations on them.

#include "contact/solvers/solver.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace asperity::contact {

/// Pressure, displacement and residual of a problem, kept consistent.
class ProjectedState {
public:
  /// Checks the arguments and sets the initial state.
  /// @throws std::domain_error  see solve_contact
  ProjectedState(SurfaceOperator& elasticity, const ContactProblem& problem,
                 const mechanics::LoadTarget& target,
                 std::span<const double> initial_pressure);

  /// Updates the residual gap + c p, the separation u (under pressure control
  /// it makes the mean residual over the contact vanish), the error and the
  /// active set. A displacement that was updated by recurrence is recomputed
  /// before convergence is accepted.
  void update_residual();

  /// Sets p = max(0, p - step * direction) on the active nodes, then restores
  /// the prescribed mean pressure by scaling. `compliance_direction` is C
  /// direction: if no pressure was set to 0, the displacement is updated by
  /// recurrence. If it is empty the displacement is recomputed.
  void advance(double step, std::span<const double> direction,
               std::span<const double> compliance_direction);

  /// Sum of weight * a * b over all nodes.
  double dot(std::span<const double> a, std::span<const double> b) const;

  /// True if the tolerance is met, if the iteration limit is reached, or if the
  /// error is not finite.
  bool is_at_end() const {
    return is_converged() || !std::isfinite(gap_error) ||
           iterations >= problem.max_iterations;
  }

  /// The state as a solution; its note says if it did not converge.
  ContactSolution solution() &&;

  SurfaceOperator& elasticity;
  ContactProblem problem;
  mechanics::LoadTarget target;
  std::vector<double> pressure;      ///< p [Pa]
  std::vector<double> displacement;  ///< C p [m]
  std::vector<double> residual;      ///< gap + c p on the active nodes, else 0
  std::vector<std::uint8_t> is_free; ///< active: in contact, or overlapping
  double rigid_distance = 0.0;       ///< u [m]
  double gap_error = 0.0;            ///< [m]
  int iterations = 0;
  int transforms = 0;

private:
  double weight(std::size_t i) const {
    return weights_.empty() ? 1.0 : weights_[i];
  }

  bool is_converged() const { return gap_error <= problem.gap_tolerance; }

  void compute_displacement();
  void measure_residual();

  bool is_computed_ = false; ///< displacement recomputed, not updated
  std::span<const double> weights_;
};

} // namespace asperity::contact
