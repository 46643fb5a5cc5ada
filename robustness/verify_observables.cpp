#include "robustness/verify_observables.hpp"

#include "base/special_numbers.hpp"
#include "results/observables/area_estimate.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string>
#include <tuple>

namespace asperity::robustness {
namespace {

/// A number of a row with its admissible range.
struct Ranged {
  const char* name;
  double value;
  double low;
  double high;
  bool may_be_unknown; ///< NaN means "not determined"
};

std::optional<Failure> verify_range(const Ranged& number) {
  if (number.may_be_unknown && std::isnan(number.value))
    return {};
  if (std::isfinite(number.value) && number.value >= number.low &&
      number.value <= number.high)
    return {};
  return Failure{"observables",
                 fmt::format("{} = {:.6g}, but must be finite and between {:g} "
                             "and {:g}",
                             number.name, number.value, number.low,
                             number.high)};
}

/// Returns the effect of the rounding of the displacement on <p u>/2. For a
/// uniform pressure the displacement consists of rounding only.
double rounding_of_energy(const AskedContact& asked,
                          const contact::ContactSolution& solution) {
  double highest = 0.0;
  for (const double pressure : solution.pressure)
    highest = std::max(highest, std::abs(pressure));
  return highest * gap_rounding(asked, solution);
}

std::optional<Failure> verify_ranges(const Grid& grid,
                                     const AskedContact& asked,
                                     const contact::ContactSolution& solution,
                                     double contact_modulus) {
  const auto& [pressure, gap] = std::tie(solution.pressure, solution.gap);
  const auto nodes = results::ContactNodes::under(pressure);
  const auto counted = results::counted_area_fraction(nodes, asked.weights);
  const auto corrected = results::corrected_area_fraction(
      grid, pressure, gap,
      {contact_modulus, results::halfspace_area_coefficients, asked.border});
  const auto fit = results::fit_pressure_distribution(pressure, asked.weights);
  const auto moment = results::pressure_fit_by_moment(pressure, asked.weights);
  const double energy =
      results::elastic_energy(pressure, solution.displacement, asked.weights);
  const double springs =
      results::contact_energy(pressure, asked.local_compliance, asked.weights);
  const double longest = 2.0 / grid.spacing_x() + 2.0 / grid.spacing_y();
  const std::array numbers{
      Ranged{"counted area", counted, 0.0, 1.0 + 1e-12, false},
      Ranged{"corrected area", corrected.value, 0.0, 1.0, true},
      Ranged{"fitted area", fit.area_fraction, 0.0, 1.0, true},
      Ranged{"area by moment", moment.area_fraction, 0.0, 1.0, true},
      Ranged{"perimeter", results::contact_perimeter(grid, nodes, asked.border),
             0.0, longest * (1.0 + 1e-12), false},
      Ranged{"elastic energy", energy, -rounding_of_energy(asked, solution),
             infinity, false},
      Ranged{"contact energy", springs, 0.0, infinity, false}};
  for (const Ranged& number : numbers)
    if (auto failure = verify_range(number))
      return failure;
  return {};
}

} // namespace

std::optional<Failure>
verify_observables(const Grid& grid, const AskedContact& asked,
                   const contact::ContactSolution& solution,
                   double contact_modulus) {
  try {
    return verify_ranges(grid, asked, solution, contact_modulus);
  } catch (const std::exception& error) {
    return Failure{"observables", std::string("an exception: ") + error.what()};
  }
}

std::optional<Failure> verify_row(const results::CurvePoint& row) {
  const std::array numbers{
      Ranged{"nominal_pressure", row.nominal_pressure, 0.0, infinity, false},
      Ranged{"mean_gap", row.mean_gap, -infinity, infinity, false},
      Ranged{"area_fraction", row.area_fraction, 0.0, 1.0 + 1e-12, false},
      Ranged{"area_fraction_corrected", row.area_fraction_corrected, 0.0, 1.0,
             true},
      Ranged{"area_fraction_fit", row.area_fraction_fit, 0.0, 1.0, true},
      Ranged{"area_fraction_moment", row.area_fraction_moment, 0.0, 1.0, true},
      Ranged{"contact_perimeter", row.contact_perimeter, 0.0, infinity, false},
      Ranged{"elastic_energy", row.elastic_energy, -infinity, infinity, false},
      Ranged{"contact_energy", row.contact_energy, 0.0, infinity, false},
      Ranged{"residual", row.residual, 0.0, infinity, false},
      Ranged{"certified_gap_error", row.certified_gap_error, 0.0, infinity,
             true},
      Ranged{"estimated_gap_error", row.estimated_gap_error, 0.0, infinity,
             true},
      Ranged{"iterations", static_cast<double>(row.iterations), 0.0, infinity,
             false},
      Ranged{"cpu_time", row.cpu_time, 0.0, infinity, false}};
  for (const Ranged& number : numbers)
    if (auto failure = verify_range(number))
      return failure;
  if (row.status != results::StepStatus::converged)
    return Failure{"observables", "a row that did not converge"};
  return {};
}

} // namespace asperity::robustness
