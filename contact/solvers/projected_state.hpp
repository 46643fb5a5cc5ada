#pragma once

// The fields of one contact problem in the unpreconditioned method, and the
// operations on them.

#include "contact/solvers/iteration.hpp"

#include <cstdint>
#include <vector>

#include "ranks/node_weights.hpp"

namespace asperity::contact {

/// Pressure, displacement and residual of a problem, kept consistent.
class ProjectedState : public Iteration {
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

  /// The state as a solution; its note says if it did not converge.
  ContactSolution solution() &&;

  std::vector<double> displacement;  ///< C p [m]
  std::vector<double> residual;      ///< gap + c p on the active nodes, else 0
  std::vector<std::uint8_t> is_free; ///< active: in contact, or overlapping
  double rigid_distance = 0.0;       ///< u [m]

private:
  double weight(std::size_t i) const { return weight_of(weights_, i); }

  void compute_displacement();
  void measure_residual();

  bool is_computed_ = false; ///< displacement recomputed, not updated
  std::span<const double> weights_;
  Workers workers_;
};

} // namespace asperity::contact
