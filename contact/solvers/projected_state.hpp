#pragma once

// The fields of one contact problem under the plain method and the few
// operations it makes on them.

#include "contact/solvers/solver.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace asperity::contact {

/// Pressure, displacement and residual of a problem, kept consistent.
class ProjectedState {
public:
  /// Checks the arguments and takes the start.
  /// @throws std::domain_error  see solve_contact
  ProjectedState(SurfaceOperator& elasticity, const ContactProblem& problem,
                 const LoadTarget& target,
                 std::span<const double> initial_pressure);

  /// Residual gap + c p, rigid distance (under pressure control the mean over
  /// the contact is made 0), error and the set of free nodes. A displacement
  /// that followed by recurrence is computed anew before the tolerance is
  /// believed.
  void update_residual();

  /// p = max(0, p - step * direction) on the free nodes, then the prescribed
  /// mean pressure by scaling. `compliance_direction` is C direction: while no
  /// pressure was cut the displacement follows by recurrence. If it is empty
  /// the displacement is computed.
  void advance(double step, std::span<const double> direction,
               std::span<const double> compliance_direction);

  /// Sum of weight * a * b over all nodes.
  double dot(std::span<const double> a, std::span<const double> b) const;

  /// True at the tolerance, after the iterations allowed, or where an error
  /// that is not finite leaves nothing to go on from.
  bool is_at_end() const {
    return is_converged() || !std::isfinite(gap_error) ||
           iterations >= problem.max_iterations;
  }

  /// The state as the answer; says if it did not converge.
  ContactSolution solution() &&;

  SurfaceOperator& elasticity;
  ContactProblem problem;
  LoadTarget target;
  std::vector<double> pressure;      ///< p [Pa]
  std::vector<double> displacement;  ///< C p [m]
  std::vector<double> residual;      ///< gap + c p on the free nodes, else 0
  std::vector<std::uint8_t> is_free; ///< in contact, or overlapping
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

  bool is_computed_ = false; ///< the displacement holds no recurrence
  std::span<const double> weights_;
};

} // namespace asperity::contact
