#include "run/saved_studies.hpp"

#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "reports/analysis/summary.hpp"
#include "results/types/curve_columns.hpp"
#include "run/methods/methods.hpp"
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace asperity::run {
namespace {

using results::CurvePoint;

/// Requires the key to be in the table of a study that the case does not ask
/// for: its rows without maps would keep answers to other settings.
void require_new_study(const cases::Case& contact_case,
                       const std::string& asked) {
  const std::string table = asked.substr(0, asked.find_first_of(".="));
  std::string allowed;
  for (const cases::StudyKeys* const study : cases::known_studies()) {
    if (!study->tables.empty() && study->name() == table) {
      if (study->is_asked(contact_case))
        throw input::InputError(
            fmt::format("--set: {}: the result has the study [{}] already; "
                        "state other numbers in its case and run it, whose "
                        "steps are kept",
                        asked.substr(0, asked.find('=')), table));
      return;
    }
    if (!study->tables.empty())
      allowed += (allowed.empty() ? "[" : ", [") + study->name() + "]";
  }
  throw input::InputError(
      fmt::format("--set: {} is no key of a study, which alone can be added to "
                  "a result: {}",
                  asked.substr(0, asked.find('=')), allowed));
}

/// Sets the columns of a row by the maps of its step.
void evaluate(studies::Step step, const methods::SurfaceOfCase& surface,
              methods::MethodFactory& factory, CurvePoint& row) {
  step.elasticity = [&] {
    return factory.operator_of(step.method, surface, step.threads);
  };
  CurvePoint answers;
  answers.step = row.step;
  answers.nominal_pressure = row.nominal_pressure;
  answers.mean_gap = row.mean_gap;
  studies::evaluate_studies(step, answers);
  results::state_of_map(answers, surface.record.map.share(step.grid));
  for (const auto& [column, number] : answers.others())
    column->set(row, number);
  if (!answers.note.empty())
    row.add_note(answers.note);
}

/// Evaluates the saved steps of a method.
/// @return  their number
int evaluate_maps(const cases::Case& contact_case,
                  const cases::MethodSpec& method,
                  const methods::SurfaceOfCase& surface,
                  methods::MethodFactory& factory, results::Curve& curve) {
  int evaluated = 0;
  for (const results::Fields& maps : curve.fields) {
    const auto row =
        std::ranges::find(curve.points, maps.step, &CurvePoint::step);
    if (row == curve.points.end() ||
        row->status != results::StepStatus::converged ||
        maps.gap_map().size() != maps.grid.size() || maps.grid.size() == 0)
      continue;
    const std::vector<double> pressure = maps.pressure_map().whole();
    const std::vector<double> gap = maps.gap_map().whole();
    evaluate(studies::step_with_maps(contact_case, method, surface, maps.grid,
                                     pressure, gap),
             surface, factory, *row);
    ++evaluated;
  }
  return evaluated;
}

/// Adds a table that the result does not have. One that cannot be computed is
/// listed with what was skipped.
template <class Make>
void add_table(const std::string& what, const Make& make,
               results::Result& result) {
  try {
    if (std::optional<results::Table> table = make();
        table && result.table(table->name) == nullptr)
      result.tables.push_back(std::move(*table));
  } catch (const std::exception& error) {
    result.skipped.push_back({what, fmt::format("failed: {}", error.what())});
  }
}

/// Sets the columns of the theory by the formula of the spectrum, and adds the
/// tables that it answers.
void evaluate_theory(const cases::Case& contact_case,
                     const cases::MethodSpec& method, std::size_t index,
                     results::Result& result) {
  const auto* const theory = method.as<mechanics::TheorySettings>();
  if (theory == nullptr || method.needs_surface() ||
      theory->loss_factor != mechanics::LossFactor::yang_persson)
    return;
  const theory::PerssonContact contact(
      methods::formula_of_case(contact_case, method),
      contact_case.material.contact_modulus, theory->gamma);
  for (results::Curve& curve : result.methods[index].realizations)
    for (CurvePoint& row : curve.points)
      studies::evaluate_studies(contact_case, contact, row);
  if (cases::study_theory(contact_case.surface, contact_case.methods) !=
      &method)
    return;
  for (const studies::Study* const study : studies::all_studies())
    if (study->theory_tables != nullptr && study->keys().is_asked(contact_case))
      for (const studies::AskedTable& table :
           study->theory_tables(contact_case, contact))
        add_table("table " + table.name, table.make, result);
}

} // namespace

int ask_of_saved(results::Result& result,
                 const std::vector<std::string>& asked) {
  const cases::Case plain =
      cases::read_case_text(result.case_text, result.path);
  for (const std::string& one : asked)
    require_new_study(plain, one);
  const cases::Case contact_case =
      cases::read_case_text(result.case_text, result.path, asked);
  if (contact_case.load.targets.size() != plain.load.targets.size())
    throw input::InputError(
        result.path + ": the study needs load steps that the result does not "
                      "have: state it in the case and run it");
  result.case_text = contact_case.text;
  methods::MethodFactory factory(contact_case);
  int evaluated = 0;
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    results::MethodRecord& record = result.methods[i];
    const auto method = std::ranges::find(contact_case.methods, record.name,
                                          &cases::MethodSpec::name);
    if (method == contact_case.methods.end() || record.realizations.empty())
      continue;
    evaluate_theory(contact_case, *method, i, result);
    const results::SurfaceRecord* const pressed =
        reports::surface_of(result, record, 0);
    if (pressed == nullptr || !method->has_fields())
      continue;
    const methods::SurfaceOfCase surface{
        *pressed,
        {result.contact_modulus, pressed->grid.length_x,
         pressed->grid.spacing_x(), pressed->rms_height, pressed->rms_slope}};
    results::Curve& curve = record.realizations.front();
    evaluated += evaluate_maps(contact_case, *method, surface, factory, curve);
    for (const studies::Study* const study : studies::all_studies())
      if (study->map_table != nullptr && study->keys().is_asked(contact_case))
        add_table(
            study->keys().name() + " map, " + method->name,
            [&] {
              return studies::table_of_heaviest_map(*study, contact_case,
                                                    *method, surface, curve);
            },
            result);
  }
  return evaluated;
}

} // namespace asperity::run
