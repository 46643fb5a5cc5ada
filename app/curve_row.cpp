#include "app/curve_row.hpp"

#include "results/observables.hpp"
#include "results/pressure_fit.hpp"

#include <limits>
#include <utility>

namespace asperity::app {
namespace {

results::CurvePoint row_of(const contact::ContactSolution& solution,
                           const Observation& observation,
                           const SurfaceOfCase& surface) {
  const Grid& grid = surface.record.grid;
  const std::span<const double> weights = observation.nodal_weights;
  results::CurvePoint row;
  row.nominal_pressure = solution.nominal_pressure;
  row.mean_gap = solution.mean_gap;
  row.area_fraction =
      results::counted_area_fraction(solution.pressure, weights);
  row.contact_perimeter = results::contact_perimeter(grid, solution.pressure);
  row.area_fraction_corrected = results::corrected_area_fraction(
      grid, solution.pressure, solution.gap, observation.contact_modulus,
      observation.area_coefficients);
  row.area_fraction_fit =
      results::fit_pressure_distribution(solution.pressure, weights)
          .area_fraction;
  row.area_fraction_moment =
      results::pressure_fit_by_moment(solution.pressure, weights).area_fraction;
  row.elastic_energy = results::elastic_energy(solution.pressure,
                                               solution.displacement, weights);
  row.contact_energy = results::contact_energy(
      solution.pressure, observation.local_compliance, weights);
  row.contact_stiffness = std::numeric_limits<double>::quiet_NaN();
  row.iterations = solution.iterations;
  row.residual = solution.gap_error / surface.scales.rms_height;
  row.status = solution.converged ? results::StepStatus::converged
                                  : results::StepStatus::not_converged;
  row.note = solution.note;
  return row;
}

} // namespace

StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface) {
  results::CurvePoint row = row_of(solution, observation, surface);
  return {std::move(row), surface.record.grid, std::move(solution.pressure),
          std::move(solution.gap)};
}

} // namespace asperity::app
