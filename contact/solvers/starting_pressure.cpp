#include "contact/solvers/starting_pressure.hpp"

#include "base/require.hpp"
#include "ranks/node_sums.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asperity::contact {
namespace {

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

/// True if no node overlaps at the prescribed mean gap without pressure, which
/// is then the solution. For a flat surface this is the only possible start:
/// the residual of a uniform pressure is uniform and does not determine its
/// magnitude.
bool is_apart(std::span<const double> heights, std::span<const double> weights,
              const mechanics::LoadTarget& target, const Workers& workers) {
  if (target.control != mechanics::Control::mean_gap)
    return false;
  const Largest highest = chunked_sum<Largest>(
      heights.size(), workers, [&](std::size_t begin, std::size_t end) {
        Largest own;
        for (const double height : heights.subspan(begin, end - begin))
          own += {height};
        return own;
      });
  const double mean = weighted_sum(weights, heights, workers) /
                      static_cast<double>(workers.all_nodes(heights.size()));
  return target.amount >= highest.value - mean;
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
    multiply(load_scale(target, elasticity.grid().size(), sum), pressure,
             elasticity.threads());
  }
  return pressure;
}

double load_scale(const mechanics::LoadTarget& target, std::size_t nodes,
                  double pressure_sum) {
  const double scale =
      target.amount * static_cast<double>(nodes) / pressure_sum;
  return std::isnormal(scale) ? scale
                              : std::numeric_limits<double>::quiet_NaN();
}

void scale_to_target(const mechanics::LoadTarget& target,
                     std::span<const double> weights,
                     std::span<double> pressure, const Workers& workers) {
  if (target.control != mechanics::Control::nominal_pressure)
    return;
  multiply(load_scale(target, workers.all_nodes(pressure.size()),
                      weighted_sum(weights, pressure, workers)),
           pressure, workers.threads);
}

} // namespace asperity::contact
