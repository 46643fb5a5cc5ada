#include "run/studies.hpp"

#include "methods/surfaces_of_case.hpp"
#include "run/interrupt.hpp"
#include "run/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace asperity::run {
namespace {

using results::Table;

/// Manages the tables of one run, which are in the file, cached, or still to be
/// computed.
class StudyTables {
public:
  StudyTables(const RunContext& context, const cases::MethodSpec& theory)
      : context_(context), theory_(theory) {}

  /// Writes cached tables to the result file.
  ///
  /// @return  true if the file now contains all tables
  bool take(const std::vector<std::string>& names);

  /// Computes a table unless the file contains it or the run is being
  /// interrupted.
  void record(const std::string& name, const std::function<Table()>& make);

private:
  const RunContext& context_;
  const cases::MethodSpec& theory_;
};

bool StudyTables::take(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (context_.writer->has_table(name))
      continue;
    const std::optional<results::Change> kept =
        methods::kept_change(context_.cache, context_.keys.table(theory_, name),
                             methods::entry_kind::table);
    if (!kept)
      continue;
    context_.writer->append(*kept);
    context_.tally.add_kept("table " + name, {0, 0.0});
  }
  return std::ranges::all_of(names, [&](const std::string& name) {
    return context_.writer->has_table(name);
  });
}

void StudyTables::record(const std::string& name,
                         const std::function<Table()>& make) {
  if (context_.writer->has_table(name) || is_interrupted())
    return;
  const std::optional<Table> table =
      context_.tally.attempt("table " + name, make);
  if (!table)
    return;
  const results::Change change{.tables = {*table}};
  context_.writer->append(change);
  methods::keep_change(context_.cache, context_.keys.table(theory_, name),
                       methods::entry_kind::table, change);
}

std::string seen_name(std::size_t load) {
  return fmt::format("magnification-{}", load + 1);
}

std::string gaps_name(std::size_t load) {
  return fmt::format("gap-distribution-{}", load + 1);
}

std::vector<std::string> table_names(const cases::MagnificationStudy& study) {
  std::vector<std::string> names{"magnification"};
  for (std::size_t i = 0; i < study.nominal_pressures.size(); ++i) {
    names.push_back(seen_name(i));
    names.push_back(gaps_name(i));
  }
  if (study.leak)
    names.emplace_back("leak");
  return names;
}

void run_magnification(const cases::MagnificationStudy& study,
                       const theory::PerssonContact& contact, Tally& tally,
                       StudyTables& tables) {
  if (tables.take(table_names(study)))
    return;
  const auto contacts = tally.attempt(
      "[magnification]", [&] { return magnified_contacts(contact, study); });
  if (!contacts)
    return;
  tables.record("magnification", [&] { return loads_table(*contacts); });
  for (std::size_t i = 0; i < contacts->size(); ++i) {
    tables.record(seen_name(i), [&] {
      return magnification_table(seen_name(i), (*contacts)[i], study);
    });
    tables.record(gaps_name(i), [&] {
      return gap_distribution_table(gaps_name(i), (*contacts)[i]);
    });
  }
  if (study.leak)
    tables.record("leak", [&] { return leak_table(*contacts, *study.leak); });
}

void run_adhesion(const cases::AdhesionStudy& study,
                  const theory::PerssonContact& contact, Tally& tally,
                  StudyTables& tables) {
  if (tables.take({"adhesion", "adhesion-flip"}))
    return;
  theory::AdhesivePair pair{.contact_modulus = contact.contact_modulus(),
                            .work_of_adhesion = study.work_of_adhesion,
                            .gamma = contact.gamma()};
  if (study.detachment_factor)
    pair.detachment_factor = *study.detachment_factor;
  const theory::RoughAdhesion adhesion(contact.spectrum(), pair, study.steps);
  const std::optional<Table> rows = tally.attempt("[adhesion]", [&] {
    return adhesion_table(adhesion, study, contact.spectrum().rms_height());
  });
  if (!rows)
    return;
  tables.record(rows->name, [&] { return *rows; });
  tables.record("adhesion-flip",
                [&] { return adhesion_flip_table(adhesion, study, *rows); });
}

} // namespace

void run_studies(const RunContext& context, const cases::MethodSpec& theory) {
  const cases::Case& contact_case = context.contact_case;
  if (!contact_case.magnification_study && !contact_case.adhesion_study)
    return;
  const bool is_measured =
      contact_case.surface.kind == mechanics::SurfaceKind::measured;
  const theory::PerssonContact contact(
      is_measured ? methods::spread_spectrum_of(context.surfaces.of(theory, 0))
                  : methods::formula_of_case(contact_case, theory),
      contact_case.material.contact_modulus,
      std::get<mechanics::TheorySettings>(theory.settings).gamma);
  StudyTables tables(context, theory);
  if (contact_case.magnification_study)
    run_magnification(*contact_case.magnification_study, contact, context.tally,
                      tables);
  if (contact_case.adhesion_study)
    run_adhesion(*contact_case.adhesion_study, contact, context.tally, tables);
}

} // namespace asperity::run
