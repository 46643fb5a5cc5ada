// The commands that look at cases and results without running anything:
// describe, diff, and the hidden ones that generate shell completions and
// manual pages.
#include "input/input_error.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/trial_read.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/command_line.hpp"
#include "run/cli/manual/command_model.hpp"
#include "run/difference.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/output.hpp"
#include "run/plan/description.hpp"
#include "run/result_outputs.hpp"

#include <fmt/format.h>

namespace asperity::cli {
namespace {

/// Options of `asperity describe`.
struct DescribeCommand {
  std::string contact_case; ///< case file, folder, shipped case, collection or
                            ///< map file
  run::CaseOptions options;
  methods::AskedMethods methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  bool is_quick = false;              ///< apply quick.set
  int threads = 0;                    ///< for the prediction of the time
};

/// Prints the description of a case, or of each part of a collection.
/// @throws input::InputError  the case is invalid
run::ExitCode describe_cases(const DescribeCommand& command) {
  const run::NamedCases named =
      run::read_named_cases(command.contact_case, command.overrides,
                            command.is_quick, command.options);
  methods::Cache cache(methods::cache_folder(), methods::cache_size());
  std::string json;
  std::string text;
  for (const run::ReadCase& read : named.cases) {
    run::RunOptions options{{}, command.methods, false, command.threads, ""};
    options.cache = &cache;
    const run::CaseDescription description =
        run::describe_case(read.contact_case, options);
    json += (json.empty() ? "" : ",\n") +
            run::description_json(description, read.contact_case);
    text += (text.empty() ? "" : "\n") +
            run::description_text(description, read.contact_case);
  }
  if (run::wants_json())
    run::emit_answer(named.found.collection.empty() ? json
                                                    : "[" + json + "]\n");
  else
    fmt::print("{}", text);
  return run::exit_good;
}

/// Options of `asperity diff`.
struct DiffCommand {
  std::string one; ///< result (file or folder) or case
  std::string other;
  double tolerance = 0.0; ///< relative [1] >= 0
};

run::ComparedSide read_side(const std::string& word) {
  run::ComparedSide side;
  side.path = word;
  if (run::is_result(word)) {
    results::require_readable(word);
    side.result = results::read_result(word, results::MapsInFile::large);
    side.inputs = results::inputs_of(*side.result);
    side.inputs.erase("program"); // belongs to the build
    if (!side.result->case_text.empty())
      side.contact_case = reports::case_of(*side.result);
    return side;
  }
  const run::NamedCases named = run::read_named_cases(word);
  if (!named.found.collection.empty())
    throw input::InputError(
        word + " is a collection of " + std::to_string(named.cases.size()) +
        " cases; compare its parts, such as " + named.cases.front().found.name);
  side.contact_case = named.cases.front().contact_case;
  side.inputs = methods::input_hashes(*side.contact_case);
  return side;
}

/// Prints how two results or cases differ.
/// @return  exit_expectation_failed if they differ
/// @throws input::InputError  one of them cannot be read, or is a collection
run::ExitCode diff_two(const DiffCommand& command) {
  const run::ComparedSide one = read_side(command.one);
  const run::ComparedSide other = read_side(command.other);
  const run::Difference difference =
      run::difference_of(one, other, command.tolerance);
  if (run::wants_json())
    run::emit_answer(run::difference_json(difference, command.tolerance));
  else
    fmt::print("{} | {}\n{}", one.path, other.path,
               run::difference_text(difference, command.tolerance));
  return difference.is_any() ? run::exit_expectation_failed : run::exit_good;
}

void add_describe(CommandLine& line) {
  auto [command, describe] =
      line.add<DescribeCommand>("describe",
                                "Print every key of a case in SI units, what\n"
                                "follows from them, and the plan of its run;\n"
                                "compute nothing.",
                                describe_cases);
  command
      ->add_option("case", describe.contact_case,
                   "case file, its folder, shipped case, collection\n"
                   "or measured map")
      ->required();
  add_methods(command, describe.methods.names);
  add_case_options(command, describe.options);
  add_overrides(command, describe.overrides);
  add_quick(command, describe.is_quick);
  add_threads(command, describe.threads);
  add_quiet(command, line.output);
  add_json(command, line.output, "everything");
  line.on_cases.insert("describe");
  add_example(command, "describe polymer --set surface.points=1024");
}

void add_diff(CommandLine& line) {
  auto [command, diff] =
      line.add<DiffCommand>("diff",
                            "Compare two results or cases: keys, input\n"
                            "files, build and numbers; exit 1 if they\n"
                            "differ.",
                            diff_two);
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
  add_quiet(command, line.output);
  add_json(command, line.output, "all differences");
  line.on_cases.insert("diff");
  add_example(command, "diff out/polymer old/polymer --tolerance 1e-6");
}

/// Of the commands from which packages generate files, which are hidden.
struct ManualCommand {
  std::string page;   ///< name of a command; empty: the program
  std::string folder; ///< for all pages; empty: print one
};

void add_generators(CommandLine& line) {
  auto [completion, shell] = line.add<std::string>(
      "completion", "Print the completion script of a shell.",
      [&line](const std::string& name) {
        run::emit_answer(
            completion_script(model_of(line.program, line.on_cases), name));
        return run::exit_good;
      });
  completion->add_option("shell", shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->group("");
  auto [manual, pages] = line.add<ManualCommand>(
      "man", "Print the manual page of the program or of a command.",
      [&line](const ManualCommand& command) {
        const ProgramModel model = model_of(line.program, line.on_cases);
        if (command.folder.empty())
          run::emit_answer(manual_page(model, command.page));
        else
          write_manual(model, command.folder);
        return run::exit_good;
      });
  manual->add_option("command", pages.page, "command (default: none)");
  manual->add_option("--out", pages.folder, "write all pages into this folder");
  manual->group("");
}

} // namespace

void add_inspect_commands(CommandLine& line) {
  add_describe(line);
  add_diff(line);
  add_generators(line);
}

} // namespace asperity::cli
