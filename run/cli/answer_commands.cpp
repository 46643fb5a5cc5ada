// The commands that exchange problems and answers with other programs: problem,
// import and board; certify_command.cpp has certify.
#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "base/json.hpp"
#include "base/shown_number.hpp"
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/reader/case_hash.hpp"
#include "input/reader/read_case.hpp"
#include "reports/pages/report.hpp"
#include "results/result_writer.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/command_line.hpp"
#include "run/new_output.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"
#include "suite/exchange/answers/imported_answer.hpp"
#include "suite/exchange/answers/own_reference.hpp"
#include "suite/exchange/answers/reference_answers.hpp"
#include "suite/exchange/board/board_site.hpp"
#include "suite/exchange/problem_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace asperity::cli {
namespace {

/// Options of `asperity problem`.
struct ProblemCommand {
  std::string contact_case; ///< case file, folder or shipped case
  std::vector<std::string> overrides;
  std::string method; ///< whose block is pressed; empty: the first suitable one
  std::string out;    ///< folder; empty: out/<case>/problem
  bool has_mesh = false; ///< whether the block is handed out as cells, too
};

void print_path(const exchange::AnsweredProblem& answered) {
  const exchange::Problem& problem = answered.problem;
  fmt::print("method {}, {} by {} points\n{:>4} {:>12} {:>12} {:>10} {:>12}\n",
             answered.method, problem.grid.points_x, problem.grid.points_y,
             "step", "u/h_rms", "p_0 [Pa]", "area", "U/w");
  for (std::size_t i = 0; i < answered.answers.size(); ++i) {
    const exchange::ProblemAnswer& answer = answered.answers[i];
    fmt::print("{:>4} {:>12.6f} {:>+12.5g} {:>10.6f} {:>+12.8f}\n", i,
               answer.mean_gap / problem.rms_height,
               Shown{answer.nominal_pressure}, answer.area_fraction,
               Shown{answer.energy / problem.adhesion->work_of_adhesion});
  }
}

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

/// Writes the folder that suite/exchange/problem_folder.hpp describes.
/// @return  exit_not_converged if a load has no answer; nothing is written then
/// @throws input::InputError  the case is invalid, is a collection, or has no
///                            method with a surface operator
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
  (answered->problem.adhesion ? print_path : print_answers)(*answered);
  if (mesh)
    fmt::print("mesh: {} by {} by {} cells for {}, {} nodes\n", mesh->cells_x,
               mesh->cells_y, mesh->layers.size(),
               mesh->element == mechanics::Element::q1 ? "Q1" : "Q2",
               mesh->mesh.vertices.size());
  fmt::print("problem: {}\n", folder.string());
  return run::exit_good;
}

/// Options of `asperity import`.
struct ImportCommand {
  std::string submission; ///< folder with submission.toml
  std::string problem;    ///< folder with problem.json
  std::string out;        ///< folder; empty: out/<code>-<problem>
};

namespace fs = std::filesystem;
using exchange::Problem;
using exchange::Submission;

/// The same problem as a case, if the problem's folder has it.
/// @throws input::InputError  the case is another problem
results::CaseInfo case_info(const Problem& problem,
                            const methods::SurfaceOfCase& surface,
                            const fs::path& folder) {
  results::CaseInfo info{problem.name, problem.title, "", "",
                         problem.body.contact_modulus};
  const fs::path file = folder / "case.toml";
  if (fs::exists(fs::symlink_status(file))) {
    input::require_own_file(folder, file);
    info.text = input::read_input_file(file, input::largest_text_file);
    info.hash =
        cases::case_hash(cases::read_case_text(info.text, file.string()));
    results::Result stated;
    stated.path = (folder / "problem.json").string();
    stated.case_text = info.text;
    stated.contact_modulus = problem.body.contact_modulus;
    stated.surfaces.resize(1);
    stated.surfaces.front().grid = surface.record.grid;
    reports::case_of(stated); // what cannot be reported is not written
  }
  return info;
}

std::string description_of(const Submission& submission) {
  return fmt::format("{} {} ({} accuracy): {}. {}; {}", submission.code,
                     submission.version, submission.accuracy, submission.method,
                     fmt::join(submission.authors, ", "), submission.licence);
}

/// What a result without its case does not say of the body; empty for the
/// periodic half-space, which E* determines.
std::string other_body(const Problem& problem) {
  return problem.adhesion               ? exchange::attracting_faces
         : !problem.is_periodic()       ? "free boundaries"
         : !problem.body.is_halfspace() ? "layers or a finite thickness"
                                        : "";
}

void write_import(const fs::path& folder, const results::CaseInfo& info,
                  const Problem& problem, const methods::SurfaceOfCase& surface,
                  exchange::ImportedAnswer& answer) {
  const Submission& submission = answer.submission;
  const std::string& name = answer.method;
  results::ResultWriter writer(folder, info);
  writer.record_provenance({{"imported code", submission.code},
                            {"imported version", submission.version},
                            {"imported accuracy", submission.accuracy},
                            {"imported machine", submission.machine}});
  if (const std::string body = other_body(problem); !body.empty())
    writer.record_provenance({{exchange::imported_body, body}});
  writer.record_surface(0, surface.record);
  writer.begin_method(name, "submission", description_of(submission));
  for (exchange::ImportedLoad& load : answer.loads) {
    results::Fields fields;
    fields.step = load.answer.row.step;
    fields.nominal_pressure = load.answer.row.nominal_pressure;
    fields.pressure = std::move(load.answer.pressure);
    fields.gap = std::move(load.answer.gap);
    writer.append_step_with_fields(name, 0, load.answer.row,
                                   surface.record.grid, fields);
  }
  int step = static_cast<int>(answer.loads.size());
  for (const exchange::SubmittedRow& row : submission.curve) {
    results::CurvePoint point;
    point.step = step++;
    point.nominal_pressure = row.nominal_pressure;
    point.mean_gap = row.mean_gap;
    point.area_fraction = row.area_fraction;
    point.area_fraction_corrected = not_a_number;
    point.contact_stiffness = not_a_number;
    point.elastic_energy = not_a_number;
    point.contact_perimeter = not_a_number;
    writer.append_step(name, 0, point);
  }
  writer.finish("complete");
}

/// Prints the table, and what is wrong with each field below its line.
void print_answer(const Problem& problem,
                  const exchange::ImportedAnswer& answer) {
  const Submission& submission = answer.submission;
  const std::size_t width = answer.method.size();
  fmt::print("{}: {} {} ({})\n", problem.name, submission.code,
             submission.version, submission.accuracy);
  if (answer.loads.empty())
    fmt::print("as submitted: a curve without pressure fields has no "
               "certificate and is not ranked\n");
  else
    fmt::print("{}", (problem.adhesion ? exchange::adhesive_head
                                       : exchange::certificate_head)(width));
  for (const exchange::ImportedLoad& load : answer.loads) {
    fmt::print("{}{}",
               load.adhesive ? exchange::adhesive_line(*load.adhesive, problem,
                                                       load.field, width)
                             : exchange::certificate_line(load.field, width),
               exchange::broken_claims(load.field));
    for (const std::string& mistake : load.mistakes)
      fmt::print("  {}: {}\n", load.file, mistake);
  }
}

/// Certifies each field, names typical mistakes and the claims that do not
/// hold, and writes result.h5 and certificate.json.
/// @return  exit_expectation_failed if there is a mistake or a broken claim
/// @throws input::InputError  the problem or the submission is invalid
run::ExitCode import_submission(const ImportCommand& command) {
  const Problem problem = exchange::read_problem(command.problem);
  const methods::SurfaceOfCase surface = exchange::surface_of(problem);
  exchange::ImportedAnswer answer =
      exchange::import_answer(command.submission, problem, surface);
  print_answer(problem, answer);
  const fs::path folder =
      command.out.empty()
          ? fs::path("out") / (answer.method + "-" + problem.name)
          : fs::path(command.out);
  std::vector<fs::path> inputs = run::files_in(command.problem);
  for (fs::path& file : run::files_in(command.submission))
    inputs.push_back(std::move(file));
  const run::OutputFolder lock(folder, "import " + command.submission,
                               run::result_outputs(), inputs);
  run::NewOutput output(folder, false);
  write_import(output.place(), case_info(problem, surface, command.problem),
               problem, surface, answer);
  const std::string json =
      text_of_json(exchange::answer_json(answer), 2) + "\n";
  write_file_atomically(output.place() / "certificate.json", json);
  output.replace();
  if (run::wants_json())
    run::emit_answer(json);
  fmt::print("result: {}\n", (folder / "result.h5").string());
  return answer.is_sound() ? run::exit_good : run::exit_expectation_failed;
}

/// Options of `asperity board`.
struct BoardCommand {
  std::string folder; ///< problems and submissions, see board/board.hpp
  std::vector<std::string> answers; ///< folders of further answers
  std::string out; ///< folder of the site; empty: out/board-site
};

/// @return  exit_expectation_failed if a submission failed
/// @throws input::InputError  there are no submissions, or a problem is invalid
run::ExitCode build_board(const BoardCommand& command) {
  const std::filesystem::path site =
      command.out.empty() ? std::filesystem::path("out/board-site")
                          : std::filesystem::path(command.out);
  const run::OutputFolder lock(site, "board " + command.folder,
                               {"index.html", "board.json", "figures/"});
  const std::vector<exchange::BoardProblem> board = exchange::read_board(
      command.folder, site, {command.answers.begin(), command.answers.end()});
  exchange::write_site(board, site);
  fmt::print("board: {}\n", (site / "index.html").string());
  if (run::wants_json())
    run::emit_answer(run::json_of_file(site / "board.json"));
  const bool has_failed =
      std::ranges::any_of(board, [](const exchange::BoardProblem& problem) {
        return std::ranges::any_of(
            problem.entries, [](const exchange::BoardEntry& entry) {
              return entry.state == exchange::BoardEntry::State::failed;
            });
      });
  return has_failed ? run::exit_expectation_failed : run::exit_good;
}

void add_problem(CommandLine& line) {
  auto [command, problem] = line.add<ProblemCommand>(
      "problem",
      "Write the contact problem of a case as a folder\n"
      "that any other program can read: problem.json,\n"
      "heights, checksums and reference answers.",
      write_problem_of);
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
  add_quiet(command, line.output);
  line.on_cases.insert("problem");
  add_example(command, "problem wave-1d --out wave-1d-problem");
}

void add_import(CommandLine& line) {
  auto [command, import_answer] =
      line.add<ImportCommand>("import",
                              "Read another program's answer to a problem,\n"
                              "certify it, name typical mistakes and write it\n"
                              "as a result; exit 1 if a claim does not hold.",
                              import_submission);
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
  add_quiet(command, line.output);
  add_json(command, line.output, "certificate.json");
  add_example(command, "import answers/mycode --problem wave-1d-problem");
}

void add_board(CommandLine& line) {
  auto [command, board] =
      line.add<BoardCommand>("board",
                             "Certify the answers of many codes to problems\n"
                             "and build a static site that ranks them; exit 1\n"
                             "if one is not certified.",
                             build_board);
  command
      ->add_option("folder", board.folder,
                   "folder with problems and submissions")
      ->required();
  command->add_option("answer", board.answers,
                      "folders of your answers: the site then shows their\n"
                      "problems only, with your answers among the others");
  command->add_option("--out", board.out,
                      "folder of the site (default: out/board-site)");
  add_quiet(command, line.output);
  add_json(command, line.output, "board.json");
  add_example(command, "board cases/board --out site");
}

} // namespace

void add_answer_commands(CommandLine& line) {
  add_problem(line);
  add_import(line);
  add_board(line);
}

} // namespace asperity::cli
