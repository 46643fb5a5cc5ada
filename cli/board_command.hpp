#pragma once

// The command that builds the board: a static site of certified answers.

#include "run/exit_code.hpp"

#include <string>

namespace asperity::cli {

/// Options of `asperity board`.
struct BoardCommand {
  std::string folder; ///< problems and submissions, see board/board.hpp
  std::string out;    ///< folder of the site; empty: out/board-site
};

/// @return  exit_expectation_failed if a submission failed
/// @throws input::InputError  there are no submissions, or a problem is invalid
run::ExitCode build_board(const BoardCommand& command);

} // namespace asperity::cli
