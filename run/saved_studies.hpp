#pragma once

// Studies of a result that was saved without them.

#include "results/types/result.hpp"

#include <string>
#include <vector>

namespace asperity::run {

/// Lets the case of a result ask for studies, and lets these evaluate the saved
/// maps: the rows of their steps, and the tables of maps. Rows of the theory by
/// the formula of the spectrum need no maps. Other rows have no answer, and
/// what a full block finds only with its solution stays unknown.
/// @param asked  keys of tables of studies, as for --set:
///               "flow.viscosity=\"1 mPa s\""
/// @return  the number of steps with maps that were evaluated
/// @throws input::InputError  a key is not that of a study, the result has the
///           study already, the case does not allow it, or the study needs load
///           steps that the result does not have
int ask_of_saved(results::Result& result,
                 const std::vector<std::string>& asked);

} // namespace asperity::run
