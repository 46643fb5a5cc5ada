#include "contact/certificate/feasible.hpp"

#include "base/require.hpp"
#include "contact/solvers/starting_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace asperity::contact {
namespace {

/// Cuts off tension and scales the mean to p_0.
void project(std::vector<double>& pressure, SurfaceOperator& elasticity,
             const SubmittedField& problem) {
  const Workers workers = elasticity.workers();
  const Weighted weighted(elasticity.nodal_weights(), workers);
  const double mean_value = weighted.mean(pressure.size(), [&](std::size_t i) {
    return std::max(pressure[i], 0.0);
  });
  if (!(mean_value > 0.0))
    throw std::domain_error(
        "no node of the submitted field has a pressure > 0");
  if (std::isfinite(problem.hardness)) {
    for (double& value : pressure)
      value = std::max(value, 0.0);
    scale_to_target(
        elasticity,
        {mechanics::Control::nominal_pressure, problem.nominal_pressure},
        problem.hardness, pressure);
    return;
  }
  const double factor = problem.nominal_pressure / mean_value;
  chunked(pressure.size(), workers.threads,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              pressure[i] = factor * std::max(pressure[i], 0.0);
          });
}

/// The largest values of a Feasible.
struct LargestValues {
  Largest excess, displacement, height; ///< the last two without sign

  LargestValues& operator+=(const LargestValues& other) {
    excess += other.excess;
    displacement += other.displacement;
    height += other.height;
    return *this;
  }
};

/// The transforms of the operator have a relative roundoff of order
/// eps log2(nodes), by the largest value of the field.
/// @param nodes  on all ranks
double roundoff_of(const LargestValues& largest, std::size_t nodes) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return 8.0 * epsilon *
         std::log2(static_cast<double>(std::max<std::size_t>(nodes, 2))) *
         (largest.displacement.value + largest.height.value);
}

/// The separation at which this share of the nodes overlaps, by bisection: the
/// one with the smallest G, see docs/numerics/certificate.md.
double separation_above(const Feasible& answer, const Weighted& weighted,
                        const Workers& workers, double share) {
  const std::size_t nodes = answer.pressure.size();
  double high = largest_term(nodes, workers,
                             [&](std::size_t i) { return answer.excess(i); });
  double low = -largest_term(nodes, workers,
                             [&](std::size_t i) { return -answer.excess(i); });
  const double accuracy = 1e-15 * (high - low);
  while (high - low > accuracy) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high))
      break;
    const double above = weighted.mean(nodes, [&](std::size_t i) {
      return answer.excess(i) > middle ? 1.0 : 0.0;
    });
    (above > share ? low : high) = middle;
  }
  return high;
}

} // namespace

Defects sound_or_refused(const SurfaceOperator& elasticity,
                         const SubmittedField& submitted) {
  const std::size_t nodes = elasticity.n_nodes();
  const std::span<const double> heights = submitted.heights;
  const std::span<const double> pressure = submitted.pressure;
  if (heights.size() != nodes || pressure.size() != nodes)
    throw std::domain_error(
        "heights and pressure must have one value for each node of the grid");
  const auto defects = chunked_sum<Defects>(
      nodes, elasticity.workers(), [&](std::size_t begin, std::size_t end) {
        Defects own;
        for (std::size_t i = begin; i < end; ++i) {
          own.not_finite +=
              std::isfinite(heights[i]) && std::isfinite(pressure[i]) ? 0 : 1;
          own.in_tension += pressure[i] < 0.0 ? 1 : 0;
          own.largest_tension = std::max(own.largest_tension, -pressure[i]);
        }
        return own;
      });
  if (defects.not_finite > 0)
    throw std::domain_error("heights and pressure must be finite");
  require_positive("nominal_pressure", submitted.nominal_pressure, "Pa");
  require_not_negative("local_compliance", submitted.local_compliance, "m/Pa");
  if (std::isfinite(submitted.hardness))
    require_between("nominal_pressure", submitted.nominal_pressure, 0.0,
                    submitted.hardness, "Pa");
  return defects;
}

void displace(SurfaceOperator& elasticity, const SubmittedField& problem,
              Feasible& answer) {
  const std::size_t nodes = answer.pressure.size();
  const Workers workers = elasticity.workers();
  const Weighted weighted(elasticity.nodal_weights(), workers);
  const std::vector<double>& pressure = answer.pressure;
  answer.displacement.resize(nodes);
  elasticity.displacement(pressure, answer.displacement);
  if (!elasticity.is_periodic())
    answer.lift = weighted.mean_of(answer.displacement);
  const auto largest = chunked_sum<LargestValues>(
      nodes, workers, [&](std::size_t begin, std::size_t end) {
        LargestValues own;
        for (std::size_t i = begin; i < end; ++i) {
          answer.displacement[i] += problem.local_compliance * pressure[i];
          own.excess += Largest{answer.excess(i)};
          own.displacement += Largest{std::abs(answer.displacement[i])};
          own.height += Largest{std::abs(problem.heights[i])};
        }
        return own;
      });
  answer.separation = largest.excess.value;
  if (std::isfinite(problem.hardness)) {
    const double share = problem.nominal_pressure / problem.hardness;
    answer.separation = separation_above(answer, weighted, workers, share);
    answer.sunk_load = problem.hardness * weighted.mean(nodes, [&](auto i) {
      return std::max(0.0, answer.excess(i) - answer.separation);
    });
  }
  answer.roundoff = roundoff_of(largest, workers.all_nodes(nodes));
}

Feasible feasible(SurfaceOperator& elasticity, const SubmittedField& problem,
                  std::vector<double> submitted) {
  project(submitted, elasticity, problem);
  Feasible answer;
  answer.pressure = std::move(submitted);
  answer.heights = problem.heights;
  displace(elasticity, problem, answer);
  return answer;
}

double duality_gap(const Feasible& answer, double pressure_excess,
                   double mean_pressure) {
  const double gap = answer.separation * mean_pressure - pressure_excess;
  const double roundoff = answer.sunk_load > 0.0 ? 4.0 : 2.0;
  return std::max(gap + answer.sunk_load, 0.0) +
         roundoff * answer.roundoff * mean_pressure;
}

double duality_gap(const Feasible& answer, const Weighted& weighted,
                   double mean_pressure) {
  return duality_gap(answer, answer.pressure_excess(weighted), mean_pressure);
}

} // namespace asperity::contact
