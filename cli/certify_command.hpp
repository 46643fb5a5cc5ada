#pragma once

// `asperity certify`: bounds on the errors of the pressure fields of a result,
// whichever program computed them.

#include "run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

/// Options of `asperity certify`.
struct CertifyCommand {
  std::vector<std::string> results; ///< files or folders
};

/// Prints one line per saved pressure field: what it violates, and how far its
/// pressure and its mean gap can be from the exact answer of the discrete
/// problem. A method for which no bound exists is labelled "as submitted".
///
/// @return  exit_bad_input if no field could be certified,
///          exit_expectation_failed if a mean gap cannot be shown to be within
///          1e-3 h_rms of the exact one
run::ExitCode certify_results(const CertifyCommand& command);

} // namespace asperity::cli
