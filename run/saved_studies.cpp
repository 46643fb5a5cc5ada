#include "run/saved_studies.hpp"

#include "cases/reader/read_case.hpp"
#include "input/input_error.hpp"
#include "methods/methods.hpp"
#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace asperity::run {
namespace {

using results::CurvePoint;

/// Requires the key to be in the table of a study.
void require_study(const std::string& asked) {
  const std::string table = asked.substr(0, asked.find('.'));
  std::string allowed;
  for (const cases::StudyKeys* const study : cases::known_studies()) {
    if (!study->tables.empty() && study->name() == table)
      return;
    if (!study->tables.empty())
      allowed += (allowed.empty() ? "[" : ", [") + study->name() + "]";
  }
  throw input::InputError(
      fmt::format("--set: {} is no key of a study, which alone can be added to "
                  "a result: {}",
                  asked.substr(0, asked.find('=')), allowed));
}

/// The surface of realisation 0 of a method; null without one.
const results::SurfaceRecord* pressed_by(const results::Result& result,
                                         const results::Curve& curve) {
  if (curve.own_surface)
    return &*curve.own_surface;
  return result.surfaces.empty() ? nullptr : &result.surfaces.front();
}

/// Evaluates the studies on the saved maps of one method.
class SavedMethod {
public:
  SavedMethod(const cases::Case& contact_case, const cases::MethodSpec& method,
              const results::SurfaceRecord& surface, double contact_modulus,
              methods::MethodFactory& factory)
      : case_(contact_case),
        method_(method),
        surface_{surface,
                 {contact_modulus, surface.grid.length_x,
                  surface.grid.spacing_x(), surface.rms_height,
                  surface.rms_slope}},
        factory_(factory) {}

  /// Sets the columns of a row by the maps of its step.
  void evaluate(const results::Fields& maps, CurvePoint& row) const {
    const std::vector<double> pressure = maps.pressure_map().whole();
    const std::vector<double> gap = maps.gap_map().whole();
    CurvePoint answers;
    answers.step = row.step;
    answers.nominal_pressure = row.nominal_pressure;
    answers.mean_gap = row.mean_gap;
    studies::evaluate_studies(step_of(maps, pressure, gap), answers);
    results::state_of_map(answers, surface_.record.map.share(maps.grid));
    for (const auto& [column, number] : answers.others())
      column->set(row, number);
    if (!answers.note.empty())
      row.note += (row.note.empty() ? "" : "; ") + answers.note;
  }

  /// The tables of the studies for these maps that the result does not have.
  void add_tables(const results::Fields& maps, results::Result& result) const {
    const std::vector<double> pressure = maps.pressure_map().whole();
    const std::vector<double> gap = maps.gap_map().whole();
    for (const studies::Study* const study : studies::all_studies()) {
      if (study->map_table == nullptr || !study->keys().is_asked(case_))
        continue;
      auto table = study->map_table(step_of(maps, pressure, gap), maps.map);
      if (table && result.table(table->name) == nullptr)
        result.tables.push_back(std::move(*table));
    }
  }

private:
  studies::Step step_of(const results::Fields& maps,
                        const std::vector<double>& pressure,
                        const std::vector<double>& gap) const {
    return {
        case_,
        method_,
        surface_,
        maps.grid,
        pressure,
        gap,
        {method_.contact_criterion(surface_.scales.rms_height), pressure, gap},
        1,
        [this] { return factory_.operator_of(method_, surface_, 1); }};
  }

  const cases::Case& case_;
  const cases::MethodSpec& method_;
  methods::SurfaceOfCase surface_;
  methods::MethodFactory& factory_;
};

/// Evaluates the saved steps of a method; the heaviest has the tables.
int evaluate_maps(const SavedMethod& saved, std::size_t method,
                  results::Result& result) {
  results::Curve& curve = result.methods[method].realizations.front();
  int evaluated = 0;
  std::vector<const results::Fields*> heaviest;
  for (const results::Fields& maps : curve.fields) {
    const auto row =
        std::ranges::find(curve.points, maps.step, &CurvePoint::step);
    if (row == curve.points.end() ||
        row->status != results::StepStatus::converged ||
        maps.gap_map().size() != maps.grid.size() || maps.grid.size() == 0)
      continue;
    saved.evaluate(maps, *row);
    heaviest.push_back(&maps);
    ++evaluated;
  }
  std::ranges::sort(heaviest, std::ranges::greater{},
                    &results::Fields::nominal_pressure);
  for (const results::Fields* const maps : heaviest)
    saved.add_tables(*maps, result);
  return evaluated;
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
        if (result.table(table.name) == nullptr)
          result.tables.push_back(table.make());
}

} // namespace

int ask_of_saved(results::Result& result,
                 const std::vector<std::string>& asked) {
  for (const std::string& one : asked)
    require_study(one);
  const std::size_t steps =
      cases::read_case_text(result.case_text, result.path).load.targets.size();
  const cases::Case contact_case =
      cases::read_case_text(result.case_text, result.path, asked);
  if (contact_case.load.targets.size() != steps)
    throw input::InputError(
        result.path + ": the study needs load steps that the result does not "
                      "have: state it in the case and run it");
  result.case_text = contact_case.text;
  methods::Cache none;
  const methods::CaseKeys keys(contact_case, "", {});
  methods::MethodFactory factory(contact_case, none, keys);
  int evaluated = 0;
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    results::MethodRecord& record = result.methods[i];
    const auto method = std::ranges::find(contact_case.methods, record.name,
                                          &cases::MethodSpec::name);
    if (method == contact_case.methods.end() || record.realizations.empty())
      continue;
    evaluate_theory(contact_case, *method, i, result);
    if (const results::SurfaceRecord* const surface =
            pressed_by(result, record.realizations.front());
        surface != nullptr && method->has_fields())
      evaluated += evaluate_maps(
          {contact_case, *method, *surface, result.contact_modulus, factory}, i,
          result);
  }
  return evaluated;
}

} // namespace asperity::run
