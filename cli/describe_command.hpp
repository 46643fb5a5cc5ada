#pragma once

// The command that prints a case as the program understands it.

#include "run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

/// Options of `asperity describe`.
struct DescribeCommand {
  std::string contact_case; ///< case file, folder, shipped case, collection or
                            ///< map file
  std::string contact_modulus; ///< E* for a map file; "" for a case
  std::vector<std::string> methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  bool is_quick = false;              ///< apply quick.set
  int threads = 0;                    ///< for the prediction of the time
};

/// Prints the description of a case, or of each part of a collection.
/// @throws input::InputError  the case is invalid
run::ExitCode describe_cases(const DescribeCommand& command);

} // namespace asperity::cli
