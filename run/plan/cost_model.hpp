#pragma once

// Predicts the cost of a method before it runs: operation counts times the
// measured rates of this machine.

#include "cases/types/case.hpp"
#include "run/plan/machine_rates.hpp"

namespace asperity::run {

/// The cost of a method; NaN where no prediction exists.
struct MethodCost {
  double unknowns = 0.0;   ///< per load step
  double setup_time = 0.0; ///< CPU time, once per grid, block and run [s]
  double step_time = 0.0;  ///< CPU time per load step [s]
  double memory = 0.0;     ///< per running realisation [B]
};

/// Predicts the cost of one method on a surface with this grid. The constants
/// in cost_model.cpp name the runs they come from; docs/numerics/skip.md
/// compares predictions with measured costs.
/// @param ranks  number of processes, which chooses the linear solver of a full
///               block; the times are sums over all of them
MethodCost cost_of(const cases::Case& contact_case,
                   const cases::MethodSpec& method, const Grid& grid,
                   MachineRates& rates, int ranks = 1);

/// Predicts the memory of each of several ranks that share the rows of a
/// method, without that of the program [B].
double memory_of_rank(const cases::MethodSpec& method, const Grid& grid,
                      int ranks);

/// Predicts the CPU time of the tables of [magnification] and [adhesion] [s].
double study_time(const cases::Case& contact_case, MachineRates& rates);

/// Predicts the CPU time of the subsurface stress for one method: `n_maps`
/// saved maps on the grid and one section [s].
double stress_time(int n_maps, const Grid& grid, MachineRates& rates);

/// Predicts the CPU time of a run in which nothing is computed: start-up,
/// surfaces and result file [s].
double base_time(MachineRates& rates);

/// Returns the memory of the program alone, or with the finite-element library
/// loaded [B].
double base_memory(bool uses_fem);

/// Predicts the compressed size of a map of pressure and gap in a result file
/// [B].
double map_bytes(const Grid& grid);

} // namespace asperity::run
