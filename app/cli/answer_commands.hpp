#pragma once

// The options of the commands that exchange problems and answers with other
// programs: certify, problem, import and board.

#include "app/cli/board_command.hpp"
#include "app/cli/certify_command.hpp"
#include "app/cli/command_parts.hpp"
#include "app/cli/import_command.hpp"
#include "app/cli/problem_command.hpp"

namespace asperity::app {

/// What the command line says of each.
struct AnswerCommands {
  CertifyCommand certify;
  ProblemCommand problem;
  ImportCommand import_answer;
  BoardCommand board;
};

/// @param commands, output, action  must outlive the parsing of the command
/// line
void add_answer_commands(CLI::App& program, AnswerCommands& commands,
                         OutputOptions& output, Action& action);

} // namespace asperity::app
