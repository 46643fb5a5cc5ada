#pragma once

// Lists the work that a case does not need. Only work that is really not done
// is listed.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <string>
#include <vector>

namespace asperity::run {

/// A case and those of its methods that are run.
struct SelectedCase {
  const cases::Case& contact_case;
  const std::vector<cases::MethodSpec>& methods;
  Grid grid; ///< grid of the surfaces; without points if no surface is built
             ///< and the case does not give the grid
};

/// Lists methods that were not selected, what the case asks of a method that
/// has no answer (input/types/omissions.hpp), realisations that are identical
/// for a closed formula, maps that are not saved, unknowns and wavevectors that
/// symmetry makes redundant, and bulk material that a closed form replaces.
std::vector<results::Skipped> skipped_by_case(const SelectedCase& selected);

/// Returns the grid of the surfaces of a case. If the case does not give it,
/// the height map is read when surfaces are needed; otherwise the grid has no
/// points.
Grid grid_of_case(const cases::Case& contact_case,
                  const std::vector<cases::MethodSpec>& methods);

/// Formats a count with three digits, such as "786k" or "1.18e+09".
std::string count_text(double count);

} // namespace asperity::run
