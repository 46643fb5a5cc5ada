#pragma once

// The reference solver of the contact problem, without a preconditioner, and
// its state.

#include "contact/solvers/contact_state.hpp"

#include <span>

namespace asperity::contact {

/// A state of a contact problem with search directions in double precision that
/// need not preserve the load.
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

/// The reference solver: the conjugate gradients of Polonsky and Keer without a
/// preconditioner. It has the arguments and the return value of solve_contact.
/// It is slow, but it always terminates.
ContactSolution polonsky_keer(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const mechanics::LoadTarget& target,
                              std::span<const double> initial_pressure = {});

} // namespace asperity::contact
