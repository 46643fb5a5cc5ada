#pragma once

// The state of a contact problem in the methods without a preconditioner.

#include "contact/solvers/contact_state.hpp"

#include <span>

namespace asperity::contact {

/// The same state, with search directions in double precision that need not
/// preserve the load.
class ProjectedState : public ContactState {
public:
  ProjectedState(SurfaceOperator& elasticity_, const ContactProblem& problem_,
                 const mechanics::LoadTarget& target_,
                 std::span<const double> initial_pressure)
      : ContactState(elasticity_, problem_, target_,
                     {initial_pressure.begin(), initial_pressure.end()}) {}

  /// Sets p = max(0, p - step * direction), cut off at a hardness, then
  /// restores the prescribed mean pressure by scaling. `compliance_direction`
  /// is C direction: if no pressure was set to 0, the displacement is updated
  /// by recurrence. If it is empty the displacement is recomputed.
  void advance(double step, std::span<const double> direction,
               std::span<const double> compliance_direction);

  /// Sum of weight * a * b over all nodes.
  double dot(std::span<const double> a, std::span<const double> b) const;
};

} // namespace asperity::contact
