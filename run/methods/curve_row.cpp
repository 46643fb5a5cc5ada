#include "run/methods/curve_row.hpp"

#include "base/array_memory.hpp"
#include "base/field_sums.hpp"
#include "base/ranks/node_sums.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace asperity::methods {
namespace {

/// Share of the largest tension of a law from which on a node counts as pulled.
constexpr double least_tension = 0.01;

/// What adhesion adds to a row.
void observe_adhesion(results::CurvePoint& row,
                      const contact::ContactSolution& solution,
                      const Observation& observation) {
  const mechanics::ContactInterface& law = *observation.adhesion;
  const std::size_t nodes = solution.gap.size();
  row[columns::adhesive_energy] =
      solution.is_detached
          ? 0.0
          : weighted_sum(
                observation.nodal_weights, nodes, observation.threads,
                [&](std::size_t i) { return law.energy(solution.gap[i]); }) /
                static_cast<double>(nodes);
  observe_tension(row, solution.pressure,
                  {observation.criterion, solution.pressure, solution.gap}, law,
                  observation.nodal_weights, observation.threads);
  row[columns::jump_pressure] = solution.jump_pressure;
  row[columns::jump_gap] = solution.jump_gap;
  if (std::isfinite(solution.smallest_stiffness)) // not without an open node
    row[columns::smallest_stiffness] = solution.smallest_stiffness;
  if (observation.grid_number > mechanics::accurate_grid_number * (1.0 + 1e-9))
    row.add_note(fmt::format("the grid resolves the range of the adhesion "
                             "coarsely: s^2 h/(w E*) = {:.2g} is above {:g}",
                             observation.grid_number,
                             mechanics::accurate_grid_number));
}

/// What a hardness adds to a row.
void observe_hardness(results::CurvePoint& row,
                      const contact::ContactSolution& solution,
                      const Observation& observation) {
  const double* const p = solution.pressure.data();
  row[columns::plastic_area] =
      weighted_sum(observation.nodal_weights, solution.pressure.size(),
                   observation.threads,
                   [=, hardness = observation.hardness](std::size_t i) {
                     return p[i] >= hardness ? 1.0 : 0.0;
                   }) /
      static_cast<double>(solution.pressure.size());
  row[columns::plastic_work] = observation.hardness * solution.mean_imprint;
}

/// [m]
double mean_displacement(const contact::ContactSolution& solution,
                         const Observation& observation) {
  const std::vector<double>& field = solution.displacement;
  return weighted_sum(observation.nodal_weights, field, observation.threads) /
         static_cast<double>(field.size());
}

results::CurvePoint row_of(const contact::ContactSolution& solution,
                           const Observation& observation,
                           const SurfaceOfCase& surface) {
  const Grid& grid = surface.record.grid;
  const std::span<const double> weights = observation.nodal_weights;
  const int threads = observation.threads;
  const std::vector<double>& pressure = solution.pressure;
  results::CurvePoint row;
  row.nominal_pressure = solution.nominal_pressure;
  row.mean_gap = solution.mean_gap;
  row.contact_stiffness = std::numeric_limits<double>::quiet_NaN();
  row.iterations = solution.iterations;
  row.residual = solution.gap_error / surface.scales.rms_height;
  row.status = solution.converged ? results::StepStatus::converged
                                  : results::StepStatus::not_converged;
  row.note = solution.note;
  results::RowObserver observe(row);
  const bool is_adhesive = observation.adhesion.has_value();
  const mechanics::ContactNodes nodes(observation.criterion, pressure,
                                      solution.gap);
  observe(columns::area_fraction, [&] {
    return results::counted_area_fraction(nodes, weights, threads);
  });
  observe(columns::contact_perimeter, [&] {
    return results::contact_perimeter(grid, nodes, observation.border, threads);
  });
  row.area_fraction_corrected = results::Observed::none;
  if (std::isfinite(observation.hardness))
    observe_hardness(row, solution, observation);
  // Neither the edge of the contact nor the distribution are elastic.
  const bool has_yielded =
      row[columns::plastic_work] > 0.0 || row[columns::plastic_area] > 0.0;
  if (observation.resolves_boundary && !is_adhesive && !has_yielded)
    observe(columns::area_fraction_corrected, [&] {
      return results::corrected_area_fraction(grid, pressure, solution.gap,
                                              {observation.contact_modulus,
                                               observation.area_coefficients,
                                               observation.border},
                                              threads);
    });
  if (observation.border == results::Border::free)
    row[columns::mean_displacement] = mean_displacement(solution, observation);
  if (observation.has_middle) {
    const results::PressureCentre centre =
        results::pressure_centre(grid, pressure, weights, threads);
    row[columns::pressure_centre.x] = centre.x;
    row[columns::pressure_centre.y] = centre.y;
  }
  if (is_adhesive)
    observe_adhesion(row, solution, observation);
  else if (!has_yielded)
    observe_pressure_fits(observe, pressure, weights, threads);
  observe(columns::elastic_energy, [&] {
    return results::elastic_energy(pressure, solution.displacement, weights,
                                   threads);
  });
  observe(columns::contact_energy, [&] {
    return results::contact_energy(pressure, observation.local_compliance,
                                   weights, threads);
  });
  return row;
}

} // namespace

void distrust_non_finite(StepAnswer& answer) {
  results::CurvePoint& row = answer.row;
  const bool has_load =
      std::isfinite(row.nominal_pressure) && std::isfinite(row.mean_gap);
  const bool has_maps = all_finite(answer.pressure) && all_finite(answer.gap);
  if (has_load && has_maps)
    return;
  row.status = results::StepStatus::not_converged;
  if (!has_load)
    row.add_note("the mean gap or the nominal pressure is not finite");
  if (!has_maps) {
    row.add_note("the fields are not finite and were not saved");
    free_memory(answer.pressure, answer.gap);
  }
}

void observe_pressure_fits(results::RowObserver& observe,
                           std::span<const double> pressure,
                           std::span<const double> weights, int threads) {
  const auto area_of = [](const results::PressureFit& fit) {
    return results::Observed{fit.area_fraction, fit.reason};
  };
  std::optional<results::PressureFits> found;
  const auto fits = [&]() -> const results::PressureFits& {
    if (!found)
      found = results::pressure_fits(pressure, weights, threads);
    return *found;
  };
  observe(columns::area_fraction_fit,
          [&] { return area_of(fits().by_histogram); });
  observe(columns::area_fraction_moment,
          [&] { return area_of(fits().by_moment); });
}

void observe_tension(results::CurvePoint& row, std::span<const double> pressure,
                     const mechanics::ContactNodes& nodes,
                     const mechanics::ContactInterface& law,
                     std::span<const double> weights, int threads) {
  const double* const p = pressure.data();
  const auto mean_of = [&](const auto& value) {
    return weighted_sum(weights, nodes.size(), threads, value) /
           static_cast<double>(nodes.size());
  };
  const double pulled = least_tension * law.pressure_bounds().smallest;
  row[columns::repulsive_area] = mean_of([&](std::size_t i) {
    return nodes.in_contact(i) && p[i] > 0.0 ? 1.0 : 0.0;
  });
  row[columns::attractive_load] =
      mean_of([=](std::size_t i) { return std::max(0.0, -p[i]); });
  row[columns::tensile_area] =
      mean_of([=](std::size_t i) { return p[i] <= pulled ? 1.0 : 0.0; });
}

StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface) {
  results::CurvePoint row = row_of(solution, observation, surface);
  return {std::move(row), surface.record.grid, std::move(solution.pressure),
          std::move(solution.gap)};
}

} // namespace asperity::methods
