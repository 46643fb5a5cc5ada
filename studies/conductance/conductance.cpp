#include "studies/conductance/conductance.hpp"

#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"
#include "studies/conductance/conductance_study.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace asperity::studies {
namespace {

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
    observe("relative_conductance",
            [&] { return stiffness_of(*halfspace, set, 0.0); });
  if (study.gap_conductivity)
    observe("relative_gap_conductance",
            [&] { return gap_conductance(study, *halfspace, set, step.gap); });
  if (const auto* const law = methods::convex_contact(step.method)) {
    const double compliance =
        law->in_si(step.surface.scales).local_compliance();
    observe("normal_stiffness", [&]() -> results::Observed {
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

} // namespace

const Study conductance_study{.keys = conductance_keys,
                              .pages = conductance_pages,
                              .evaluate = evaluate_conductance,
                              .rescale = set_conductances,
                              .memory = 150.0};

} // namespace asperity::studies
