#include "cli/import_command.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "base/special_numbers.hpp"
#include "cases/reader/case_hash.hpp"
#include "cases/reader/read_case.hpp"
#include "exchange/answers/imported_answer.hpp"
#include "input/input_file.hpp"
#include "reports/pages/report.hpp"
#include "results/result_writer.hpp"
#include "run/new_output.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace asperity::cli {
namespace {

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
  return !problem.is_periodic ? "free boundaries"
         : std::isfinite(problem.body.thickness) || !problem.body.layers.empty()
             ? "layers or a finite thickness"
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
  fmt::print("{}: {} {} ({})\n", problem.name, submission.code,
             submission.version, submission.accuracy);
  if (answer.loads.empty())
    fmt::print("as submitted: a curve without pressure fields has no "
               "certificate and is not ranked\n");
  else
    fmt::print("{}", exchange::certificate_head(answer.method.size()));
  for (const exchange::ImportedLoad& load : answer.loads) {
    fmt::print("{}{}",
               exchange::certificate_line(load.field, answer.method.size()),
               exchange::broken_claims(load.field));
    for (const std::string& mistake : load.mistakes)
      fmt::print("  {}: {}\n", load.file, mistake);
  }
}

} // namespace

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

} // namespace asperity::cli
