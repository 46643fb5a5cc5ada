#pragma once

// What a method costs before it is run: counted operations times the rates of
// this machine.

#include "app/plan/machine_rates.hpp"
#include "cases/types/case.hpp"

namespace asperity::app {

/// NaN where nothing is known.
struct MethodCost {
  double unknowns = 0.0;   ///< of one load step
  double setup_time = 0.0; ///< CPU, once a grid, block and run [s]
  double step_time = 0.0;  ///< CPU, of one load step [s]
  double memory = 0.0;     ///< of one realisation at work [B]
};

/// Of one method on a surface of that grid. The constants are named in
/// cost_model.cpp with the runs they come from; docs/skip.md holds predictions
/// against what then happened.
MethodCost cost_of(const cases::Case& rough_case,
                   const cases::MethodSpec& method, const Grid& grid,
                   MachineRates& rates);

/// Of the tables of [magnification] and [adhesion], CPU [s].
double study_time(const cases::Case& rough_case, MachineRates& rates);

/// Of the stress below the face, for `n_maps` kept maps on the grid and a
/// section, of one method, CPU [s].
double stress_time(int n_maps, const Grid& grid, MachineRates& rates);

/// Of a run in which nothing is computed: start, surfaces, file. CPU [s].
double base_time(MachineRates& rates);

/// Of the program alone, and with the finite elements loaded [B].
double base_memory(bool uses_fem);

/// Bytes that a map of pressure and gap takes in a result, packed.
double map_bytes(const Grid& grid);

} // namespace asperity::app
