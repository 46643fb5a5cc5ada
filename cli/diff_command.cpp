#include "cli/diff_command.hpp"

#include "input/input_error.hpp"
#include "methods/cache/case_keys.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/trial_read.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/difference.hpp"
#include "run/output.hpp"
#include "run/result_outputs.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::cli {
namespace {

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

} // namespace

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

} // namespace asperity::cli
