#include "cli/answer_commands.hpp"

namespace asperity::cli {
namespace {

void add_certify(CLI::App& program, CertifyCommand& certify,
                 run::OutputOptions& output, Action& action) {
  CLI::App* command = program.add_subcommand(
      "certify", "Bound the errors of the pressure fields of\n"
                 "results, of any program; exit 1 if a mean gap\n"
                 "may be wrong by more than 1e-3 h_rms.");
  command->add_option("result", certify.results, "results (files or folders)")
      ->required();
  add_quiet(command, output);
  add_json(command, output, "all numbers");
  add_example(command, "certify out/polymer");
  command->callback([&] { action = [&] { return certify_results(certify); }; });
}

void add_problem(CLI::App& program, ProblemCommand& problem,
                 run::OutputOptions& output, Action& action) {
  CLI::App* command = program.add_subcommand(
      "problem", "Write the contact problem of a case as a folder\n"
                 "that any other program can read: problem.json,\n"
                 "heights, checksums and reference answers.");
  command
      ->add_option("case", problem.contact_case,
                   "case file, its folder or shipped case")
      ->required();
  command->add_option("--out", problem.out,
                      "folder to write (default: out/<case>/problem)");
  add_overrides(command, problem.overrides);
  command->add_option("--method", problem.method,
                      "half-space or condensed finite-element method\n"
                      "whose block is pressed (default: the first)");
  command->add_flag("--mesh", problem.has_mesh,
                    "write the block as hexahedra, too, for\n"
                    "gmsh (mesh.msh) and Abaqus (mesh.inp)");
  add_quiet(command, output);
  add_example(command, "problem wave-1d --out wave-1d-problem");
  command->callback(
      [&] { action = [&] { return write_problem_of(problem); }; });
}

void add_import(CLI::App& program, ImportCommand& import_answer,
                run::OutputOptions& output, Action& action) {
  CLI::App* command = program.add_subcommand(
      "import", "Read another program's answer to a problem,\n"
                "certify it, name typical mistakes and write it\n"
                "as a result; exit 1 if a claim does not hold.");
  command
      ->add_option("submission", import_answer.submission,
                   "folder with submission.toml")
      ->required();
  command
      ->add_option("--problem", import_answer.problem,
                   "folder with problem.json, as asperity problem\n"
                   "writes it")
      ->required();
  command->add_option("--out", import_answer.out,
                      "output folder (default: out/<code>-<problem>)");
  add_quiet(command, output);
  add_json(command, output, "certificate.json");
  add_example(command, "import answers/mycode --problem wave-1d-problem");
  command->callback(
      [&] { action = [&] { return import_submission(import_answer); }; });
}

void add_board(CLI::App& program, BoardCommand& board,
               run::OutputOptions& output, Action& action) {
  CLI::App* command = program.add_subcommand(
      "board", "Certify the answers of many codes to problems\n"
               "and build a static site that ranks them; exit 1\n"
               "if one is not certified.");
  command
      ->add_option("folder", board.folder,
                   "folder with problems and submissions")
      ->required();
  command->add_option("--out", board.out,
                      "folder of the site (default: out/board-site)");
  add_quiet(command, output);
  add_json(command, output, "board.json");
  add_example(command, "board cases/board --out site");
  command->callback([&] { action = [&] { return build_board(board); }; });
}

} // namespace

void add_answer_commands(CLI::App& program, AnswerCommands& commands,
                         run::OutputOptions& output, Action& action) {
  add_certify(program, commands.certify, output, action);
  add_problem(program, commands.problem, output, action);
  add_import(program, commands.import_answer, output, action);
  add_board(program, commands.board, output, action);
}

} // namespace asperity::cli
