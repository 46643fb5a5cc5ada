// The keys of [conductance] in a case.
#include "input/reader/bound_key.hpp"
#include "studies/conductance/conductance.hpp"
#include "studies/conductance/conductance_study.hpp"
#include "studies/key_checks.hpp"

#include <fmt/format.h>

namespace asperity::studies {
namespace {

using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::Key;
using cases::key;
using cases::MethodSpec;
using cases::TableReader;
using Conductance = ConductanceStudy;

template <auto member>
Key conductivity_key(const char* name, const char* description,
                     const char* example) {
  return key<member>(name, Dimension::thermal_conductivity, description,
                     eg(example, "default: no thermal_conductance"));
}

template <auto member>
Key resistivity_key(const char* name, const char* description,
                    const char* example) {
  return key<member>(name, Dimension::resistivity, description,
                     eg(example, "default: no electrical_conductance"));
}

cases::Table keys_of_conductance() {
  return {
      .name = "conductance",
      .when = "Optional; needs a method with a contact map.",
      .description =
          "Heat and current through the spots of contact of each load step, "
          "and the incremental normal stiffness of the contact "
          "(docs/numerics/conductance.md).",
      .keys = {
          conductivity_key<&Conductance::thermal_conductivity>(
              "thermal_conductivity", "Thermal conductivity of the block.",
              "0.2 W/(m K)"),
          conductivity_key<&Conductance::counter_thermal_conductivity>(
              "counter_thermal_conductivity",
              "Thermal conductivity of the body on it, also of a rigid one.",
              "16 W/(m K)"),
          resistivity_key<&Conductance::resistivity>(
              "resistivity", "Electrical resistivity of the block.",
              "17 nOhm m"),
          resistivity_key<&Conductance::counter_resistivity>(
              "counter_resistivity",
              "Electrical resistivity of the body on it, also of a rigid one.",
              "24 nOhm m"),
          key<&Conductance::gap_conductivity>(
              "gap_conductivity", Dimension::thermal_conductivity,
              "Thermal conductivity of the medium in the gap.",
              eg("0.026 W/(m K)", "default: no heat through the gap")),
          key<&Conductance::smallest_gap>(
              "smallest_gap", Dimension::length,
              "Gap below which the medium conducts no better, such as the mean "
              "free path of a gas; required with gap_conductivity.",
              eg("70 nm", "default: no heat through the gap")),
      }};
}

/// Both bodies have a property, or neither.
void require_both(TableReader& table, const std::string& key) {
  const std::string counter = "counter_" + key;
  if (table.has(key) != table.has(counter))
    table.complain_missing(table.has(key) ? counter : key,
                           ": both bodies conduct; a body of the same material "
                           "has the same value");
}

void read_conductance(TableReader table, Case& read) {
  ConductanceStudy study;
  table.read(study);
  require_fields(table, read, "contact map");
  require_both(table, "thermal_conductivity");
  require_both(table, "resistivity");
  if (study.gap_conductivity || study.smallest_gap)
    for (const char* const key :
         {"gap_conductivity", "smallest_gap", "thermal_conductivity"})
      table.require(key, ", which heat through the gap needs");
  read.studies.ask(study);
}

/// Surface methods whose pressures are the answer of one operator in a convex
/// problem have the stiffness of [conductance], full blocks their own.
std::string no_normal_stiffness(const Case&, const MethodSpec& method) {
  if (const auto* const fem =
          std::get_if<mechanics::FemSettings>(&method.settings);
      fem != nullptr && fem->solver == mechanics::FemSolver::full)
    return fem->full.has_stiffness ? "" : "needs stiffness = true";
  if (method.contact() == nullptr)
    return "needs a [halfspace] or [fem]";
  return method.is_adhesive() ? "needs a contact without adhesion" : "";
}

/// The conductivities of the bodies scale the answer, that of the gap does not.
std::string conductance_key(const cases::Case& contact_case) {
  const auto& study = *contact_case.study<ConductanceStudy>();
  return study.gap_conductivity
             ? fmt::format("\nconductance {} {}",
                           study.conductivity() / *study.gap_conductivity,
                           *study.smallest_gap)
             : "\nconductance";
}

} // namespace

const cases::StudyKeys& conductance_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_conductance()},
      .read = read_conductance,
      .is_asked = asks<ConductanceStudy>,
      .questions = {{"[conductance]",
                     {"relative_conductance"},
                     asks<ConductanceStudy>,
                     cases::no_map},
                    {"normal_stiffness of [conductance]",
                     {"normal_stiffness"},
                     asks<ConductanceStudy>,
                     no_normal_stiffness}},
      .step_key = conductance_key,
      .conducts = true};
  return keys;
}

} // namespace asperity::studies
