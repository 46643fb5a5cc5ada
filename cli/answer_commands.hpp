#pragma once

// The options of the commands that exchange problems and answers with other
// programs: certify, problem, import and board.

#include "cli/board_command.hpp"
#include "cli/certify_command.hpp"
#include "cli/command_parts.hpp"
#include "cli/import_command.hpp"
#include "cli/problem_command.hpp"

namespace asperity::cli {

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
                         run::OutputOptions& output, Action& action);

} // namespace asperity::cli
