#include "contact/certificate/certificate.hpp"

#include "base/array_memory.hpp"
#include "contact/certificate/feasible.hpp"
#include "contact/solvers/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace asperity::contact {
namespace {

/// Weighted means of a Feasible and the heights.
struct EnergyMeans {
  double pressure_excess, pressure_displacement, square_pressure, height;
};

EnergyMeans energy_means(const Feasible& answer, const Weighted& weighted,
                         std::span<const double> heights) {
  const std::array<double, 4> means =
      weighted.means<4>(heights.size(), [&](std::size_t i) {
        const double p = answer.pressure[i];
        return std::array{p * answer.excess(i), p * answer.displacement[i],
                          p * p, heights[i]};
      });
  return {means[0], means[1], means[2], means[3]};
}

struct SeparationAndLoad {
  double separation, load;
};

/// Fills area, complementarity and penetration at a separation.
void find_gap_errors(const Feasible& answer, const Weighted& weighted,
                     const SeparationAndLoad& at, FieldCheck& check) {
  const std::size_t nodes = answer.pressure.size();
  const auto gap = [&](std::size_t i) {
    return at.separation - answer.excess(i);
  };
  const std::array<double, 3> means =
      weighted.means<3>(nodes, [&](std::size_t i) {
        const double p = answer.pressure[i];
        const double overlap = std::max(-gap(i), 0.0);
        return std::array{p > 0.0 ? 1.0 : 0.0, p * std::abs(gap(i)),
                          overlap * overlap};
      });
  check.area_fraction = means[0];
  check.complementarity = means[1] / at.load;
  check.rms_penetration = std::sqrt(means[2]);
  check.largest_penetration = std::max(0.0, answer.separation - at.separation);
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
  const std::vector<double> ones(elasticity.n_nodes(), 1.0);
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

/// A copy of the submitted pressure.
std::vector<double> pressure_of(const SubmittedField& submitted) {
  return {submitted.pressure.begin(), submitted.pressure.end()};
}

/// A pressure that solves a contact problem; other fields of it are freed.
struct Solved {
  std::vector<double> pressure;
  int iterations = 0;
};

/// The submitted pressure, solved further.
Solved polish(SurfaceOperator& elasticity, const SubmittedField& problem,
              const Feasible& first) {
  ContactSolution further = solve(elasticity, problem, problem.heights,
                                  4.0 * first.roundoff, first.pressure);
  return {std::move(further.pressure), further.iterations};
}

/// The pressure of a flat punch whose face is where `contact` has a pressure.
/// The displacement of `contact` is freed in between.
Solved flat_punch(SurfaceOperator& elasticity, const SubmittedField& problem,
                  Feasible& contact) {
  const Workers workers = elasticity.workers();
  const double depth = 1e3 * (largest_size(contact.displacement, workers) +
                              largest_size(problem.heights, workers));
  free_memory(contact.displacement);
  std::vector<double> face(contact.pressure.size());
  for (std::size_t i = 0; i < face.size(); ++i)
    face[i] = contact.pressure[i] > 0.0 ? 0.0 : -depth;
  ContactSolution pressed = solve(elasticity, problem, face,
                                  4.0 * contact.roundoff, contact.pressure);
  return {std::move(pressed.pressure), pressed.iterations};
}

/// Returns the least a + max(b, b') G/p_0 with nu <= b' p and
/// kappa - C nu <= a + b g at every node, over a series of b >= b'.
/// @param top  largest displacement of the punch [m]
double excess_of_high(const Feasible& answer, const Feasible& punch, double top,
                      double gap_over_load) {
  double ratio = 0.0; // b'
  for (std::size_t i = 0; i < punch.pressure.size(); ++i)
    if (punch.pressure[i] > 0.0)
      ratio = answer.pressure[i] > 0.0
                  ? std::max(ratio, punch.pressure[i] / answer.pressure[i])
                  : std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  for (double b = ratio; std::isfinite(b) && b < 1e12 * ratio; b *= 2.0) {
    double a = 0.0;
    for (std::size_t i = 0; i < answer.pressure.size(); ++i)
      a = std::max(a, top - punch.displacement[i] -
                          b * (answer.separation - answer.excess(i)));
    // The roundoff of the gap enters with the factor b.
    const double roundoff = 2.0 * punch.roundoff + 2.0 * b * answer.roundoff;
    least = std::min(least, a + roundoff + b * gap_over_load);
  }
  return least;
}

} // namespace

FieldCheck check_field(SurfaceOperator& elasticity,
                       const SubmittedField& submitted) {
  const Defects defects = sound_or_refused(elasticity, submitted);
  const Workers workers = elasticity.workers();
  const Weighted weighted(elasticity.nodal_weights(), workers);
  const double load = submitted.nominal_pressure;
  FieldCheck check;
  check.load_error = weighted.mean_of(submitted.pressure) / load - 1.0;
  check.largest_tension = defects.largest_tension;
  check.nodes_in_tension = defects.in_tension;
  const Feasible answer =
      feasible(elasticity, submitted, pressure_of(submitted));
  const EnergyMeans means = energy_means(answer, weighted, submitted.heights);
  const double separation = means.pressure_excess / load;
  check.mean_gap = separation + answer.lift - means.height;
  const double twice_stored = means.pressure_displacement;
  check.elastic_energy =
      0.5 * (twice_stored - submitted.local_compliance * means.square_pressure);
  check.duality_gap = duality_gap(answer, means.pressure_excess, load);
  check.pressure_error = std::sqrt(2.0 * check.duality_gap / twice_stored);
  find_gap_errors(answer, weighted, {separation, load}, check);
  const double deviation = std::isfinite(submitted.mean_gap)
                               ? std::abs(submitted.mean_gap - check.mean_gap) +
                                     2.0 * answer.roundoff
                               : 0.0;
  check.mean_gap_error =
      deviation + separation_error(check.duality_gap, twice_stored, load) +
      lift_error(elasticity, weighted, check.duality_gap);
  return check;
}

SeparationBounds bound_separation(SurfaceOperator& elasticity,
                                  const SubmittedField& submitted) {
  static_cast<void>(sound_or_refused(elasticity, submitted));
  const Workers workers = elasticity.workers();
  const Weighted weighted(elasticity.nodal_weights(), workers);
  const double load = submitted.nominal_pressure;
  const double mean_height = weighted.mean_of(submitted.heights);
  Feasible answer = feasible(elasticity, submitted, pressure_of(submitted));
  const double first_gap = duality_gap(answer, weighted, load);
  const double claimed =
      std::isfinite(submitted.mean_gap)
          ? submitted.mean_gap
          : answer.pressure_excess(weighted) / load + answer.lift - mean_height;
  free_memory(answer.displacement); // as all fields before a solver
  Solved further = polish(elasticity, submitted, answer);
  answer = feasible(elasticity, submitted, std::move(further.pressure));
  if (first_gap < duality_gap(answer, weighted, load))
    answer = feasible(elasticity, submitted, pressure_of(submitted));
  SeparationBounds bounds;
  bounds.polished_gap = duality_gap(answer, weighted, load);
  Solved pressed = flat_punch(elasticity, submitted, answer);
  bounds.solver_iterations = further.iterations + pressed.iterations;
  const Feasible punch =
      feasible(elasticity, submitted, std::move(pressed.pressure));
  displace(elasticity, submitted, answer);

  const double top = largest_of(punch.displacement, workers);
  const double low =
      weighted.product(punch.pressure, submitted.heights) / load - top -
      mean_height + answer.lift;
  const double roundoff = 2.0 * punch.roundoff +
                          lift_error(elasticity, weighted, bounds.polished_gap);
  bounds.low = low - roundoff;
  bounds.high = low + roundoff +
                excess_of_high(answer, punch, top, bounds.polished_gap / load);
  bounds.error =
      std::max(std::abs(claimed - bounds.low), std::abs(bounds.high - claimed));
  return bounds;
}

} // namespace asperity::contact
