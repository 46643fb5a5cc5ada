#include "contact/certificate/certificate.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"
#include "contact/certificate/weighted.hpp"
#include "contact/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::contact {
namespace {

/// The larger of the numbers of all ranks.
double largest_of_ranks(const SharedRows* rows, double own) {
  return in_order(rows, own,
                  [=](double& so_far) { so_far = std::max(so_far, own); });
}

double largest_of(std::span<const double> values,
                  const SharedRows* rows = nullptr) {
  return largest_of_ranks(rows, *std::ranges::max_element(values));
}

double largest_size(std::span<const double> values,
                    const SharedRows* rows = nullptr) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  return largest_of_ranks(rows, largest);
}

bool all_finite_on_ranks(std::span<const double> values,
                         const SharedRows* rows) {
  return sum_of_ranks(rows, all_finite(values) ? 0 : 1) == 0;
}

/// Cuts off tension and scales the mean to p_0.
std::vector<double> projected(std::span<const double> pressure,
                              const Weighted& weighted, double mean_pressure) {
  std::vector<double> result(pressure.begin(), pressure.end());
  for (double& value : result)
    value = std::max(value, 0.0);
  const double mean_value = weighted.mean_of(result);
  if (!(mean_value > 0.0))
    throw std::domain_error(
        "no node of the submitted field has a pressure > 0");
  for (double& value : result)
    value *= mean_pressure / mean_value;
  return result;
}

void require_sound(const SurfaceOperator& elasticity,
                   const SubmittedField& submitted) {
  const std::size_t nodes = elasticity.n_nodes();
  const SharedRows* const rows = elasticity.shared_rows();
  if (submitted.heights.size() != nodes || submitted.pressure.size() != nodes)
    throw std::domain_error(
        "heights and pressure must have one value for each node of the grid");
  if (!all_finite_on_ranks(submitted.heights, rows) ||
      !all_finite_on_ranks(submitted.pressure, rows))
    throw std::domain_error("heights and pressure must be finite");
  require_positive("nominal_pressure", submitted.nominal_pressure, "Pa");
  require_not_negative("local_compliance", submitted.local_compliance, "m/Pa");
}

/// A pressure >= 0 of mean p_0 with what the bounds need of it.
struct Feasible {
  std::vector<double> pressure;
  std::vector<double> displacement; ///< (C + c) p [m]
  std::vector<double> excess;       ///< h - (C + c) p [m]
  double lift = 0.0;       ///< mean of C p; 0 on a periodic surface [m]
  double separation = 0.0; ///< smallest u with gap >= 0 everywhere [m]
  double roundoff = 0.0;   ///< of any value of displacement [m]
};

/// The transforms of the operator have a relative roundoff of order
/// eps log2(nodes), by the largest value of the field.
double roundoff_of(std::span<const double> displacement,
                   std::span<const double> heights, const SharedRows* rows) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return 8.0 * epsilon *
         std::log2(static_cast<double>(
             std::max<std::size_t>(all_nodes(rows, heights.size()), 2))) *
         (largest_size(displacement, rows) + largest_size(heights, rows));
}

Feasible feasible(SurfaceOperator& elasticity, const SubmittedField& problem,
                  std::vector<double> pressure) {
  Feasible answer;
  const std::size_t nodes = pressure.size();
  answer.displacement.resize(nodes);
  elasticity.displacement(pressure, answer.displacement);
  if (!elasticity.is_periodic())
    answer.lift =
        Weighted(elasticity.nodal_weights()).mean_of(answer.displacement);
  answer.excess.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    answer.displacement[i] += problem.local_compliance * pressure[i];
    answer.excess[i] = problem.heights[i] - answer.displacement[i];
  }
  const SharedRows* const rows = elasticity.shared_rows();
  answer.separation = largest_of(answer.excess, rows);
  answer.roundoff = roundoff_of(answer.displacement, problem.heights, rows);
  answer.pressure = std::move(pressure);
  return answer;
}

/// G = <p, g> with its allowance for roundoff.
double duality_gap(const Feasible& answer, const Weighted& weighted,
                   double mean_pressure) {
  const double gap = answer.separation * mean_pressure -
                     weighted.product(answer.pressure, answer.excess);
  return std::max(gap, 0.0) + 2.0 * answer.roundoff * mean_pressure;
}

/// The largest |<p, g*> + <p - p*, C p>|/p_0 that G allows, since <p, g*> and
/// |p - p*|^2 are parts of it.
double separation_error(double duality_gap, double twice_stored,
                        double mean_pressure) {
  const double distance = std::sqrt(duality_gap);
  const double size = std::sqrt(twice_stored);
  const double work = 2.0 * distance <= size
                          ? distance * size
                          : duality_gap + 0.25 * twice_stored;
  return work / mean_pressure;
}

/// Bounds |<C (p - p*)>|, by which G leaves the mean gap undetermined besides
/// the separation: it is the product of p - p* and 1 in the energy norm. 0 on a
/// periodic surface.
double lift_error(SurfaceOperator& elasticity, const Weighted& weighted,
                  double duality_gap) {
  if (elasticity.is_periodic())
    return 0.0;
  const std::vector<double> ones(elasticity.grid().size(), 1.0);
  std::vector<double> displacement(ones.size());
  elasticity.displacement(ones, displacement);
  return std::sqrt(duality_gap * weighted.mean_of(displacement));
}

ContactSolution solve(SurfaceOperator& elasticity,
                      const SubmittedField& problem,
                      std::span<const double> heights, double tolerance,
                      std::span<const double> first_guess) {
  return solve_contact(
      elasticity, {heights, problem.local_compliance, tolerance, 500},
      {mechanics::Control::nominal_pressure, problem.nominal_pressure},
      first_guess);
}

/// The pressure of a flat punch whose face is where `contact` has a pressure.
ContactSolution flat_punch(SurfaceOperator& elasticity,
                           const SubmittedField& problem,
                           const Feasible& contact) {
  const double depth = 1e3 * (largest_size(contact.displacement) +
                              largest_size(problem.heights));
  std::vector<double> face(contact.pressure.size());
  for (std::size_t i = 0; i < face.size(); ++i)
    face[i] = contact.pressure[i] > 0.0 ? 0.0 : -depth;
  return solve(elasticity, problem, face, 4.0 * contact.roundoff,
               contact.pressure);
}

/// Returns the least a + max(b, b') G/p_0 with nu <= b' p and
/// kappa - C nu <= a + b g at every node, over a series of b >= b'.
double excess_of_high(const Feasible& answer, const Feasible& punch,
                      double gap_over_load) {
  double ratio = 0.0; // b'
  for (std::size_t i = 0; i < punch.pressure.size(); ++i)
    if (punch.pressure[i] > 0.0)
      ratio = answer.pressure[i] > 0.0
                  ? std::max(ratio, punch.pressure[i] / answer.pressure[i])
                  : std::numeric_limits<double>::infinity();
  const double top = largest_of(punch.displacement);
  double least = std::numeric_limits<double>::infinity();
  for (double b = ratio; std::isfinite(b) && b < 1e12 * ratio; b *= 2.0) {
    double a = 0.0;
    for (std::size_t i = 0; i < answer.excess.size(); ++i)
      a = std::max(a, top - punch.displacement[i] -
                          b * (answer.separation - answer.excess[i]));
    // The roundoff of the gap enters with the factor b.
    const double roundoff = 2.0 * punch.roundoff + 2.0 * b * answer.roundoff;
    least = std::min(least, a + roundoff + b * gap_over_load);
  }
  return least;
}

} // namespace

FieldCheck check_field(SurfaceOperator& elasticity,
                       const SubmittedField& submitted) {
  require_sound(elasticity, submitted);
  const SharedRows* const rows = elasticity.shared_rows();
  const Weighted weighted(elasticity.nodal_weights(), rows);
  FieldCheck check;
  check.load_error =
      weighted.mean_of(submitted.pressure) / submitted.nominal_pressure - 1.0;
  for (const double pressure : submitted.pressure) {
    check.largest_tension = std::max(check.largest_tension, -pressure);
    check.nodes_in_tension += pressure < 0.0 ? 1 : 0;
  }
  check.largest_tension = largest_of_ranks(rows, check.largest_tension);
  check.nodes_in_tension = sum_of_ranks(rows, check.nodes_in_tension);
  const Feasible answer = feasible(
      elasticity, submitted,
      projected(submitted.pressure, weighted, submitted.nominal_pressure));
  const std::size_t nodes = answer.pressure.size();
  const double separation = weighted.product(answer.pressure, answer.excess) /
                            submitted.nominal_pressure;
  check.mean_gap =
      separation + answer.lift - weighted.mean_of(submitted.heights);
  const auto gap = [&](std::size_t i) { return separation - answer.excess[i]; };
  const auto overlap = [&](std::size_t i) { return std::max(-gap(i), 0.0); };
  check.area_fraction = weighted.mean(nodes, [&](std::size_t i) {
    return answer.pressure[i] > 0.0 ? 1.0 : 0.0;
  });
  check.complementarity = weighted.mean(nodes, [&](std::size_t i) {
    return answer.pressure[i] * std::abs(gap(i));
  }) / submitted.nominal_pressure;
  double deepest = 0.0;
  for (std::size_t i = 0; i < nodes; ++i)
    deepest = std::max(deepest, overlap(i));
  check.largest_penetration = largest_of_ranks(rows, deepest);
  check.rms_penetration = std::sqrt(weighted.mean(
      nodes, [&](std::size_t i) { return overlap(i) * overlap(i); }));
  const double twice_stored =
      weighted.product(answer.pressure, answer.displacement);
  check.elastic_energy =
      0.5 *
      (twice_stored - submitted.local_compliance *
                          weighted.product(answer.pressure, answer.pressure));
  check.duality_gap = duality_gap(answer, weighted, submitted.nominal_pressure);
  check.pressure_error = std::sqrt(2.0 * check.duality_gap / twice_stored);
  const double deviation = std::isfinite(submitted.mean_gap)
                               ? std::abs(submitted.mean_gap - check.mean_gap) +
                                     2.0 * answer.roundoff
                               : 0.0;
  check.mean_gap_error = deviation +
                         separation_error(check.duality_gap, twice_stored,
                                          submitted.nominal_pressure) +
                         lift_error(elasticity, weighted, check.duality_gap);
  return check;
}

SeparationBounds bound_separation(SurfaceOperator& elasticity,
                                  const SubmittedField& submitted) {
  require_sound(elasticity, submitted);
  const Weighted weighted(elasticity.nodal_weights());
  const double load = submitted.nominal_pressure;
  const Feasible first = feasible(
      elasticity, submitted, projected(submitted.pressure, weighted, load));
  const ContactSolution further =
      solve(elasticity, submitted, submitted.heights, 4.0 * first.roundoff,
            first.pressure);
  Feasible answer = feasible(elasticity, submitted,
                             projected(further.pressure, weighted, load));
  if (duality_gap(first, weighted, load) < duality_gap(answer, weighted, load))
    answer = first;
  const ContactSolution pressed = flat_punch(elasticity, submitted, answer);
  const Feasible punch = feasible(elasticity, submitted,
                                  projected(pressed.pressure, weighted, load));

  SeparationBounds bounds;
  bounds.solver_iterations = further.iterations + pressed.iterations;
  bounds.polished_gap = duality_gap(answer, weighted, load);
  const double mean_height = weighted.mean_of(submitted.heights);
  const double low =
      weighted.product(punch.pressure, submitted.heights) / load -
      largest_of(punch.displacement) - mean_height + answer.lift;
  const double roundoff = 2.0 * punch.roundoff +
                          lift_error(elasticity, weighted, bounds.polished_gap);
  bounds.low = low - roundoff;
  bounds.high = low + roundoff +
                excess_of_high(answer, punch, bounds.polished_gap / load);
  const double claimed =
      std::isfinite(submitted.mean_gap)
          ? submitted.mean_gap
          : weighted.product(first.pressure, first.excess) / load + first.lift -
                mean_height;
  bounds.error =
      std::max(std::abs(claimed - bounds.low), std::abs(bounds.high - claimed));
  return bounds;
}

} // namespace asperity::contact
