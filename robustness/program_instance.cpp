#include "base/atomic_file.hpp"
#include "base/child_process.hpp"
#include "base/temporary_folder.hpp"
#include "results/result_reader.hpp"
#include "robustness/kinds.hpp"
#include "robustness/verify_observables.hpp"
#include "robustness/written_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace asperity::robustness {
namespace {

namespace fs = std::filesystem;

ChildAnswer run_case_in(const fs::path& folder, const fs::path& program,
                        const Instance& instance) {
  ChildCommand command;
  command.folder = folder;
  if (instance.path == Path::two_ranks)
    command.words = {"mpirun", "-np", "2", "--oversubscribe"};
  for (const char* word : {program.c_str(), "run", "case.toml", "--out", "out",
                           "--no-cache", "--threads"})
    command.words.emplace_back(word);
  command.words.push_back(std::to_string(instance.threads));
  if (instance.path != Path::report)
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
std::optional<Failure> verify_result(const Instance& instance,
                                     const results::Result& result,
                                     const InstanceReport& report) {
  if (result.status != "complete" || result.methods.size() != 1 ||
      result.methods[0].realizations.size() != 1)
    return Failure{"program",
                   "the result does not consist of one complete curve"};
  const auto& rows = result.methods[0].realizations[0].points;
  const InstanceSurface surface = surface_of(instance, grid_of(instance));
  if (rows.size() != targets_of(instance, surface.height_scale).size())
    return Failure{"program",
                   fmt::format("the curve has {} rows", rows.size())};
  for (const results::CurvePoint& row : rows)
    if (auto failure = verify_row(row))
      return failure;
  const double gap = rows[load_step(instance)].mean_gap / surface.height_scale;
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

void run_program(const Instance& instance, const fs::path& program,
                 InstanceReport& report) {
  const TemporaryFolder scratch("asperity-robustness");
  write_file_atomically(scratch.path() / "map.txt", map_text_of(instance));
  write_file_atomically(scratch.path() / "case.toml", case_text_of(instance));
  const ChildAnswer answer = run_case_in(scratch.path(), program, instance);
  constexpr int bad_input = 2;
  if (answer.end.exit_code == bad_input)
    throw std::domain_error(answer.output);
  if (answer.end.exit_code != 0)
    return fail(report, {"program", answer.end.failure + ": " + answer.output});
  if (instance.family == Family::flawed)
    return fail(report,
                {"refusal", name_of(instance.flaw) + " was not refused"});
  const fs::path folder = scratch.path() / "out";
  if (const auto failure =
          verify_result(instance, results::read_result(folder), report))
    return fail(report, *failure);
  if (instance.path == Path::report)
    if (const auto failure = verify_report(folder, answer.output))
      fail(report, *failure);
}

} // namespace asperity::robustness
