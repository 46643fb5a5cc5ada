#include "contact/certificate/certificate.hpp"

#include "base/array_memory.hpp"
#include "contact/certificate/feasible.hpp"
#include "contact/solvers/solver.hpp"
#include "mechanics/contact_nodes.hpp"

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
  double hardness; ///< less the precision of stored fields
};

/// Fills area, complementarity and penetration at a separation.
void find_gap_errors(const Feasible& answer, const Weighted& weighted,
                     const Workers& workers, const SeparationAndLoad& at,
                     FieldCheck& check) {
  const std::size_t nodes = answer.pressure.size();
  const auto gap = [&](std::size_t i) {
    const double own = at.separation - answer.excess(i);
    return answer.pressure[i] >= at.hardness ? std::max(0.0, own) : own;
  };
  const auto contact = mechanics::ContactNodes::under(answer.pressure);
  const std::array<double, 3> means =
      weighted.means<3>(nodes, [&](std::size_t i) {
        const double p = answer.pressure[i];
        const double overlap = std::max(-gap(i), 0.0);
        return std::array{contact.in_contact(i) ? 1.0 : 0.0,
                          p * std::abs(gap(i)), overlap * overlap};
      });
  check.area_fraction = means[0];
  check.complementarity = means[1] / at.load;
  check.rms_penetration = std::sqrt(means[2]);
  check.largest_penetration =
      std::isfinite(at.hardness)
          ? std::max(0.0, largest_term(nodes, workers,
                                       [&](std::size_t i) { return -gap(i); }))
          : std::max(0.0, answer.separation - at.separation);
}

/// C 1: the displacement of a uniform pressure 1 [m/Pa]. Empty on a periodic
/// surface, where it is 0.
std::vector<double> uniform_displacement(SurfaceOperator& elasticity) {
  if (elasticity.is_periodic())
    return {};
  const std::vector<double> ones(elasticity.n_nodes(), 1.0);
  std::vector<double> displacement(ones.size());
  elasticity.displacement(ones, displacement);
  return displacement;
}

double mean_or_0(const Weighted& weighted, std::span<const double> field) {
  return field.empty() ? 0.0 : weighted.mean_of(field);
}

/// Weighted means of a pressure a and of its displacement w = (C + c) a.
struct PressureMeans {
  double product, pressure, displacement; ///< <a, w>, <a>, <w>

  /// |a - <a>|^2.
  /// @param of_uniform  <1, (C + c) 1>
  double square_variation(double of_uniform) const {
    return std::max(0.0, product - 2.0 * pressure * displacement +
                             pressure * pressure * of_uniform);
  }
};

PressureMeans means_of(const Weighted& weighted, std::span<const double> a,
                       std::span<const double> w) {
  const std::array<double, 3> means =
      weighted.means<3>(a.size(), [&](std::size_t i) {
        return std::array{a[i] * w[i], a[i], w[i]};
      });
  return {means[0], means[1], means[2]};
}

/// The largest |U_p - U*| that G allows, by (3) of
/// docs/numerics/certificate.md.
/// @param of_uniform  <1, (C + c) 1>
double separation_error(const Feasible& answer, const PressureMeans& means,
                        double duality_gap, double of_uniform) {
  const double square = means.square_variation(of_uniform) +
                        4.0 * answer.roundoff * means.pressure;
  const double distance = std::sqrt(duality_gap);
  const double size = std::sqrt(square);
  const double work =
      2.0 * distance <= size ? distance * size : duality_gap + 0.25 * square;
  return work / means.pressure;
}

/// The part b = p (1 - p/H) of the pressure that can grow and fall: its means,
/// and the separation at which it does no work on the gap.
struct ElasticPart {
  PressureMeans means;
  double separation; ///< [m]
};

ElasticPart elastic_part(SurfaceOperator& elasticity,
                         const SubmittedField& problem, const Feasible& answer,
                         const Weighted& weighted) {
  const std::size_t nodes = answer.pressure.size();
  std::vector<double> part(nodes), displacement(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double p = answer.pressure[i];
    part[i] = p * std::max(0.0, 1.0 - p / problem.hardness);
  }
  elasticity.displacement(part, displacement);
  for (std::size_t i = 0; i < nodes; ++i)
    displacement[i] += problem.local_compliance * part[i];
  const PressureMeans means = means_of(weighted, part, displacement);
  if (!(means.pressure > 0.0))
    throw std::domain_error("no node has a pressure between 0 and the "
                            "hardness, so that any separation is possible");
  const double work = weighted.mean(
      nodes, [&](std::size_t i) { return part[i] * answer.excess(i); });
  return {means, work / means.pressure};
}

ContactSolution solve(SurfaceOperator& elasticity,
                      const SubmittedField& problem,
                      std::span<const double> heights, double tolerance,
                      std::span<const double> first_guess) {
  return solve_contact(
      elasticity,
      {heights, problem.local_compliance, tolerance, 500, problem.hardness},
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

/// The pressure whose displacement differs from that of a uniform one by a
/// constant where `contact` has a pressure, and which is 0 elsewhere: that of a
/// flat punch if the surface is periodic. The displacement of `contact` is
/// freed in between.
/// @param uniform  p_0 C 1; empty: 0
Solved punch_pressure(SurfaceOperator& elasticity,
                      const SubmittedField& problem, Feasible& contact,
                      std::span<const double> uniform) {
  const Workers workers = elasticity.workers();
  std::vector<double> face(uniform.begin(), uniform.end());
  face.resize(contact.pressure.size());
  const double depth = 1e3 * (largest_size(contact.displacement, workers) +
                              largest_size(problem.heights, workers) +
                              largest_size(face, workers));
  free_memory(contact.displacement);
  const auto nodes = mechanics::ContactNodes::under(contact.pressure);
  for (std::size_t i = 0; i < face.size(); ++i)
    face[i] -= nodes.in_contact(i) ? 0.0 : depth;
  ContactSolution pressed = solve(elasticity, problem, face,
                                  4.0 * contact.roundoff, contact.pressure);
  return {std::move(pressed.pressure), pressed.iterations};
}

/// Returns the least a + max(b, b') G/p_0 of (6), over a series of b >= b'.
/// @param punch  nu, and its displacement less that of a uniform pressure
/// @param top    kappa [m]
double excess_of_high(const Feasible& answer, const Feasible& punch, double top,
                      double gap_over_load) {
  const auto carries = mechanics::ContactNodes::under(answer.pressure);
  const auto pressed = mechanics::ContactNodes::under(punch.pressure);
  double ratio = 0.0; // b'
  for (std::size_t i = 0; i < pressed.size(); ++i)
    if (pressed.in_contact(i))
      ratio = carries.in_contact(i)
                  ? std::max(ratio, punch.pressure[i] / answer.pressure[i])
                  : std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  for (double b = ratio; std::isfinite(b) && b < 1e12 * ratio; b *= 2.0) {
    double a = 0.0;
    for (std::size_t i = 0; i < answer.pressure.size(); ++i)
      a = std::max(a, top - punch.displacement[i] - b * answer.gap(i));
    // The roundoff of the gap enters with the factor b.
    const double roundoff = 2.0 * punch.roundoff + 2.0 * b * answer.roundoff;
    least = std::min(least, a + roundoff + b * gap_over_load);
  }
  return least;
}

/// Returns the least bound of U* - U by (4), over a series of 0 < t <= 1.
/// @param punch       nu
/// @param of_uniform  <1, (C + c) 1>
double excess_of_unloading(SurfaceOperator& elasticity,
                           const SubmittedField& problem,
                           const Feasible& answer, const Feasible& punch,
                           double of_uniform) {
  const std::size_t nodes = answer.pressure.size();
  const Weighted weighted(elasticity.nodal_weights(), elasticity.workers());
  std::vector<double> change(nodes), displacement(nodes);
  double least = std::numeric_limits<double>::infinity();
  double last = least;
  for (double t = 1.0; t > 1e-12 && !(last > 16.0 * least); t *= 0.25) {
    for (std::size_t i = 0; i < nodes; ++i)
      change[i] = -std::min(t * punch.pressure[i], answer.pressure[i]);
    elasticity.displacement(change, displacement);
    for (std::size_t i = 0; i < nodes; ++i)
      displacement[i] += problem.local_compliance * change[i];
    const PressureMeans means = means_of(weighted, change, displacement);
    const double removed = -means.pressure;
    const double work = weighted.mean(nodes, [&](std::size_t i) {
      return answer.gap(i) * (answer.pressure[i] + change[i]);
    });
    // The roundoff of g enters with <q> and <p*>, and that of d.
    const double roundoff =
        2.0 * answer.roundoff * (1.0 + problem.nominal_pressure / removed) +
        2.0 * t * punch.roundoff;
    last =
        (work + 0.25 * means.square_variation(of_uniform)) / removed + roundoff;
    least = std::min(least, last);
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
  const double compliance = submitted.local_compliance;
  FieldCheck check;
  check.load_error = weighted.mean_of(submitted.pressure) / load - 1.0;
  check.largest_tension = defects.largest_tension;
  check.nodes_in_tension = defects.in_tension;
  Feasible answer = feasible(elasticity, submitted, pressure_of(submitted));
  const EnergyMeans means = energy_means(answer, weighted, submitted.heights);
  const double twice_stored = means.pressure_displacement;
  PressureMeans by{twice_stored, load, answer.lift + compliance * load};
  double separation = means.pressure_excess / load;
  if (std::isfinite(submitted.hardness)) {
    const ElasticPart part =
        elastic_part(elasticity, submitted, answer, weighted);
    by = part.means;
    separation = part.separation;
  }
  check.mean_gap = separation + answer.lift - means.height;
  check.elastic_energy =
      0.5 * (twice_stored - compliance * means.square_pressure);
  check.duality_gap = duality_gap(answer, means.pressure_excess, load);
  check.pressure_error = std::sqrt(2.0 * check.duality_gap / twice_stored);
  constexpr double stored = 1e-6; // a pressure in single precision
  find_gap_errors(answer, weighted, workers,
                  {separation, load, (1.0 - stored) * submitted.hardness},
                  check);
  const double deviation = std::isfinite(submitted.mean_gap)
                               ? std::abs(submitted.mean_gap - check.mean_gap) +
                                     2.0 * answer.roundoff
                               : 0.0;
  free_memory(answer.pressure); // before another displacement is found
  free_memory(answer.displacement);
  const double of_uniform =
      compliance + mean_or_0(weighted, uniform_displacement(elasticity));
  check.mean_gap_error =
      deviation + separation_error(answer, by, check.duality_gap, of_uniform);
  return check;
}

namespace {

/// The submitted pressure solved further, unless that leads away from the
/// answer.
/// @param answer  of the submitted pressure
Feasible solved_further(SurfaceOperator& elasticity,
                        const SubmittedField& submitted,
                        const Weighted& weighted, Feasible answer,
                        int& iterations) {
  const double load = submitted.nominal_pressure;
  const double first_gap = duality_gap(answer, weighted, load);
  free_memory(answer.displacement); // as all fields before a solver
  Solved further = polish(elasticity, submitted, answer);
  iterations = further.iterations;
  answer = feasible(elasticity, submitted, std::move(further.pressure));
  return first_gap < duality_gap(answer, weighted, load)
             ? feasible(elasticity, submitted, pressure_of(submitted))
             : answer;
}

/// The mean gap U_p by a pressure [m].
double mean_gap_of(SurfaceOperator& elasticity, const SubmittedField& submitted,
                   const Feasible& pressed, const Weighted& weighted) {
  const double separation =
      std::isfinite(submitted.hardness)
          ? elastic_part(elasticity, submitted, pressed, weighted).separation
          : pressed.pressure_excess(weighted) / submitted.nominal_pressure;
  return separation + pressed.lift - weighted.mean_of(submitted.heights);
}

/// The bounds with the distance of a claimed mean gap from the further one.
SeparationBounds with_error(SeparationBounds bounds, double claimed) {
  bounds.error =
      std::max(std::abs(claimed - bounds.low), std::abs(bounds.high - claimed));
  return bounds;
}

/// The bounds with a hardness, by (3) alone.
/// @param answer  solved further
void bound_by_pressure(SurfaceOperator& elasticity,
                       const SubmittedField& submitted, const Feasible& answer,
                       const Weighted& weighted, SeparationBounds& bounds) {
  const ElasticPart part =
      elastic_part(elasticity, submitted, answer, weighted);
  bounds.polished_gap =
      duality_gap(answer, weighted, submitted.nominal_pressure);
  const double of_uniform =
      submitted.local_compliance +
      mean_or_0(weighted, uniform_displacement(elasticity));
  const double error =
      4.0 * answer.roundoff +
      separation_error(answer, part.means, bounds.polished_gap, of_uniform);
  const double mean_gap =
      part.separation + answer.lift - weighted.mean_of(submitted.heights);
  bounds.low = mean_gap - error;
  bounds.high = mean_gap + error;
}

} // namespace

SeparationBounds bound_separation(SurfaceOperator& elasticity,
                                  const SubmittedField& submitted) {
  static_cast<void>(sound_or_refused(elasticity, submitted));
  const Workers workers = elasticity.workers();
  const Weighted weighted(elasticity.nodal_weights(), workers);
  const double load = submitted.nominal_pressure;
  const double mean_height = weighted.mean_of(submitted.heights);
  Feasible answer = feasible(elasticity, submitted, pressure_of(submitted));
  const double claimed =
      std::isfinite(submitted.mean_gap)
          ? submitted.mean_gap
          : mean_gap_of(elasticity, submitted, answer, weighted);
  SeparationBounds bounds;
  answer = solved_further(elasticity, submitted, weighted, std::move(answer),
                          bounds.solver_iterations);
  if (std::isfinite(submitted.hardness)) {
    bound_by_pressure(elasticity, submitted, answer, weighted, bounds);
    return with_error(bounds, claimed);
  }
  bounds.polished_gap = duality_gap(answer, weighted, load);
  std::vector<double> uniform = uniform_displacement(elasticity);
  const double of_uniform =
      submitted.local_compliance + mean_or_0(weighted, uniform);
  for (double& value : uniform)
    value *= load;
  Solved pressed = punch_pressure(elasticity, submitted, answer, uniform);
  bounds.solver_iterations += pressed.iterations;
  Feasible punch = feasible(elasticity, submitted, std::move(pressed.pressure));
  displace(elasticity, submitted, answer);

  // (3)
  const double error =
      4.0 * answer.roundoff +
      separation_error(answer,
                       means_of(weighted, answer.pressure, answer.displacement),
                       bounds.polished_gap, of_uniform);
  const double own = mean_gap_of(elasticity, submitted, answer, weighted);
  bounds.low = own - error;
  bounds.high = own + error;
  // (4)
  bounds.high =
      std::min(bounds.high, answer.separation + answer.lift - mean_height +
                                4.0 * answer.roundoff +
                                excess_of_unloading(elasticity, submitted,
                                                    answer, punch, of_uniform));

  // (5) and (6)
  for (std::size_t i = 0; i < uniform.size(); ++i)
    punch.displacement[i] -= uniform[i];
  const double top = largest_of(punch.displacement, workers); // kappa
  const double by_punch =
      weighted.product(punch.pressure, submitted.heights) / load - top -
      mean_height;
  const double roundoff = 4.0 * punch.roundoff;
  bounds.low = std::max(bounds.low, by_punch - roundoff);
  bounds.high =
      std::min(bounds.high, by_punch + roundoff +
                                excess_of_high(answer, punch, top,
                                               bounds.polished_gap / load));
  return with_error(bounds, claimed);
}

} // namespace asperity::contact
