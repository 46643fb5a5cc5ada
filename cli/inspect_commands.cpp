#include "cli/inspect_commands.hpp"

#include "cli/manual/command_model.hpp"

namespace asperity::cli {
namespace {

void add_describe(CLI::App& program, DescribeCommand& describe,
                  run::OutputOptions& output, Action& action) {
  CLI::App* command = program.add_subcommand(
      "describe", "Print every key of a case in SI units, what\n"
                  "follows from them, and the plan of its run;\n"
                  "compute nothing.");
  command
      ->add_option("case", describe.contact_case,
                   "case file, its folder, shipped case, collection\n"
                   "or measured map")
      ->required();
  add_methods(command, describe.methods);
  command->add_option("--contact-modulus", describe.contact_modulus,
                      "E* of the block under a map file, e.g. \"2 GPa\"");
  add_overrides(command, describe.overrides);
  add_quick(command, describe.is_quick);
  add_threads(command, describe.threads);
  add_quiet(command, output);
  add_json(command, output, "everything");
  add_example(command, "describe polymer --set surface.points=1024");
  command->callback([&] { action = [&] { return describe_cases(describe); }; });
}

void add_diff(CLI::App& program, DiffCommand& diff, run::OutputOptions& output,
              Action& action) {
  CLI::App* command = program.add_subcommand(
      "diff", "Compare two results or cases: keys, input\n"
              "files, build and numbers; exit 1 if they\n"
              "differ.");
  command->add_option("one", diff.one, "result (file or folder) or case")
      ->required();
  command->add_option("other", diff.other, "result (file or folder) or case")
      ->required();
  command
      ->add_option("--tolerance", diff.tolerance,
                   "largest relative difference of numbers that\n"
                   "counts as equal; 0 compares counts of iterations\n"
                   "and residuals, too")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  add_quiet(command, output);
  add_json(command, output, "all differences");
  add_example(command, "diff out/polymer old/polymer --tolerance 1e-6");
  command->callback([&] { action = [&] { return diff_two(diff); }; });
}

/// Adds the commands from which packages generate files. They are hidden.
void add_generators(CLI::App& program, InspectCommands& commands,
                    Action& action) {
  CLI::App* completion = program.add_subcommand(
      "completion", "Print the completion script of a shell.");
  completion->add_option("shell", commands.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->group("");
  completion->callback([&] {
    action = [&] {
      run::emit_answer(completion_script(model_of(program), commands.shell));
      return run::exit_good;
    };
  });
  CLI::App* manual = program.add_subcommand(
      "man", "Print the manual page of the program or of a command.");
  manual->add_option("command", commands.page, "command (default: none)");
  manual->add_option("--out", commands.pages_folder,
                     "write all pages into this folder");
  manual->group("");
  manual->callback([&] {
    action = [&] {
      const ProgramModel model = model_of(program);
      if (commands.pages_folder.empty())
        run::emit_answer(manual_page(model, commands.page));
      else
        write_manual(model, commands.pages_folder);
      return run::exit_good;
    };
  });
}

} // namespace

void add_inspect_commands(CLI::App& program, InspectCommands& commands,
                          run::OutputOptions& output, Action& action) {
  add_describe(program, commands.describe, output, action);
  add_diff(program, commands.diff, output, action);
  add_generators(program, commands, action);
}

} // namespace asperity::cli
