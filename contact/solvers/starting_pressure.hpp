#pragma once

// What every solver of the contact problem begins with: the checks of its
// arguments and a pressure at the prescribed load.

#include "contact/solvers/solver.hpp"

#include <span>
#include <vector>

namespace asperity::contact {

/// Checks the arguments of solve_contact.
/// @return  the initial pressure [Pa], at the load of the target
/// @throws std::domain_error  see solve_contact
std::vector<double> starting_pressure(const SurfaceOperator& elasticity,
                                      const ContactProblem& problem,
                                      const mechanics::LoadTarget& target,
                                      std::vector<double> initial_pressure);

/// Factor that scales a pressure with this (weighted) sum over the nodes to the
/// prescribed load. It is NaN if it cannot be computed to full precision: the
/// sum is 0, not finite, or out of proportion to the load.
double load_scale(const mechanics::LoadTarget& target, std::size_t nodes,
                  double pressure_sum);

/// Scales the pressure to the mean pressure of the target, if the target
/// prescribes one. If no node carries a load, the pressure, and hence its
/// residual, becomes NaN.
/// @param workers  the result does not depend on their number
void scale_to_target(const mechanics::LoadTarget& target,
                     std::span<const double> weights,
                     std::span<double> pressure, const Workers& workers = 1);

} // namespace asperity::contact
