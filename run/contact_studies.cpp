#include "run/contact_studies.hpp"

#include "base/field_sums.hpp"
#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/operators/wave_directions.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "mechanics/contact_nodes.hpp"
#include "mechanics/partial_slip.hpp"
#include "methods/chosen.hpp"
#include "methods/continuum_block.hpp"
#include "results/observables/clusters.hpp"
#include "results/observables/row_observer.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

namespace asperity::run {
namespace {

using results::Border;

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
bool is_halfspace(const StudiedMethod& studied) {
  return std::holds_alternative<mechanics::HalfspaceSettings>(
             studied.method.settings) &&
         methods::continuum_of(studied.method, studied.contact_case.material,
                               studied.surface.scales)
             .is_halfspace();
}

/// The half-space with E* = 1 Pa.
std::unique_ptr<contact::SurfaceOperator>
unit_halfspace(const Grid& grid, Border border, int threads) {
  return contact::halfspace_operator(grid, mechanics::halfspace(1.0, border),
                                     threads)
      .clone();
}

/// What the medium in the gap adds to G/k of half-spaces [1/m].
results::Observed gap_conductance(const cases::ConductanceStudy& study,
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

void add_conductance(const StudiedMethod& studied,
                     const methods::StepAnswer& answer,
                     std::span<const std::uint8_t> set,
                     results::CurvePoint& row) {
  const Grid& grid = answer.grid;
  const cases::ConductanceStudy& study =
      *studied.contact_case.conductance_study;
  const auto halfspace =
      unit_halfspace(grid, studied.method.border(), studied.threads);
  results::RowObserver observe(row);
  if (!methods::conducts_in_block(studied.method))
    observe("relative_conductance",
            [&] { return stiffness_of(*halfspace, set, 0.0); });
  if (study.gap_conductivity)
    observe("relative_gap_conductance", [&] {
      return gap_conductance(study, *halfspace, set, answer.gap);
    });
  if (const auto* const law = methods::convex_contact(studied.method)) {
    const double compliance =
        law->in_si(studied.surface.scales).local_compliance();
    observe("normal_stiffness", [&]() -> results::Observed {
      if (compliance == 0.0 && is_halfspace(studied))
        return row.relative_conductance *
               studied.contact_case.material.contact_modulus * grid.area();
      const auto elasticity = studied.solvers.operator_of(
          studied.method, studied.surface, studied.threads);
      results::Observed found = stiffness_of(*elasticity, set, compliance);
      found.value *= grid.area();
      return found;
    });
  }
  set_conductances(study, row);
}

void add_spots(const StudiedMethod& studied, const Grid& grid,
               const mechanics::ContactNodes& nodes, results::CurvePoint& row) {
  const results::SurfaceRecord& pressed = studied.surface.record;
  const auto numbers_of = [&](const std::vector<std::uint8_t>& set) {
    return results::cluster_numbers(
        results::find_clusters(grid, set, studied.method.border(),
                               pressed.map.on(pressed.grid, grid)),
        static_cast<std::size_t>(studied.contact_case.spots_study->smallest));
  };
  const results::ClusterNumbers spots = numbers_of(nodes.contact_set());
  const results::ClusterNumbers gaps = numbers_of(nodes.open_set());
  row.spot_count = spots.count;
  row.largest_spot = spots.largest;
  row.spot_dimension = spots.dimension;
  row.spots_percolate_x = spots.percolates_x ? 1.0 : 0.0;
  row.spots_percolate_y = spots.percolates_y ? 1.0 : 0.0;
  row.spot_radii = spots.radii / grid.area();
  row.gap_count = gaps.count;
  row.largest_gap = gaps.largest;
  row.gap_dimension = gaps.dimension;
  row.gap_percolates_x = gaps.percolates_x ? 1.0 : 0.0;
  row.gap_percolates_y = gaps.percolates_y ? 1.0 : 0.0;
}

} // namespace

bool needs_all_maps(const cases::Case& contact_case) {
  return contact_case.flow_study || contact_case.spots_study ||
         contact_case.conductance_study || contact_case.friction_study;
}

void add_contact_studies(const StudiedMethod& studied,
                         methods::StepAnswer& answer) {
  const cases::Case& contact_case = studied.contact_case;
  results::CurvePoint& row = answer.row;
  if (row.status != results::StepStatus::converged || answer.gap.empty())
    return;
  const mechanics::ContactNodes nodes(
      studied.method.contact_criterion(studied.surface.scales.rms_height),
      answer.pressure, answer.gap);
  if (contact_case.spots_study)
    add_spots(studied, answer.grid, nodes, row);
  if (contact_case.conductance_study)
    add_conductance(studied, answer, nodes.contact_set(), row);
}

void set_conductances(const cases::ConductanceStudy& study,
                      results::CurvePoint& row) {
  if (study.thermal_conductivity)
    row.thermal_conductance =
        study.conductivity() *
        (row.relative_conductance +
         (study.gap_conductivity ? row.relative_gap_conductance : 0.0));
  if (study.resistivity)
    row.electrical_conductance =
        row.relative_conductance * 2.0 /
        (*study.resistivity + *study.counter_resistivity);
}

namespace {

/// Tangential over normal compliance along x and y [1].
/// @param local  share of the springs of a penalty in the normal compliance,
///               whose ratio is that of the mean over the directions
mechanics::Directions ratios(const mechanics::MaterialSpec& material,
                             double along_x, double local) {
  const double mean = mechanics::tangential_ratio(material);
  const double turned = std::isnan(along_x) // of a uniform pressure: none
                            ? 0.0
                            : (1.0 - local) *
                                  mechanics::tangential_anisotropy(material) *
                                  (along_x - 0.5);
  return {mean - turned, mean + turned};
}

} // namespace

void add_stick_stiffness(const StudiedMethod& studied,
                         methods::StepAnswer& answer) {
  const mechanics::MaterialSpec& material = studied.contact_case.material;
  const auto* const law = methods::convex_contact(studied.method);
  results::CurvePoint& row = answer.row;
  if (row.status != results::StepStatus::converged || answer.gap.empty() ||
      law == nullptr || !cases::has_partial_slip(studied.method, material))
    return;
  const double compliance =
      law->in_si(studied.surface.scales).local_compliance();
  const auto elasticity = studied.solvers.operator_of(
      studied.method, studied.surface, studied.threads);
  const mechanics::ContactNodes nodes(
      studied.method.contact_criterion(studied.surface.scales.rms_height),
      answer.pressure, answer.gap);
  const contact::PunchStiffness normal =
      contact::punch_stiffness(*elasticity, nodes.contact_set(), compliance);
  const auto& q = normal.pressure;
  mechanics::Directions of;
  if (!q.empty())
    of = ratios(material,
                contact::energy_along_x(
                    answer.grid, q, elasticity->is_periodic(), studied.threads),
                compliance * normal.stiffness * dot(q, q) /
                    static_cast<double>(q.size()));
  const auto stiffness = [&](double ratio) -> results::Observed {
    if (!normal.converged)
      return {results::Observed::none, "the linear solver did not converge"};
    if (std::isinf(normal.stiffness))
      return {results::Observed::none, "all nodes are in contact"};
    return q.empty() ? 0.0 : normal.stiffness / ratio;
  };
  results::RowObserver observe(row);
  observe("stick_stiffness_x", [&] { return stiffness(of.x); });
  observe("stick_stiffness_y", [&] { return stiffness(of.y); });
}

} // namespace asperity::run
