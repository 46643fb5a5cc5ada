#include "app/cli/diff_command.hpp"

#include "app/asked/asked_cases.hpp"
#include "app/cache/case_keys.hpp"
#include "app/run/difference.hpp"
#include "app/run/output.hpp"
#include "app/run/result_outputs.hpp"
#include "input/input_error.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/trial_read.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::app {
namespace {

ComparedSide read_side(const std::string& word) {
  ComparedSide side;
  side.path = word;
  if (is_result(word)) {
    results::require_readable(word);
    side.result = results::read_result(word, results::MapsInFile::large);
    side.inputs = results::inputs_of(*side.result);
    side.inputs.erase("program"); // belongs to the build
    if (!side.result->case_text.empty())
      side.contact_case = reports::case_of(*side.result);
    return side;
  }
  const Asked asked = read_asked(word);
  if (!asked.found.collection.empty())
    throw input::InputError(
        word + " is a collection of " + std::to_string(asked.cases.size()) +
        " cases; compare its parts, such as " + asked.cases.front().found.name);
  side.contact_case = asked.cases.front().contact_case;
  side.inputs = input_hashes(*side.contact_case);
  return side;
}

} // namespace

ExitCode diff_two(const DiffCommand& command) {
  const ComparedSide one = read_side(command.one);
  const ComparedSide other = read_side(command.other);
  const Difference difference = difference_of(one, other, command.tolerance);
  if (wants_json())
    emit_answer(difference_json(difference, command.tolerance));
  else
    fmt::print("{} | {}\n{}", one.path, other.path,
               difference_text(difference, command.tolerance));
  return difference.is_any() ? exit_expectation_failed : exit_good;
}

} // namespace asperity::app
