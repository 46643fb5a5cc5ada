#include "suite/exchange/answers/imported_answer.hpp"

#include "base/array_memory.hpp"
#include "base/field_sums.hpp"
#include "base/json.hpp"
#include "base/plain_text.hpp"
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "mechanics/adhesion_scales.hpp"
#include "results/observables/contact_stiffness.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/continuum_block.hpp"
#include "run/methods/curve_row.hpp"
#include "run/methods/methods.hpp"
#include "suite/exchange/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;

/// Name of the method in the result: "contactmechanics-1.8.3-default".
std::string method_name(const Submission& submission) {
  std::string name = good_name(submission.code + "-" + submission.version +
                               "-" + submission.accuracy);
  std::ranges::replace_if(
      name, [](char letter) { return letter == ' ' || letter == '+'; }, '-');
  return name;
}

} // namespace

methods::SurfaceOfCase surface_of(const Problem& problem) {
  return methods::surface_of_map({problem.grid, problem.heights},
                                 problem.body.contact_modulus);
}

namespace {

/// The row and the gap that follow from a pressure.
methods::StepAnswer answer_of(contact::SurfaceOperator& elasticity,
                              const Problem& problem,
                              const methods::SurfaceOfCase& surface,
                              const CertifiedField& field,
                              const SubmittedLoad& load) {
  contact::ContactSolution solution;
  solution.pressure = load.pressure;
  for (double& value : solution.pressure)
    value = std::max(value, 0.0);
  solution.displacement.resize(load.pressure.size());
  elasticity.displacement(solution.pressure, solution.displacement);
  // The load follows from the pressure if that is clearly another one.
  const double load_found = mean(solution.pressure);
  solution.nominal_pressure =
      std::abs(load_found - field.nominal_pressure) <=
              0.5 * claimed_load_error * field.nominal_pressure
          ? field.nominal_pressure
          : load_found;
  solution.mean_gap = field.check.mean_gap;
  solution.iterations = load.iterations;
  solution.converged = true;
  solution.gap.reserve(load.pressure.size());
  // The displacement of a periodic surface has no mean.
  const double separation =
      solution.mean_gap -
      (problem.is_periodic() ? 0.0 : mean(solution.displacement));
  for (std::size_t i = 0; i < load.pressure.size(); ++i) {
    const double gap =
        separation + solution.displacement[i] - problem.heights[i];
    solution.gap.push_back(gap);
    const double violation = solution.pressure[i] > 0.0 ? std::abs(gap) : -gap;
    solution.gap_error = std::max(solution.gap_error, violation);
  }
  return methods::observe(
      std::move(solution),
      {{},
       0.0,
       problem.is_periodic() ? results::halfspace_area_coefficients
                             : results::free_area_coefficients,
       methods::boundary_modulus(problem.body, problem.grid.spacing_x())},
      surface);
}

/// The state, its energy and its claims, of a problem with adhesion.
void import_state(contact::SurfaceOperator& elasticity, const Problem& problem,
                  const methods::SurfaceOfCase& surface,
                  const Submission& submission, const SubmittedLoad& load,
                  ImportedLoad& done) {
  const mechanics::ContactInterface& law = *problem.adhesion;
  contact::ContactSolution state;
  try {
    state = adhesive_state(elasticity, problem, problem.loads[load.load],
                           load.pressure);
    done.adhesive = adhesive_answer(elasticity, problem, state);
  } catch (const input::InputError& error) {
    throw input::InputError(
        fmt::format("{}: {}", load.file.string(), error.what()));
  }
  state.iterations = load.iterations;
  done.field.nominal_pressure = state.nominal_pressure;
  done.field.mean_gap = state.mean_gap;
  add_adhesive_claims(*done.adhesive, problem, submission.claimed_error,
                      load.energy, done.field);
  methods::Observation observation;
  observation.contact_modulus = problem.body.contact_modulus;
  observation.criterion = {mechanics::ContactField::gap};
  observation.adhesion = law;
  observation.grid_number = law.grid_number(
      problem.body.contact_modulus,
      mechanics::adhesion_scales(surface.scales, problem.grid).spacing);
  done.answer = methods::observe(std::move(state), observation, surface);
  done.answer.row.is_unloading =
      load.load > 0 && problem.loads[load.load] > problem.loads[load.load - 1];
}

/// The bounds and the row of a problem without adhesion.
void import_field(contact::SurfaceOperator& elasticity, const Problem& problem,
                  const methods::SurfaceOfCase& surface,
                  const Submission& submission, const SubmittedLoad& load,
                  ImportedLoad& done) {
  done.mistakes = recognised_mistakes(elasticity, problem, load);
  if (!(std::ranges::max(load.pressure) > 0.0))
    throw input::InputError(fmt::format(
        "{}: no pressure is > 0, so that nothing can be certified: {}",
        load.file.string(), fmt::join(done.mistakes, "; ")));
  done.field = certified(elasticity,
                         {problem.heights, 0.0, problem.loads[load.load],
                          load.pressure, load.mean_gap},
                         surface.record.rms_height, submission.claimed_error);
  add_claims(load.area_fraction, load.elastic_energy, done.field);
  done.answer = answer_of(elasticity, problem, surface, done.field, load);
  done.answer.row[columns::certified_gap_error] = done.field.error_of_field();
}

ImportedLoad imported(contact::SurfaceOperator& elasticity,
                      const Problem& problem,
                      const methods::SurfaceOfCase& surface,
                      const Submission& submission, const SubmittedLoad& load) {
  ImportedLoad done;
  done.file = load.file.filename().string();
  done.cpu_time_low = load.cpu_time_low;
  done.cpu_time_high = load.cpu_time_high;
  done.peak_memory = load.peak_memory;
  (problem.adhesion ? import_state : import_field)(elasticity, problem, surface,
                                                   submission, load, done);
  done.field.method = method_name(submission);
  done.field.step = static_cast<int>(load.load);
  done.field.contact_modulus = problem.body.contact_modulus;
  done.field.rms_height = surface.record.rms_height;
  done.answer.row.step = done.field.step;
  done.answer.row.cpu_time = std::isfinite(load.cpu_time) ? load.cpu_time : 0.0;
  return done;
}

void fill_stiffness(std::vector<ImportedLoad>& loads) {
  std::vector<results::CurvePoint> rows;
  rows.reserve(loads.size());
  for (const ImportedLoad& load : loads)
    rows.push_back(load.answer.row);
  results::fill_contact_stiffness(rows);
  for (std::size_t i = 0; i < loads.size(); ++i)
    loads[i].answer.row = rows[i];
}

} // namespace

bool ImportedLoad::is_sound() const {
  return all_hold(field) && mistakes.empty();
}

bool ImportedAnswer::is_sound() const {
  return std::ranges::all_of(loads, &ImportedLoad::is_sound);
}

std::unique_ptr<contact::SurfaceOperator>
operator_of(const cases::Case& contact_case, const cases::MethodSpec& method,
            const methods::SurfaceOfCase& surface) {
  return methods::MethodFactory(contact_case).operator_of(method, surface, 1);
}

ImportedAnswer import_answer(const fs::path& folder, const Problem& problem,
                             const methods::SurfaceOfCase& surface,
                             const MeshOperator& mesh) {
  ImportedAnswer answer;
  answer.submission = read_submission(folder, problem);
  answer.method = method_name(answer.submission);
  const std::unique_ptr<contact::SurfaceOperator> elasticity =
      surface_operator(problem, problem.grid);
  const std::string& element = answer.submission.element;
  const std::unique_ptr<contact::SurfaceOperator> on_mesh =
      mesh && !element.empty() && !problem.adhesion ? mesh(element) : nullptr;
  for (const SubmittedLoad& load : answer.submission.loads)
    require_grid(problem, load);
  for (SubmittedLoad& load : answer.submission.loads) {
    answer.loads.push_back(
        imported(*elasticity, problem, surface, answer.submission, load));
    if (on_mesh != nullptr)
      answer.loads.back().mesh_error =
          certified(*on_mesh,
                    {problem.heights, 0.0, problem.loads[load.load],
                     load.pressure, not_a_number},
                    surface.record.rms_height, infinity)
              .error_of_field();
    free_memory(load.pressure);
  }
  std::ranges::sort(answer.loads, {},
                    [](const ImportedLoad& load) { return load.field.step; });
  fill_stiffness(answer.loads);
  return answer;
}

nlohmann::ordered_json answer_json(const ImportedAnswer& answer) {
  using Json = nlohmann::ordered_json;
  const Submission& submission = answer.submission;
  Json list = Json::array();
  for (const ImportedLoad& load : answer.loads) {
    Json one = load.adhesive ? adhesive_json(*load.adhesive, load.field)
                             : certificate_json(load.field);
    one["mistakes"] = load.mistakes;
    const results::CurvePoint& row = load.answer.row;
    one["area_fraction [1]"] = row.area_fraction;
    one["area_fraction_corrected [1]"] = row.area_fraction_corrected;
    one["area_fraction_fit [1]"] = row[columns::area_fraction_fit];
    one["area_fraction_moment [1]"] = row[columns::area_fraction_moment];
    one["contact_stiffness [Pa/m]"] = row.contact_stiffness;
    one["cpu_time [s]"] = row.cpu_time;
    one["iterations"] = row.iterations;
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
          {"is_certified", !answer.loads.empty()},
          {"loads", list}};
}

} // namespace asperity::exchange
