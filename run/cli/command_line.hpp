#pragma once

// The command line while it is described: its commands, and the options that
// several of them share.

#include "input/case_options.hpp"
#include "run/arguments/case_options.hpp"
#include "run/exit_code.hpp"
#include "run/output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace asperity::cli {

struct CommandLine {
  CLI::App program;
  run::OutputOptions output = {};             ///< of the chosen command
  std::function<run::ExitCode()> action = {}; ///< the chosen command
  /// Commands whose arguments are cases, which the completion of a shell lists.
  std::set<std::string> on_cases = {};

  /// Adds a command, with an object for its options that `run` gets if the
  /// command is chosen.
  template <class Options>
  std::pair<CLI::App*, Options&>
  add(const std::string& name, const std::string& text,
      std::function<run::ExitCode(const Options&)> run) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(name, text);
    command->callback([this, options, run = std::move(run)] {
      action = [options, run] { return run(*options); };
    });
    return {command, *options};
  }
};

/// In which forms a report is written besides its page.
struct ReportForms {
  bool has_pdf = false;             ///< also print the report
  std::vector<std::string> formats; ///< of figures for a journal
  std::string width = "86mm";       ///< of these
  std::string units;                ///< likewise; empty: those of the report
};

/// Adds an example line to the help of a command, before the footer that all
/// commands share.
inline void add_example(CLI::App* command, const std::string& line) {
  command->footer("example:\n  asperity " + line + "\n\n" +
                  command->get_footer());
}

/// Adds --set, by which a key of the case file is overridden.
inline void add_overrides(CLI::App* command,
                          std::vector<std::string>& overrides) {
  command
      ->add_option("--set", overrides,
                   "override a key of the case file, e.g.\n"
                   "surface.points=128; may be repeated")
      ->allow_extra_args(false);
}

/// Adds the options that stand for keys of a case.
inline void
add_case_options(CLI::App* command, run::CaseOptions& options,
                 std::initializer_list<input::OptionGroup> groups = {
                     input::OptionGroup::map, input::OptionGroup::body,
                     input::OptionGroup::load, input::OptionGroup::effect}) {
  for (const input::CaseOption& option : input::case_options())
    if (std::ranges::find(groups, option.group) != groups.end())
      command
          ->add_option(std::string(option.name), options.place(option.name),
                       option.help)
          ->type_name(std::string(option.value))
          ->multi_option_policy(option.group == input::OptionGroup::load
                                    ? CLI::MultiOptionPolicy::Join
                                    : CLI::MultiOptionPolicy::Throw)
          ->delimiter(',')
          ->group("Maps, bodies and physics");
}

/// Adds --quiet, and --json with a text that says what is printed as JSON.
inline void add_quiet(CLI::App* command, run::OutputOptions& options) {
  command->add_flag("--quiet", options.is_quiet, "print errors only");
}

inline void add_json(CLI::App* command, run::OutputOptions& options,
                     const std::string& what) {
  command->add_flag("--json", options.is_json,
                    "print " + what +
                        " as JSON; other text\n"
                        "goes to standard error");
}

/// Adds --methods, by which methods of the case are chosen.
inline void add_methods(CLI::App* command, std::vector<std::string>& methods) {
  command
      ->add_option("--methods", methods,
                   "run only these methods, given by name or kind:\n"
                   "fem,theory")
      ->delimiter(',');
}

/// Adds --pdf, --figures, --width and --units.
inline void add_report_forms(CLI::App* command, ReportForms& forms) {
  command->add_flag("--pdf", forms.has_pdf,
                    "also print the report to report.pdf, by chromium\n"
                    "or weasyprint");
  command
      ->add_option("--figures", forms.formats,
                   "also draw all figures for a journal, in journal/, in\n"
                   "these formats: pdf,svg,png")
      ->delimiter(',');
  command
      ->add_option("--width", forms.width,
                   "width of a column of the journal, in mm, cm or in")
      ->capture_default_str();
  command
      ->add_option("--units", forms.units,
                   "units of the axes of these figures: physical or\n"
                   "reduced (default: those of the report)")
      ->check(CLI::IsMember({"physical", "reduced"}));
}

/// Adds --quick.
inline void add_quick(CLI::App* command, bool& is_quick) {
  command->add_flag("--quick", is_quick,
                    "apply the overrides of the case's quick.set: a\n"
                    "coarse run that takes minutes");
}

/// Adds --threads.
inline void add_threads(CLI::App* command, int& threads) {
  command
      ->add_option("--threads", threads,
                   "number of threads (default: all cores)")
      ->check(CLI::Range(1, 1024));
}

/// Describes a command: its name, options and help, and the function that does
/// its work.
using AddCommand = void (*)(CommandLine& line);

// The commands, each in its own file. A command is added here, in these two
// places; its help, its manual page and its completion follow from its
// description.
void add_run(CommandLine& line);
void add_bench(CommandLine& line);
void add_report(CommandLine& line);
void add_part_commands(CommandLine& line); ///< plan, merge
void add_check(CommandLine& line);
void add_certify(CommandLine& line);
void add_answer_commands(CommandLine& line); ///< problem, import, board
void add_surface(CommandLine& line);
void add_cache(CommandLine& line);
void add_robustness(CommandLine& line);
void add_small_commands(CommandLine& line);   ///< new, list, schema
void add_inspect_commands(CommandLine& line); ///< describe, diff, hidden ones

/// In the order of the help.
inline constexpr AddCommand all_commands[] = {
    add_run,   add_bench,      add_report,          add_part_commands,
    add_check, add_certify,    add_answer_commands, add_surface,
    add_cache, add_robustness, add_small_commands,  add_inspect_commands};

} // namespace asperity::cli
