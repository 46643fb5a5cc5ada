#pragma once

// What every solver does before its first iteration and says after its last.

#include "contact/solvers/solver.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::contact {

/// Checks the arguments of solve_contact.
/// @return  the pressure it starts from [Pa], at the target's load
/// @throws std::domain_error  see solve_contact
std::vector<double> starting_pressure(const SurfaceOperator& elasticity,
                                      const ContactProblem& problem,
                                      const LoadTarget& target,
                                      std::span<const double> initial_pressure);

/// What a pressure with this (weighted) sum over the nodes is multiplied by to
/// bear the prescribed load. NaN where that is no number of full precision:
/// the sum is 0, not finite or out of all proportion to the load.
double load_scale(const LoadTarget& target, std::size_t nodes,
                  double pressure_sum);

/// Scales to the mean pressure of the target, if that is what it asks. Where no
/// node carries a load, the pressure is NaN afterwards, and so is its residual.
/// @param threads  >= 1; their number changes no bit
void scale_to_target(const LoadTarget& target, std::span<const double> weights,
                     std::span<double> pressure, int threads = 1);

/// Why iterations that ended with this error [m] are not converged.
std::string not_converged_note(double gap_error, int iterations);

} // namespace asperity::contact
