#pragma once

// The command that hands out a case as a problem for other programs.

#include "run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

/// Options of `asperity problem`.
struct ProblemCommand {
  std::string contact_case; ///< case file, folder or shipped case
  std::vector<std::string> overrides;
  std::string method; ///< whose block is pressed; empty: the first suitable one
  std::string out;    ///< folder; empty: out/<case>/problem
  bool has_mesh = false; ///< whether the block is handed out as cells, too
};

/// Writes the folder that exchange/problem_folder.hpp describes.
/// @return  exit_not_converged if a load has no answer; nothing is written then
/// @throws input::InputError  the case is invalid, is a collection, or has no
///                            method with a surface operator
run::ExitCode write_problem_of(const ProblemCommand& command);

} // namespace asperity::cli
