#pragma once

// What every solver of the contact problem begins with: the checks of its
// arguments and a pressure at the prescribed load.

#include "contact/solvers/contact_problem.hpp"

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

/// Scales the pressures below the hardness to the mean pressure of the target,
/// if the target prescribes one, and cuts them off at the hardness. If no node
/// carries a load, the pressure, and hence its residual, becomes NaN. If those
/// that do cannot carry it at the hardness, press_to_load() follows.
/// @param hardness  H [Pa]
void scale_to_target(const SurfaceOperator& elasticity,
                     const mechanics::LoadTarget& target, double hardness,
                     std::span<double> pressure);

/// Subtracts a number from a field so that its positive part, cut off at the
/// hardness, has the load that is prescribed, to 1e-3 or, with a hardness, to
/// 1e-12: the bodies are moved apart or together. That part replaces the field.
/// With a prescribed mean gap nothing is subtracted.
void press_to_load(const SurfaceOperator& elasticity,
                   const mechanics::LoadTarget& target, double hardness,
                   std::span<double> pressure);

} // namespace asperity::contact
