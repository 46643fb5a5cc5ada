#include "base/child_process.hpp"
#include "results/result_reader.hpp"
#include "suite/robustness/case_pass.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace asperity::robustness {
namespace {

namespace fs = std::filesystem;

ChildAnswer answer_of(const ProgramRun& run) {
  ChildCommand command;
  command.folder = run.folder;
  if (run.path == "two-ranks")
    command.words = {"mpirun", "-np", "2", "--oversubscribe"};
  for (const char* word : {run.program.c_str(), "run", "case.toml", "--out",
                           "out", "--no-cache", "--threads"})
    command.words.emplace_back(word);
  command.words.push_back(std::to_string(run.threads));
  if (run.path != "report")
    command.words.emplace_back("--no-report");
  command.environment = environment_for_mpi();
  command.environment.emplace_back("OMP_NUM_THREADS=1");
  return run_child(command);
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Verifies that every row lies in its range and that, at the load of the
/// instance, the mean gap agrees with that of the library. Each of the two has
/// the tolerance as its error.
std::optional<Failure> verify_result(const results::Result& result,
                                     const InstanceReport& report) {
  if (result.status != "complete" || result.methods.size() != 1 ||
      result.methods[0].realizations.empty())
    return Failure{"program", "the result does not consist of complete curves "
                              "of one method"};
  for (const results::Curve& curve : result.methods[0].realizations)
    for (const results::CurvePoint& row : curve.points)
      if (auto failure = verify_row(row))
        return failure;
  const auto& rows = result.methods[0].realizations[0].points;
  if (rows.empty())
    return Failure{"program", "the curve has no rows"};
  const double gap = rows[rows.size() / 2].mean_gap / report.gap_scale;
  if (std::abs(gap - report.reduced_gap) <= 2.0 * report.reduced_tolerance)
    return {};
  return Failure{
      "program",
      fmt::format(
          "mean gap {:.17g} h_rms, but the library gives {:.17g} +- {:.2g}",
          gap, report.reduced_gap, 2.0 * report.reduced_tolerance)};
}

/// Verifies that the parts of a report exist and are complete.
std::optional<Failure> verify_report(const fs::path& folder,
                                     const std::string& output) {
  if (output.find("not drawn") != std::string::npos)
    return Failure{"report", output};
  if (text_of(folder / "report.html").find("</html>") == std::string::npos)
    return Failure{"report", "report.html is incomplete"};
  for (const char* name : {"curves.csv", "summary.json"})
    if (text_of(folder / name).empty())
      return Failure{"report", std::string(name) + " is empty"};
  return {};
}

} // namespace

void run_program(const ProgramRun& run, InstanceReport& report) {
  const ChildAnswer answer = answer_of(run);
  constexpr int bad_input = 2;
  if (answer.end.exit_code == bad_input)
    throw std::domain_error(answer.output);
  if (answer.end.exit_code != 0)
    return fail(report, {"program", answer.end.failure + ": " + answer.output});
  if (run.is_flawed)
    return fail(report, {"refusal", "a flaw was not refused"});
  const fs::path folder = run.folder / "out";
  if (const auto failure = verify_result(results::read_result(folder), report))
    return fail(report, *failure);
  if (run.path == "report")
    if (const auto failure = verify_report(folder, answer.output))
      fail(report, *failure);
}

} // namespace asperity::robustness
