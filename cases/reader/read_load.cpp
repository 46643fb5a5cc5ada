#include "cases/reader/read_case.hpp"
#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

namespace asperity::cases {
namespace {

enum class Cycle { load, load_unload };

void append_way_back(mechanics::LoadingPath& program) {
  for (std::size_t step = program.targets.size(); step-- > 1;) {
    program.targets.push_back(program.targets[step - 1]);
    program.is_unloading.push_back(true);
  }
}

} // namespace

mechanics::LoadingPath read_load(const Node& table, Mistakes& mistakes) {
  TableReader load(table, vocabulary_table("load"), mistakes);
  load.refuse_unknown();
  mechanics::LoadingPath program;
  if (load.has("nominal_pressure") && load.has("mean_gap"))
    load.refuse_both("nominal_pressure", "mean_gap");
  if (load.has("mean_gap")) {
    program.control = mechanics::Control::mean_gap;
    program.targets = load.program("mean_gap");
  } else if (load.has("nominal_pressure")) {
    program.targets = load.program("nominal_pressure");
  } else {
    load.complain_missing("nominal_pressure", " (or mean_gap)");
  }
  program.is_unloading.assign(program.targets.size(), false);
  if (load.choice("cycle", Cycle::load) == Cycle::load_unload)
    append_way_back(program);
  return program;
}

ReportSpec read_report(const Node& table, Mistakes& mistakes) {
  TableReader report(table, vocabulary_table("report"), mistakes);
  report.refuse_unknown();
  ReportSpec spec;
  spec.stress_inside = report.boolean("stress_inside");
  spec.vtu = report.boolean("vtu");
  const Node* const fields = report.entry("fields");
  if (fields->text == "none")
    spec.fields = 0;
  else if (fields->text == "all")
    spec.fields = all_fields;
  else if (fields->type == NodeType::integer)
    spec.fields = report.integer("fields");
  else
    report.refuse(*fields, "must be a whole number, \"none\" or \"all\"");
  return spec;
}

} // namespace asperity::cases
