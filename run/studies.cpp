#include "run/studies.hpp"

#include "results/result_reader.hpp"
#include "run/interrupt.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "studies/study.hpp"

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

} // namespace

void run_studies(const RunContext& context, const cases::MethodSpec& theory) {
  const cases::Case& contact_case = context.contact_case;
  const auto has_tables = [&](const studies::Study* study) {
    return study->theory_tables != nullptr &&
           study->keys().is_asked(contact_case);
  };
  if (std::ranges::none_of(studies::all_studies(), has_tables))
    return;
  const bool is_measured =
      contact_case.surface.kind == mechanics::SurfaceKind::measured;
  const theory::PerssonContact contact(
      is_measured ? methods::spread_spectrum_of(context.surfaces.of(theory, 0))
                  : methods::formula_of_case(contact_case, theory),
      contact_case.material.contact_modulus,
      std::get<mechanics::TheorySettings>(theory.settings).gamma);
  StudyTables tables(context, theory);
  for (const studies::Study* const study : studies::all_studies()) {
    if (!has_tables(study))
      continue;
    const std::vector<studies::AskedTable> asked =
        study->theory_tables(contact_case, contact);
    std::vector<std::string> names(asked.size());
    std::ranges::transform(asked, names.begin(), &studies::AskedTable::name);
    if (!tables.take(names))
      for (const studies::AskedTable& one : asked)
        tables.record(one.name, one.make);
  }
}

namespace {

void record_map_table(const RunContext& run, const studies::Study& study,
                      const cases::MethodSpec& method,
                      const results::Result& result) {
  const results::MethodRecord* const record = result.method(method.name);
  if (record == nullptr || record->realizations.empty())
    return;
  const auto table =
      run.tally.attempt(study.keys().name() + " map, " + method.name, [&] {
        return studies::table_of_heaviest_map(study, run.contact_case, method,
                                              run.surfaces.of(method, 0),
                                              record->realizations.front());
      });
  if (table && *table)
    run.writer->record_table(**table);
}

} // namespace

void record_map_tables(const RunContext& run,
                       std::span<const cases::MethodSpec> methods) {
  std::vector<const studies::Study*> asked;
  for (const studies::Study* const study : studies::all_studies())
    if (study->map_table != nullptr && study->keys().is_asked(run.contact_case))
      asked.push_back(study);
  if (asked.empty())
    return;
  run.root.act([&] {
    const results::Result result =
        results::read_result(run.writer->path(), results::MapsInFile::large);
    for (const studies::Study* const study : asked)
      for (const cases::MethodSpec& method : methods)
        if (method.has_fields())
          record_map_table(run, *study, method, result);
  });
}

} // namespace asperity::run
