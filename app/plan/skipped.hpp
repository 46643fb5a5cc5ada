#pragma once

// What a scene does not need, with what it would have cost. Only things that
// are really not computed.

#include "app/plan/cost_model.hpp"
#include "results/types/result.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// A case, and the methods of it that are run.
struct AskedScene {
  const cases::Case& rough_case;
  const std::vector<cases::MethodSpec>& methods;
  Grid grid; ///< of its surfaces; of no points where none is built and the
             ///< case does not say
};

/// Methods left out, realisations a formula does not tell apart, maps that are
/// not kept, unknowns and wavevectors that symmetry spares, depth that a closed
/// form replaces. Costs are predictions of cost_model.hpp.
std::vector<results::Skipped> skipped_by_scene(const AskedScene& scene,
                                               MachineRates& rates);

/// The grid of a case's surfaces. Where the case does not say it, a map is read
/// if surfaces are needed; else the grid has no points.
Grid grid_of_case(const cases::Case& rough_case,
                  const std::vector<cases::MethodSpec>& methods);

/// Counts are printed to three digits: "786k", "1.18e+09".
std::string count_text(double count);

} // namespace asperity::app
