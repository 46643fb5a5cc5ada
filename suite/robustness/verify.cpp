#include "suite/robustness/verify.hpp"

#include "base/field_sums.hpp"
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "contact/certificate/certificate.hpp"
#include "results/observables/observables.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::robustness {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Sums over N nodes and FFTs lose some ten eps; the remaining factor is a
/// margin.
constexpr double rounding_of_a_field = 64.0 * eps;

using contact::ContactSolution;
using mechanics::LoadTarget;

std::optional<Failure> verify_finite(const ContactSolution& solution) {
  for (const auto* field :
       {&solution.pressure, &solution.gap, &solution.displacement})
    if (!all_finite(*field))
      return Failure{"finite", "a field holds a number that is not finite"};
  if (!std::isfinite(solution.nominal_pressure) ||
      !std::isfinite(solution.mean_gap))
    return Failure{"finite", "a mean is not finite"};
  return {};
}

std::optional<Failure> verify_sign(const ContactSolution& solution) {
  const double lowest =
      *std::min_element(solution.pressure.begin(), solution.pressure.end());
  if (lowest < 0.0)
    return Failure{"pressure sign", fmt::format("p = {:.3g} Pa", lowest)};
  return {};
}

std::optional<Failure> verify_balance(const AskedContact& asked,
                                      const LoadTarget& target,
                                      const ContactSolution& solution) {
  const double mean = results::weighted_mean(solution.pressure, asked.weights);
  const bool by_pressure =
      target.control == mechanics::Control::nominal_pressure;
  const double asked_pressure =
      by_pressure ? target.amount : solution.nominal_pressure;
  const double off = std::abs(mean - asked_pressure);
  if (off > asked.load_tolerance * std::abs(asked_pressure))
    return Failure{
        "balance",
        fmt::format(
            "mean pressure {:.17g} Pa, prescribed or reported {:.17g} Pa", mean,
            asked_pressure)};
  const double gap_off = std::abs(solution.mean_gap - target.amount);
  const double allowed = asked.gap_tolerance + gap_rounding(asked, solution);
  if (!by_pressure && gap_off > allowed)
    return Failure{"balance",
                   fmt::format("mean gap differs by {:.3g} m, allowed {:.3g} m",
                               gap_off, allowed)};
  return {};
}

std::optional<Failure> verify_gap_field(const AskedContact& asked,
                                        const ContactSolution& solution,
                                        std::span<const double> displacement) {
  const double mean_height =
      results::weighted_mean(asked.heights, asked.weights);
  const double mean_displacement =
      results::weighted_mean(displacement, asked.weights);
  double off = 0.0;
  for (std::size_t i = 0; i < displacement.size(); ++i)
    off = std::max(
        off,
        std::abs(solution.mean_gap + (displacement[i] - mean_displacement) -
                 (asked.heights[i] - mean_height) - solution.gap[i]));
  const double allowed = asked.gap_tolerance + gap_rounding(asked, solution);
  if (off > allowed)
    return Failure{
        "gap field",
        fmt::format("differs by {:.3g} m, allowed {:.3g} m", off, allowed)};
  return {};
}

/// Verifies that separated surfaces carry no pressure. The check comes early
/// because, for a diverging pressure, the rounding of the gap, which grows with
/// the pressure, would hide any other error.
std::optional<Failure> verify_apart(const AskedContact& asked,
                                    const LoadTarget& target,
                                    const ContactSolution& solution) {
  const double clearance =
      target.amount + results::weighted_mean(asked.heights, asked.weights) -
      *std::max_element(asked.heights.begin(), asked.heights.end());
  const double rounding =
      rounding_of_a_field * largest_magnitude(asked.heights);
  const double highest = largest_magnitude(solution.pressure);
  if (target.control == mechanics::Control::mean_gap && clearance > rounding &&
      highest > 0.0)
    return Failure{"apart", fmt::format("p = {:.3g} Pa at {:.3g} m from the "
                                        "highest node",
                                        highest, clearance)};
  return {};
}

double energy_of(const AskedContact& asked, const ContactSolution& solution) {
  return results::elastic_energy(solution.pressure, solution.displacement,
                                 asked.weights) +
         results::contact_energy(solution.pressure, asked.local_compliance,
                                 asked.weights);
}

/// A number of a row with its admissible range.
struct Ranged {
  const char* name;
  double value;
  double low;
  double high;
  bool may_be_unknown = false; ///< NaN means "not determined"
};

} // namespace

double gap_rounding(const AskedContact& asked,
                    const ContactSolution& solution) {
  const double pressure = largest_magnitude(solution.pressure);
  // Rounding errors of equal terms are correlated: a plain sum of N terms loses
  // some N/8 eps.
  const double sum = 0.125 * eps * static_cast<double>(solution.gap.size());
  return rounding_of_a_field *
             (largest_magnitude(asked.heights) + std::abs(solution.mean_gap) +
              pressure * asked.long_wave_compliance) +
         (rounding_of_a_field + sum) * pressure * asked.local_compliance;
}

double allowed_gap(const AskedContact& asked, const ContactSolution& solution) {
  return 1.01 * asked.gap_tolerance + gap_rounding(asked, solution);
}

std::optional<Failure> verify_step(const AskedContact& asked,
                                   const LoadTarget& target,
                                   const ContactSolution& solution,
                                   const Displace& displace) {
  if (auto failure = verify_finite(solution))
    return failure;
  if (auto failure = verify_sign(solution))
    return failure;
  if (auto failure = verify_apart(asked, target, solution))
    return failure;
  if (auto failure = verify_balance(asked, target, solution))
    return failure;
  std::vector<double> displacement(solution.pressure.size());
  displace(solution.pressure, displacement);
  if (auto failure = verify_gap_field(asked, solution, displacement))
    return failure;
  return verify_contact(asked, solution);
}

std::optional<Failure> verify_contact(const AskedContact& asked,
                                      const ContactSolution& solution) {
  double overlap = 0.0;
  double open_contact = 0.0;
  for (std::size_t i = 0; i < solution.gap.size(); ++i) {
    const double clearance =
        solution.gap[i] + asked.local_compliance * solution.pressure[i];
    overlap = std::max(overlap, -clearance);
    if (solution.pressure[i] > 0.0)
      open_contact = std::max(open_contact, std::abs(clearance));
  }
  const double allowed = allowed_gap(asked, solution);
  const auto says = [&](double found) {
    return fmt::format("{:.3g} m, allowed {:.3g} m", found, allowed);
  };
  if (overlap > allowed)
    return Failure{"overlap", says(overlap)};
  if (open_contact > allowed)
    return Failure{"complementarity", says(open_contact)};
  return {};
}

std::optional<Failure> verify_row(const results::CurvePoint& row) {
  const double rounding = 1e-12;
  const bool is_adhesive = std::isfinite(row[columns::adhesive_energy]);
  const bool flows = std::isfinite(row[columns::plastic_strain]);
  for (const Ranged& number :
       {Ranged{"nominal_pressure", row.nominal_pressure,
               is_adhesive ? -infinity : 0.0, infinity},
        Ranged{"mean_gap", row.mean_gap, -infinity, infinity},
        Ranged{"area_fraction", row.area_fraction, 0.0, 1.0 + rounding},
        Ranged{"area_fraction_corrected", row.area_fraction_corrected, 0.0,
               1.0 + rounding, true},
        Ranged{"area_fraction_fit", row[columns::area_fraction_fit], 0.0, 1.0,
               true},
        Ranged{"area_fraction_moment", row[columns::area_fraction_moment], 0.0,
               1.0, true},
        Ranged{"contact_perimeter", row.contact_perimeter, 0.0, infinity, true},
        Ranged{"elastic_energy", row.elastic_energy, -infinity, infinity,
               flows},
        Ranged{"plastic_strain", row[columns::plastic_strain], 0.0, infinity,
               !flows},
        Ranged{"plastic_work", row[columns::plastic_work], 0.0, infinity,
               !flows},
        Ranged{"contact_energy", row.contact_energy, 0.0, infinity},
        Ranged{"residual", row.residual, 0.0, infinity},
        Ranged{"iterations", static_cast<double>(row.iterations), 0.0,
               infinity},
        Ranged{"cpu_time", row.cpu_time, 0.0, infinity},
        Ranged{"certified_gap_error", row[columns::certified_gap_error], 0.0,
               infinity, true},
        Ranged{"estimated_gap_error", row[columns::estimated_gap_error], 0.0,
               infinity, true}}) {
    const bool is_known = !number.may_be_unknown || !std::isnan(number.value);
    if (is_known &&
        !(std::isfinite(number.value) && number.value >= number.low &&
          number.value <= number.high))
      return Failure{"observables",
                     fmt::format("{} = {:.6g}, but must be finite and between "
                                 "{:g} and {:g}",
                                 number.name, number.value, number.low,
                                 number.high)};
  }
  if (row.status != results::StepStatus::converged)
    return Failure{"observables", "a row that did not converge"};
  return {};
}

std::optional<Failure>
verify_certificate(const AskedContact& asked, const ContactSolution& solution,
                   contact::SurfaceOperator& elasticity) {
  const double load = solution.nominal_pressure;
  if (!(load > 0.0))
    return {};
  const contact::FieldCheck check = contact::check_field(
      elasticity, {asked.heights, asked.local_compliance, load,
                   solution.pressure, solution.mean_gap});
  const double tolerance = allowed_gap(asked, solution);
  if (!(check.duality_gap <= 2.0 * load * tolerance))
    return Failure{"certificate",
                   fmt::format("duality gap {:.3g} J/m^2, allowed {:.3g} J/m^2",
                               check.duality_gap, 2.0 * load * tolerance)};
  if (!std::isfinite(check.mean_gap_error))
    return Failure{"certificate", "no bound of the mean gap"};
  return {};
}

StepSummary summary_of(const AskedContact& asked,
                       const ContactSolution& solution) {
  StepSummary summary;
  summary.may_lose_contact = asked.may_lose_contact;
  summary.nominal_pressure = solution.nominal_pressure;
  summary.mean_gap = solution.mean_gap;
  summary.separation = solution.mean_gap;
  if (asked.border == results::Border::free)
    summary.separation -=
        results::weighted_mean(solution.displacement, asked.weights);
  summary.energy = energy_of(asked, solution);
  summary.area = results::counted_area_fraction(
      results::ContactNodes::under(solution.pressure), asked.weights);
  summary.tolerance = allowed_gap(asked, solution);
  // The pressure that lifts a node by the tolerance, plus the rounding of the
  // pressures.
  const double lifting =
      10.0 * summary.tolerance /
          (asked.short_wave_compliance + asked.local_compliance) +
      rounding_of_a_field * largest_magnitude(solution.pressure);
  const auto marginal = std::count_if(
      solution.pressure.begin(), solution.pressure.end(),
      [&](double pressure) { return pressure > 0.0 && pressure <= lifting; });
  summary.marginal = static_cast<double>(marginal) /
                     static_cast<double>(solution.pressure.size());
  return summary;
}

std::optional<Failure> verify_pair(const StepSummary& first,
                                   const StepSummary& second) {
  // Without contact, equal (zero) pressures occur at different gaps.
  const bool is_ordered = first.nominal_pressure < second.nominal_pressure ||
                          (first.nominal_pressure == second.nominal_pressure &&
                           first.separation >= second.separation);
  const StepSummary& a = is_ordered ? first : second;
  const StepSummary& b = is_ordered ? second : first;
  const double tolerance = 2.0 * std::max(a.tolerance, b.tolerance);
  const double closing = a.separation - b.separation;
  if (closing < -tolerance)
    return Failure{"monotone gap",
                   fmt::format("the gap increases by {:.3g} m under increasing "
                               "load, allowed {:.3g} m",
                               -closing, tolerance)};
  if (!a.may_lose_contact &&
      b.area < a.area - 2.0 * a.marginal - rounding_of_a_field)
    return Failure{"monotone area",
                   fmt::format("the area decreases by {:.3g} under increasing "
                               "load, allowed {:.3g}",
                               a.area - b.area, 2.0 * a.marginal)};
  const double gained = b.energy - a.energy;
  const double allowed =
      2.0 * b.nominal_pressure * tolerance +
      rounding_of_a_field * (std::abs(a.energy) + std::abs(b.energy));
  if (gained < a.nominal_pressure * closing - allowed ||
      gained > b.nominal_pressure * closing + allowed)
    return Failure{"energy",
                   fmt::format("U increases by {:.6g} J/m^2, but p du is "
                               "{:.6g} to {:.6g} J/m^2, allowed {:.3g} J/m^2",
                               gained, a.nominal_pressure * closing,
                               b.nominal_pressure * closing, allowed)};
  return {};
}

std::optional<Failure> verify_same(const StepSummary& first,
                                   const StepSummary& second,
                                   double length_ratio, double pressure_ratio) {
  const double tolerance =
      2.0 * std::max(first.tolerance, second.tolerance / length_ratio);
  const double gap_off =
      std::abs(second.mean_gap / length_ratio - first.mean_gap);
  if (!(gap_off <= tolerance))
    return Failure{"same answer", fmt::format("gaps differ by {:.3g} m, "
                                              "allowed {:.3g} m",
                                              gap_off, tolerance)};
  const double energy_off =
      std::abs(second.energy / (length_ratio * pressure_ratio) - first.energy);
  const double allowed = 2.0 * first.nominal_pressure * tolerance +
                         2.0 * rounding_of_a_field * std::abs(first.energy);
  if (!(energy_off <= allowed))
    return Failure{"same answer",
                   fmt::format("energies differ by {:.3g} J/m^2, allowed "
                               "{:.3g} J/m^2",
                               energy_off, allowed)};
  return {};
}

} // namespace asperity::robustness
