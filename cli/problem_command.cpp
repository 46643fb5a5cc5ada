#include "cli/problem_command.hpp"

#include "base/folder_lock.hpp"
#include "base/shown_number.hpp"
#include "exchange/answers/own_reference.hpp"
#include "exchange/answers/reference_answers.hpp"
#include "exchange/problem_folder.hpp"
#include "input/input_error.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/output_folder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>

namespace asperity::cli {
namespace {

void print_answers(const exchange::AnsweredProblem& answered) {
  const double height = answered.problem.rms_height;
  fmt::print("method {}, {} by {} points\n{:>12} {:>12} {:>9} {:>10} {:>12} "
             "{:>9}\n",
             answered.method, answered.problem.grid.points_x,
             answered.problem.grid.points_y, "p_0 [Pa]", "u/h_rms", "certified",
             "area", "u, continuum", "estimated");
  for (std::size_t i = 0; i < answered.answers.size(); ++i) {
    const exchange::ProblemAnswer& answer = answered.answers[i];
    fmt::print("{:>12.5g} {:>12.8f} {:>9.1e} {:>10.6f}",
               answer.nominal_pressure, Shown{answer.mean_gap / height},
               answer.mean_gap_error / height, answer.area_fraction);
    if (i < answered.continuum.size())
      fmt::print(" {:>12.8f} {:>9.1e}",
                 Shown{answered.continuum[i].mean_gap / height},
                 answered.continuum[i].mean_gap_error / height);
    fmt::print("\n");
  }
}

} // namespace

run::ExitCode write_problem_of(const ProblemCommand& command) {
  const run::NamedCases named =
      run::read_named_cases(command.contact_case, command.overrides);
  if (named.cases.size() != 1)
    throw input::InputError(fmt::format(
        "{} is a collection; name one of its parts", command.contact_case));
  const run::ReadCase& read = named.cases.front();
  const std::filesystem::path folder =
      command.out.empty()
          ? std::filesystem::path("out") / read.found.name / "problem"
          : std::filesystem::path(command.out);
  const FolderLock lock(folder, "problem " + read.found.name);
  for (const std::filesystem::path& file : run::files_in(folder))
    for (const std::filesystem::path& input :
         run::input_files(read.contact_case))
      if (std::filesystem::equivalent(file, input))
        throw input::InputError(fmt::format(
            "{}: is read by this command, so that its folder cannot be "
            "written; name another --out",
            file.string()));
  exchange::require_own_problem(folder);
  std::optional<exchange::AnsweredProblem> answered;
  try {
    answered = exchange::answered_problem(read.contact_case, command.method);
  } catch (const exchange::NoAnswer& error) {
    fmt::print(stderr, "{}: {}\n", read.contact_case.path, error.what());
    return run::exit_not_converged;
  }
  std::optional<exchange::ProblemMesh> mesh;
  if (command.has_mesh)
    mesh = exchange::problem_mesh(answered->problem, answered->block);
  // A map or spectrum that the case names is not part of the problem.
  const bool is_complete = read.contact_case.surface.file.empty();
  exchange::write_certified_problem(*answered,
                                    is_complete ? read.contact_case.text : "",
                                    folder, mesh ? &*mesh : nullptr);
  print_answers(*answered);
  if (mesh)
    fmt::print("mesh: {} by {} by {} cells for {}, {} nodes\n", mesh->cells_x,
               mesh->cells_y, mesh->layers.size(),
               mesh->element == mechanics::Element::q1 ? "Q1" : "Q2",
               mesh->mesh.vertices.size());
  fmt::print("problem: {}\n", folder.string());
  return run::exit_good;
}

} // namespace asperity::cli
