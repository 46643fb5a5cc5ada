#pragma once

// What both solvers do before their first iteration.

#include "contact/solver.hpp"

#include <span>
#include <vector>

namespace asperity::contact {

/// Checks the arguments of solve_contact.
/// @return  the pressure it starts from [Pa], at the target's load
/// @throws std::domain_error  see solve_contact
std::vector<double> starting_pressure(const SurfaceOperator& elasticity,
                                      const ContactProblem& problem,
                                      const LoadTarget& target,
                                      std::span<const double> initial_pressure);

/// Scales to the mean pressure of the target, if that is what it asks.
/// @param threads  >= 1; their number changes no bit
void scale_to_target(const LoadTarget& target, std::span<const double> weights,
                     std::span<double> pressure, int threads = 1);

} // namespace asperity::contact
