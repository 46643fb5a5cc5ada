// The keys of [flow] in a case.
#include "input/reader/bound_key.hpp"
#include "studies/flow/flow.hpp"
#include "studies/flow/flow_study.hpp"
#include "studies/key_checks.hpp"

namespace asperity::studies {
namespace {

using cases::at_least;
using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::key;
using cases::MethodSpec;
using cases::needed;
using cases::TableReader;
using Flow = FlowStudy;

cases::Table keys_of_flow() {
  return {
      .name = "flow",
      .when = "Optional; needs a method with a gap.",
      .description =
          "The flow of a fluid through the gap of each load step, by Reynolds' "
          "equation (docs/numerics/flow.md), along x and along y.",
      .keys = {
          key<&Flow::viscosity>("viscosity", Dimension::viscosity,
                                "Viscosity of the fluid.", needed("1 mPa s")),
          key<&Flow::pressure_drop>(
              "pressure_drop", {Dimension::pressure, at_least(0.0)},
              "Pressure drop across the seal.", needed("10 kPa")),
          key<&Flow::length>("length", Dimension::length,
                             "Length of the seal along the flow.",
                             eg("5 mm", "default: that of a square")),
          key<&Flow::width>("width", Dimension::length,
                            "Width of the seal across the flow.",
                            eg("100 mm", "default: that of a square")),
      }};
}

void read_flow(TableReader table, Case& read) {
  FlowStudy study;
  table.read(study);
  require_fields(table, read, "gap");
  if (study.length.has_value() != study.width.has_value())
    table.complain_missing(study.length ? "width" : "length",
                           ": a seal has both");
  read.studies.ask(study);
}

std::string no_flow(const Case&, const MethodSpec& method) {
  const auto* const theory =
      std::get_if<mechanics::TheorySettings>(&method.settings);
  return theory != nullptr &&
                 theory->loss_factor != mechanics::LossFactor::yang_persson
             ? "needs loss_factor = \"yang-persson\""
             : "";
}

/// The numbers of [flow] scale the answer.
std::string flow_key(const cases::Case&) {
  return "\nflow";
}

} // namespace

const cases::StudyKeys& flow_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_flow()},
      .read = read_flow,
      .is_asked = asks<FlowStudy>,
      .questions = {{"[flow]",
                     {"flow_factor_x", "flow_factor_y", "flow_conductance_x",
                      "flow_conductance_y", "critical_gap_x", "critical_gap_y",
                      "leak_rate_x", "leak_rate_y", "effective_medium"},
                     asks<FlowStudy>,
                     no_flow}},
      .step_key = flow_key};
  return keys;
}

} // namespace asperity::studies
