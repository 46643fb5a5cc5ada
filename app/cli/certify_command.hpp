#pragma once

// `asperity certify`: bounds on the errors of the pressure fields of a result,
// whichever program computed them.

#include "app/run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// Prints one line per saved pressure field: what it violates, and how far its
/// pressure and its mean gap can be from the exact answer of the discrete
/// problem. A method for which no bound exists is labelled "as submitted".
///
/// @param paths  results (files or folders)
/// @return  exit_bad_input if no field could be certified
ExitCode certify_results(const std::vector<std::string>& paths);

} // namespace asperity::app
