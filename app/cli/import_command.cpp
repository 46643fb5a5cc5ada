#include "app/cli/import_command.hpp"

#include "app/cli/certified_field.hpp"
#include "app/methods/continuum_block.hpp"
#include "app/methods/curve_row.hpp"
#include "app/run/provenance_of_run.hpp"
#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "base/read_file.hpp"
#include "cases/reader/case_hash.hpp"
#include "cases/reader/read_case.hpp"
#include "cases/text/case_error.hpp"
#include "cases/text/input_file.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "exchange/mistakes.hpp"
#include "exchange/submission.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using exchange::Problem;
using exchange::Submission;
using exchange::SubmittedLoad;

/// Name of the method in the result: "contactmechanics-1.8.3-default".
std::string method_name(const Submission& submission) {
  std::string name =
      submission.code + "-" + submission.version + "-" + submission.accuracy;
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 &&
        std::string_view("-._").find(letter) == std::string_view::npos)
      letter = '-';
  return name;
}

SurfaceOfCase surface_of(const Problem& problem) {
  const surfaces::Statistics numbers =
      surfaces::statistics({problem.grid, problem.heights});
  SurfaceOfCase surface;
  surface.record.grid = problem.grid;
  surface.record.heights = problem.heights;
  surface.record.rms_height = numbers.rms_height;
  surface.record.rms_slope = numbers.rms_slope;
  surface.record.rms_curvature = numbers.rms_curvature;
  surface.record.skewness = numbers.skewness;
  surface.record.kurtosis = numbers.kurtosis;
  surface.record.highest = numbers.highest;
  surface.scales = {problem.body.contact_modulus, problem.grid.length_x,
                    problem.grid.spacing_x(), numbers.rms_height};
  return surface;
}

/// What one load became: its certificate, the row and maps of the result, and
/// the mistakes that were recognised.
struct ImportedLoad {
  CertifiedField field;
  StepAnswer answer;
  std::vector<std::string> mistakes;
};

/// The row and the gap that follow from a pressure.
StepAnswer answer_of(contact::SurfaceOperator& elasticity,
                     const Problem& problem, const SurfaceOfCase& surface,
                     const CertifiedField& field, const SubmittedLoad& load) {
  contact::ContactSolution solution;
  solution.pressure = load.pressure;
  for (double& value : solution.pressure)
    value = std::max(value, 0.0);
  solution.displacement.resize(load.pressure.size());
  elasticity.displacement(solution.pressure, solution.displacement);
  solution.nominal_pressure = field.nominal_pressure;
  solution.mean_gap = field.check.mean_gap;
  solution.gap_error = field.check.complementarity;
  solution.iterations = load.iterations;
  solution.converged = true;
  solution.gap.reserve(load.pressure.size());
  for (std::size_t i = 0; i < load.pressure.size(); ++i)
    solution.gap.push_back(solution.mean_gap + solution.displacement[i] -
                           problem.heights[i]);
  StepAnswer answer =
      observe(std::move(solution),
              {{},
               0.0,
               results::halfspace_area_coefficients,
               rim_modulus(problem.body, problem.grid.spacing_x())},
              surface);
  answer.row.step = static_cast<int>(load.load);
  answer.row.certified_gap_error = field.bounds.error;
  answer.row.cpu_time = std::isfinite(load.cpu_time) ? load.cpu_time : 0.0;
  return answer;
}

/// Compares what the authors state with what the field says. Their mean gap is
/// already compared with its bounds.
void add_claims(const SubmittedLoad& load, CertifiedField& field) {
  const auto add = [&](const char* name, double claimed, double found,
                       double allowed) {
    if (std::isfinite(claimed))
      field.claims.push_back(
          {fmt::format("the {} is {:.6g} (from the field {:.6g})", name,
                       claimed, found),
           std::abs(claimed - found) <= allowed * found});
  };
  add("contact area fraction", load.area_fraction, field.check.area_fraction,
      1e-2);
  add("elastic energy [J/m^2]", load.elastic_energy, field.check.elastic_energy,
      1e-3);
}

ImportedLoad imported(contact::SurfaceOperator& elasticity,
                      const Problem& problem, const SurfaceOfCase& surface,
                      const Submission& submission, const SubmittedLoad& load) {
  require_grid(problem, load);
  ImportedLoad done;
  done.mistakes = recognised_mistakes(elasticity, problem, load);
  if (!(std::ranges::max(load.pressure) > 0.0))
    throw cases::CaseError(fmt::format(
        "{}: no pressure is > 0, so that nothing can be certified: {}",
        load.file.string(), fmt::join(done.mistakes, "; ")));
  done.field = certified(elasticity,
                         {problem.heights, 0.0, problem.loads[load.load],
                          load.pressure, load.mean_gap},
                         surface.record.rms_height, submission.claimed_error);
  done.field.method = method_name(submission);
  done.field.step = static_cast<int>(load.load);
  done.field.contact_modulus = problem.body.contact_modulus;
  add_claims(load, done.field);
  done.answer = answer_of(elasticity, problem, surface, done.field, load);
  return done;
}

/// The same problem as a case, if the problem's folder has it.
results::CaseInfo case_info(const Problem& problem, const fs::path& folder) {
  results::CaseInfo info{problem.name, problem.title, "", "",
                         problem.body.contact_modulus};
  const fs::path file = folder / "case.toml";
  if (fs::exists(file)) {
    info.text = cases::read_input_file(file, cases::largest_case_file);
    info.hash =
        cases::case_hash(cases::read_case_text(info.text, file.string()));
  }
  return info;
}

std::string description_of(const Submission& submission) {
  return fmt::format("{} {} ({} accuracy): {}. {}; {}", submission.code,
                     submission.version, submission.accuracy, submission.method,
                     fmt::join(submission.authors, ", "), submission.licence);
}

void write_import(const fs::path& folder, const results::CaseInfo& info,
                  const Submission& submission, const SurfaceOfCase& surface,
                  std::vector<ImportedLoad>& loads) {
  results::ResultWriter writer(folder, info);
  writer.record_provenance({{"imported code", submission.code},
                            {"imported version", submission.version},
                            {"imported accuracy", submission.accuracy},
                            {"imported machine", submission.machine}});
  writer.record_surface(0, surface.record);
  const std::string name = method_name(submission);
  writer.begin_method(name, "submission", description_of(submission));
  for (ImportedLoad& load : loads) {
    results::Fields fields;
    fields.step = load.answer.row.step;
    fields.nominal_pressure = load.answer.row.nominal_pressure;
    fields.pressure = std::move(load.answer.pressure);
    fields.gap = std::move(load.answer.gap);
    writer.append_step_with_fields(name, 0, load.answer.row,
                                   surface.record.grid, std::move(fields));
  }
  int step = static_cast<int>(loads.size());
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

nlohmann::ordered_json json_of(const Submission& submission,
                               const std::vector<ImportedLoad>& loads,
                               const results::Result& result) {
  using Json = nlohmann::ordered_json;
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json list = Json::array();
  for (const ImportedLoad& load : loads) {
    Json one = certificate_json(load.field);
    one["mistakes"] = load.mistakes;
    const auto& points = result.methods.front().realizations.front().points;
    const auto row =
        std::ranges::find(points, load.field.step, &results::CurvePoint::step);
    one["area_fraction [1]"] = number(row->area_fraction);
    one["area_fraction_corrected [1]"] = number(row->area_fraction_corrected);
    one["area_fraction_fit [1]"] = number(row->area_fraction_fit);
    one["area_fraction_moment [1]"] = number(row->area_fraction_moment);
    one["contact_stiffness [Pa/m]"] = number(row->contact_stiffness);
    one["cpu_time [s]"] = number(row->cpu_time);
    one["iterations"] = row->iterations;
    list.push_back(std::move(one));
  }
  return {{"problem", submission.problem},
          {"code", submission.code},
          {"version", submission.version},
          {"method", submission.method},
          {"accuracy", submission.accuracy},
          {"authors", submission.authors},
          {"licence", submission.licence},
          {"machine", submission.machine},
          {"claimed_error [h_rms]", submission.claimed_error},
          {"is_certified", !loads.empty()},
          {"loads", list}};
}

} // namespace

ExitCode import_submission(const ImportCommand& command) {
  const Problem problem = exchange::read_problem(command.problem);
  const Submission submission =
      exchange::read_submission(command.submission, problem);
  const SurfaceOfCase surface = surface_of(problem);
  contact::FourierOperator elasticity =
      contact::halfspace_operator(problem.grid, problem.body);
  fmt::print("{}: {} {} ({})\n", problem.name, submission.code,
             submission.version, submission.accuracy);
  if (submission.loads.empty())
    fmt::print("as submitted: a curve without pressure fields has no "
               "certificate and is not ranked\n");
  else
    fmt::print("{}", certificate_head());
  std::vector<ImportedLoad> loads;
  bool is_sound = true;
  for (const SubmittedLoad& load : submission.loads) {
    loads.push_back(imported(elasticity, problem, surface, submission, load));
    const ImportedLoad& done = loads.back();
    fmt::print("{}{}", certificate_line(done.field), broken_claims(done.field));
    for (const std::string& mistake : done.mistakes)
      fmt::print("  {}: {}\n", load.file.filename().string(), mistake);
    is_sound = is_sound && all_hold(done.field) && done.mistakes.empty();
  }
  std::ranges::sort(loads, {},
                    [](const ImportedLoad& load) { return load.field.step; });
  const fs::path folder =
      command.out.empty()
          ? fs::path("out") / (method_name(submission) + "-" + problem.name)
          : fs::path(command.out);
  const FolderLock lock(folder, "import " + command.submission);
  write_import(folder, case_info(problem, command.problem), submission, surface,
               loads);
  write_file_atomically(
      folder / "certificate.json",
      json_of(submission, loads, results::read_result(folder)).dump(2) + "\n");
  fmt::print("result: {}\n", (folder / "result.h5").string());
  return is_sound ? exit_good : exit_expectation_failed;
}

} // namespace asperity::app
