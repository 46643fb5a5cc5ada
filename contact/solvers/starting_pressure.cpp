#include "contact/solvers/starting_pressure.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "base/special_numbers.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asperity::contact {
namespace {

using TwoLoads = SeveralSums<2>;

void require_size(const char* name, std::size_t size, std::size_t expected) {
  if (size != expected)
    refuse_argument(name, static_cast<double>(size),
                    "the number of nodes, " + std::to_string(expected));
}

void require_problem(const ContactProblem& problem,
                     const mechanics::LoadTarget& target, std::size_t nodes) {
  require_size("heights.size()", problem.heights.size(), nodes);
  require_not_negative("local_compliance", problem.local_compliance, "m/Pa");
  require_positive("gap_tolerance", problem.gap_tolerance, "m");
  if (problem.has_hardness())
    require_positive("hardness", problem.hardness, "Pa");
  if (target.control == mechanics::Control::nominal_pressure &&
      target.amount > problem.hardness)
    refuse_argument("nominal_pressure", target.amount,
                    "at most the hardness, " +
                        std::to_string(problem.hardness) +
                        " Pa, which no pressure exceeds");
  // One that is not finite makes the sum NaN, which takes less time to find.
  if (std::isnan(weighted_sum(
          {}, nodes, 1,
          [h = problem.heights.data()](std::size_t i) { return 0.0 * h[i]; })))
    refuse_argument("heights",
                    *std::ranges::find_if_not(
                        problem.heights,
                        [](double height) { return std::isfinite(height); }),
                    "finite [m]");
  if (target.control == mechanics::Control::nominal_pressure)
    require_positive("nominal_pressure", target.amount, "Pa");
  else if (problem.local_compliance == 0.0)
    require_positive("mean_gap in hard contact", target.amount, "m");
  else if (!std::isfinite(target.amount))
    refuse_argument("mean_gap", target.amount, "finite [m]");
}

/// The weighted sum of initial pressures over all ranks, which must be >= 0 and
/// finite on this one.
double sum_of_pressures(std::span<const double> initial_pressure,
                        std::span<const double> weights,
                        const Workers& workers) {
  const double* const p = initial_pressure.data();
  std::atomic<bool> is_wrong = false;
  const auto sum = with_weights(weights, [&](const auto weight) {
    return chunked_sum<Sum>(
        initial_pressure.size(), workers,
        [&, weight](std::size_t begin, std::size_t end) {
          if (sum_in_lanes(begin, end, [=](std::size_t i) {
                return 0.0 * p[i] + (p[i] < 0.0 ? 1.0 : 0.0);
              }) != 0.0) // or NaN
            is_wrong = true;
          return Sum{sum_in_lanes(
              begin, end, [=](std::size_t i) { return weight[i] * p[i]; })};
        });
  });
  if (is_wrong)
    require_not_negative(
        "initial_pressure",
        *std::ranges::find_if_not(
            initial_pressure,
            [](double start) { return start >= 0.0 && std::isfinite(start); }),
        "Pa");
  return sum.value;
}

void multiply(double factor, std::span<double> field, int threads) {
  double* const values = field.data();
  chunked(field.size(), threads, [=](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      values[i] *= factor;
  });
}

/// The sums of the weighted pressures below the hardness and of the others.
TwoLoads loads_by_hardness(std::span<const double> weights,
                           std::span<const double> pressure,
                           const Workers& workers, double hardness) {
  return with_weights(weights, [&](const auto weight) {
    const auto load = [=, p = pressure.data()](std::size_t begin,
                                               std::size_t end, bool is_below) {
      return sum_in_lanes(begin, end, [=](std::size_t i) {
        return (p[i] < hardness) == is_below ? weight[i] * p[i] : 0.0;
      });
    };
    return chunked_sum<TwoLoads>(
        pressure.size(), workers, [=](std::size_t begin, std::size_t end) {
          return TwoLoads{{load(begin, end, true), load(begin, end, false)}};
        });
  });
}

/// The load of the positive part of field - level up to the hardness, and the
/// number of nodes below it.
TwoLoads load_above(const SurfaceOperator& elasticity,
                    std::span<const double> field, double level,
                    double hardness) {
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    return chunked_sum<TwoLoads>(
        field.size(), elasticity.workers(),
        [=, f = field.data()](std::size_t begin, std::size_t end) {
          return TwoLoads{
              {sum_in_lanes(begin, end,
                            [=](std::size_t i) {
                              return weight[i] *
                                     std::clamp(f[i] - level, 0.0, hardness);
                            }),
               sum_in_lanes(begin, end, [=](std::size_t i) {
                 return f[i] > level && f[i] - level < hardness ? weight[i]
                                                                : 0.0;
               })}};
        });
  });
}

/// The number to subtract. By Newton's method, because the load is a convex
/// function of it; with a hardness it is not, and the interval that holds the
/// number is halved where Newton's method leaves it.
double level_of_load(const SurfaceOperator& elasticity,
                     const mechanics::LoadTarget& target,
                     std::span<const double> field, double hardness) {
  if (target.control != mechanics::Control::nominal_pressure)
    return 0.0;
  const bool has_hardness = std::isfinite(hardness);
  const int most_steps = has_hardness ? 200 : 8;
  const double accuracy = has_hardness ? 1e-12 : 1e-3;
  double low = -std::numeric_limits<double>::infinity();
  double high = -low;
  const Workers workers = elasticity.workers();
  const double wanted =
      target.amount * static_cast<double>(workers.all_nodes(field.size()));
  double level = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const auto [load, nodes] =
        load_above(elasticity, field, level, hardness).values;
    if (std::abs(load - wanted) <= accuracy * wanted)
      break;
    (load > wanted ? low : high) = level;
    if (nodes > 0.0)
      level += (load - wanted) / nodes;
    else if (std::isfinite(high - low))
      level = 0.5 * (low + high);
    else { // none carries any load, or on from here some carry at least all
      const double highest = largest_of(field, workers);
      level = load > wanted
                  ? highest
                  : highest - std::max(wanted, 2.0 * (highest - level));
    }
    if (std::isfinite(high - low) && !(level > low && level < high))
      level = 0.5 * (low + high);
  }
  return level;
}

/// Whether all values are below the hardness, also with a factor.
bool stays_below(double hardness, double factor, std::span<const double> field,
                 const Workers& workers) {
  if (!std::isfinite(hardness))
    return true;
  return largest_of(field, workers) * std::max(1.0, factor) < hardness;
}

/// True if no node overlaps at the prescribed mean gap without pressure, which
/// is then the solution. For a flat surface this is the only possible start:
/// the residual of a uniform pressure is uniform and does not determine its
/// magnitude.
bool is_apart(std::span<const double> heights, std::span<const double> weights,
              const mechanics::LoadTarget& target, const Workers& workers) {
  if (target.control != mechanics::Control::mean_gap)
    return false;
  const double mean = weighted_sum(weights, heights, workers) /
                      static_cast<double>(workers.all_nodes(heights.size()));
  return target.amount >= largest_of(heights, workers) - mean;
}

} // namespace

std::vector<double> starting_pressure(const SurfaceOperator& elasticity,
                                      const ContactProblem& problem,
                                      const mechanics::LoadTarget& target,
                                      std::vector<double> initial_pressure) {
  const std::size_t nodes = elasticity.n_nodes();
  require_problem(problem, target, nodes);
  if (target.control == mechanics::Control::mean_gap &&
      !elasticity.is_periodic())
    refuse_argument("mean_gap", target.amount,
                    "replaced by a nominal pressure, because a surface with "
                    "free boundaries has no mean gap");
  if (is_apart(problem.heights, elasticity.nodal_weights(), target,
               elasticity.workers()))
    return std::vector<double>(nodes, 0.0);
  std::vector<double> pressure;
  if (initial_pressure.empty()) {
    // Under gap control any positive scale will do: the first iteration
    // corrects it.
    const double start =
        target.control == mechanics::Control::nominal_pressure
            ? target.amount
            : problem.gap_tolerance / (elasticity.short_wave_compliance() +
                                       problem.local_compliance);
    pressure.assign(nodes, start);
  } else {
    require_size("initial_pressure.size()", initial_pressure.size(), nodes);
    pressure = std::move(initial_pressure);
  }
  const double sum = sum_of_pressures(pressure, elasticity.nodal_weights(),
                                      elasticity.workers());
  if (target.control == mechanics::Control::nominal_pressure) {
    require_positive("sum of initial_pressure", sum, "Pa");
    const double scale = load_scale(target, elasticity.grid().size(), sum);
    if (stays_below(problem.hardness, scale, pressure, elasticity.workers())) {
      multiply(scale, pressure, elasticity.threads());
      return pressure;
    }
  }
  if (problem.has_hardness())
    scale_to_target(elasticity, target, problem.hardness, pressure);
  return pressure;
}

double load_scale(const mechanics::LoadTarget& target, std::size_t nodes,
                  double pressure_sum) {
  const double scale =
      target.amount * static_cast<double>(nodes) / pressure_sum;
  return std::isnormal(scale) ? scale
                              : std::numeric_limits<double>::quiet_NaN();
}

void scale_to_target(const SurfaceOperator& elasticity,
                     const mechanics::LoadTarget& target, double hardness,
                     std::span<double> pressure) {
  const Workers workers = elasticity.workers();
  const std::span<const double> weights = elasticity.nodal_weights();
  const auto cut_off = [&](double factor) {
    for (double& value : pressure)
      value = value < hardness ? std::min(hardness, factor * value) : hardness;
  };
  if (target.control != mechanics::Control::nominal_pressure) {
    if (std::isfinite(hardness))
      cut_off(1.0);
    return;
  }
  const std::size_t nodes = workers.all_nodes(pressure.size());
  const double scale =
      load_scale(target, nodes, weighted_sum(weights, pressure, workers));
  if (stays_below(hardness, scale, pressure, workers)) {
    multiply(scale, pressure, workers.threads);
    return;
  }
  constexpr int most_rounds = 30;
  constexpr double roundoff = 1e-13;
  const double wanted = target.amount * static_cast<double>(nodes);
  cut_off(1.0);
  for (int round = 0; round < most_rounds; ++round) {
    const auto [below, above] =
        loads_by_hardness(weights, pressure, workers, hardness).values;
    const double factor = (wanted - above) / below;
    if (!(factor > 0.0 && std::isfinite(factor)) ||
        std::abs(factor - 1.0) <= roundoff)
      break;
    cut_off(factor);
  }
  press_to_load(elasticity, target, hardness, pressure);
}

void press_to_load(const SurfaceOperator& elasticity,
                   const mechanics::LoadTarget& target, double hardness,
                   std::span<double> pressure) {
  double level = level_of_load(elasticity, target, pressure, infinity);
  constexpr double near = 0.9; // to 1e-3 of the load, without the hardness
  if (largest_of(pressure, elasticity.workers()) - level > near * hardness)
    level = level_of_load(elasticity, target, pressure, hardness);
  double* const values = pressure.data();
  chunked(pressure.size(), elasticity.threads(),
          [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              values[i] = std::clamp(values[i] - level, 0.0, hardness);
          });
}

} // namespace asperity::contact
