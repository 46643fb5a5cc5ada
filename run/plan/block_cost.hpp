#pragma once

// Predicts the cost of a full 3-D block before it is meshed: the unknowns and
// the linear solver that fem/ states, times one rate per solver.

#include "fem/plugin.hpp"
#include "run/plan/cost_model.hpp"

namespace asperity::run {

/// CPU time for loading deal.II, on the reference machine of cost_model.cpp
/// [s].
inline constexpr double fem_load_time = 0.25;

/// Factor by which a prediction for a full block may be off in either direction
/// [1]. docs/numerics/skip.md shows the spread, because the iterations depend
/// on load, contact and moduli.
inline constexpr double block_factor = 3.0;

/// What fem/ expects of the block of a method with solver = "full".
/// @param grid   that the method presses
/// @param ranks  number of processes that share the block
/// @throws std::domain_error, input::InputError  the mesh would be refused
fem::BlockTraits block_of(const cases::Case& contact_case,
                          const cases::MethodSpec& method, const Grid& grid,
                          int ranks);

/// Predicts the cost of that method; the arguments are those of block_of().
MethodCost cost_of_full_block(const cases::Case& contact_case,
                              const cases::MethodSpec& method, const Grid& grid,
                              MachineRates& rates, int ranks);

/// Returns the memory that deal.II and Trilinos need for any full block, in
/// addition to the memory for loading them [B].
double full_block_memory();

} // namespace asperity::run
