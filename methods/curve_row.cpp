#include "methods/curve_row.hpp"

#include "base/array_memory.hpp"
#include "base/field_sums.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"
#include "results/observables/row_observer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace asperity::methods {
namespace {

results::CurvePoint row_of(const contact::ContactSolution& solution,
                           const Observation& observation,
                           const SurfaceOfCase& surface) {
  const Grid& grid = surface.record.grid;
  const std::span<const double> weights = observation.nodal_weights;
  const Workers& workers = observation.workers;
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
  observe("area_fraction", [&] {
    return results::counted_area_fraction(pressure, weights, workers);
  });
  observe("contact_perimeter", [&] {
    return results::contact_perimeter(grid, pressure, observation.border,
                                      workers);
  });
  row.area_fraction_corrected = results::Observed::none;
  if (observation.resolves_boundary)
    observe("area_fraction_corrected", [&] {
      return results::corrected_area_fraction(grid, pressure, solution.gap,
                                              {observation.contact_modulus,
                                               observation.area_coefficients,
                                               observation.border},
                                              workers);
    });
  if (observation.has_middle) {
    const results::PressureCentre centre =
        results::pressure_centre(grid, pressure, weights, workers);
    row.pressure_centre_x = centre.x;
    row.pressure_centre_y = centre.y;
  }
  observe_pressure_fits(observe, pressure, weights, workers);
  observe("elastic_energy", [&] {
    return results::elastic_energy(pressure, solution.displacement, weights,
                                   workers);
  });
  observe("contact_energy", [&] {
    return results::contact_energy(pressure, observation.local_compliance,
                                   weights, workers);
  });
  return row;
}

void add_note(results::CurvePoint& row, const std::string& note) {
  row.note += (row.note.empty() ? "" : "; ") + note;
}

} // namespace

void distrust_non_finite(StepAnswer& answer) {
  results::CurvePoint& row = answer.row;
  const bool has_load =
      std::isfinite(row.nominal_pressure) && std::isfinite(row.mean_gap);
  const bool has_maps = answer.has_finite_fields &&
                        all_finite(answer.pressure) && all_finite(answer.gap);
  if (has_load && has_maps)
    return;
  row.status = results::StepStatus::not_converged;
  if (!has_load)
    add_note(row, "the mean gap or the nominal pressure is not finite");
  if (!has_maps) {
    add_note(row, "the fields are not finite and were not saved");
    free_memory(answer.pressure, answer.gap);
    answer.rows = {};
  }
}

void observe_pressure_fits(results::RowObserver& observe,
                           std::span<const double> pressure,
                           std::span<const double> weights,
                           const Workers& workers) {
  const auto area_of = [](const results::PressureFit& fit) {
    return results::Observed{fit.area_fraction, fit.reason};
  };
  std::optional<results::PressureFits> found;
  const auto fits = [&]() -> const results::PressureFits& {
    if (!found)
      found = results::pressure_fits(pressure, weights, workers);
    return *found;
  };
  observe("area_fraction_fit", [&] { return area_of(fits().by_histogram); });
  observe("area_fraction_moment", [&] { return area_of(fits().by_moment); });
}

StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface) {
  results::CurvePoint row = row_of(solution, observation, surface);
  return {std::move(row), surface.record.grid, std::move(solution.pressure),
          std::move(solution.gap)};
}

} // namespace asperity::methods
