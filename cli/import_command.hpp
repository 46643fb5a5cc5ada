#pragma once

// The command that imports the answer of another program to a problem.

#include "run/exit_code.hpp"

#include <string>

namespace asperity::cli {

/// Options of `asperity import`.
struct ImportCommand {
  std::string submission; ///< folder with submission.toml
  std::string problem;    ///< folder with problem.json
  std::string out;        ///< folder; empty: out/<code>-<problem>
};

/// Certifies each field, names typical mistakes and the claims that do not
/// hold, and writes result.h5 and certificate.json.
/// @return  exit_expectation_failed if there is a mistake or a broken claim
/// @throws input::InputError  the problem or the submission is invalid
run::ExitCode import_submission(const ImportCommand& command);

} // namespace asperity::cli
