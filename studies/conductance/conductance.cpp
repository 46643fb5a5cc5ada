#include "studies/conductance/conductance.hpp"

#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "input/reader/bound_key.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "studies/key_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <variant>
#include <vector>

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

results::Observed observed(double stiffness, bool has_converged) {
  if (!has_converged)
    return {results::Observed::none, "the linear solver did not converge"};
  if (stiffness == infinity)
    return {results::Observed::none, "all nodes are in contact"};
  return stiffness;
}

results::Observed stiffness_of(contact::SurfaceOperator& elasticity,
                               std::span<const std::uint8_t> set,
                               double local_compliance) {
  const contact::PunchStiffness found =
      contact::punch_stiffness(elasticity, set, local_compliance);
  return observed(found.stiffness, found.converged);
}

/// Whether the operator of a method is that of the half-space with E*.
bool is_halfspace(const Step& step) {
  return std::holds_alternative<mechanics::HalfspaceSettings>(
             step.method.settings) &&
         methods::continuum_of(step.method, step.contact_case.material,
                               step.surface.scales)
             .is_halfspace();
}

/// The half-space with E* = 1 Pa.
std::unique_ptr<contact::SurfaceOperator>
unit_halfspace(const Grid& grid, mechanics::Border border, int threads) {
  return contact::halfspace_operator(grid, mechanics::halfspace(1.0, border),
                                     threads)
      .clone();
}

/// What the medium in the gap adds to G/k of half-spaces [1/m].
results::Observed gap_conductance(const ConductanceStudy& study,
                                  contact::SurfaceOperator& halfspace,
                                  std::span<const std::uint8_t> set,
                                  std::span<const double> gap) {
  std::vector<double> film(gap.size());
  for (std::size_t i = 0; i < film.size(); ++i)
    film[i] = std::max(gap[i], *study.smallest_gap) * study.conductivity() /
              *study.gap_conductivity;
  const contact::FilmStiffness found =
      contact::film_stiffness(halfspace, set, film);
  return observed(found.stiffness, found.converged);
}

/// The conductance is that between two half-spaces, except that of the spots of
/// a full block that has found it on its mesh (methods::conducts_in_block); the
/// normal stiffness is that of the operator of a surface method without
/// adhesion.
void evaluate_conductance(const Step& step, results::CurvePoint& row) {
  const Grid& grid = step.grid;
  const ConductanceStudy& study = *step.contact_case.study<ConductanceStudy>();
  const std::vector<std::uint8_t> set = step.nodes.contact_set();
  const auto halfspace =
      unit_halfspace(grid, step.method.border(), step.threads);
  results::RowObserver observe(row);
  if (!methods::conducts_in_block(step.method))
    observe(columns::relative_conductance,
            [&] { return stiffness_of(*halfspace, set, 0.0); });
  if (study.gap_conductivity)
    observe(columns::relative_gap_conductance,
            [&] { return gap_conductance(study, *halfspace, set, step.gap); });
  if (const auto* const law = methods::convex_contact(step.method)) {
    const double compliance =
        law->in_si(step.surface.scales).local_compliance();
    observe(columns::normal_stiffness, [&]() -> results::Observed {
      if (compliance == 0.0 && is_halfspace(step))
        return row[columns::relative_conductance] *
               step.contact_case.material.contact_modulus * grid.area();
      const auto elasticity = step.elasticity();
      results::Observed found = stiffness_of(*elasticity, set, compliance);
      found.value *= grid.area();
      return found;
    });
  }
}

/// Sets the conductances of heat and current by the relative ones and the
/// conductivities, which are the harmonic means 2 k_1 k_2/(k_1 + k_2) and
/// 2/(rho_1 + rho_2).
void set_conductances(const cases::Case& contact_case,
                      results::CurvePoint& row) {
  const ConductanceStudy& study = *contact_case.study<ConductanceStudy>();
  if (study.thermal_conductivity)
    row[columns::thermal_conductance] =
        study.conductivity() *
        (row[columns::relative_conductance] +
         (study.gap_conductivity ? row[columns::relative_gap_conductance]
                                 : 0.0));
  if (study.resistivity)
    row[columns::electrical_conductance] =
        row[columns::relative_conductance] * 2.0 /
        (*study.resistivity + *study.counter_resistivity);
}

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

} // namespace

const Study conductance_study{.keys = conductance_keys,
                              .pages = conductance_pages,
                              .evaluate = evaluate_conductance,
                              .rescale = set_conductances,
                              .memory = 150.0};

} // namespace asperity::studies
