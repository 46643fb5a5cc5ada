#include "results/observables/pressure_fit.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "results/observables/map_sums.hpp"
#include "results/observables/observables.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity::results {
namespace {

constexpr int fewest_nodes = 20;
constexpr double bins_per_deviation = 8.0; // bins per s = sqrt(2G)
constexpr double reach = 6.0; // of the bins on either side of p, in s
constexpr int n_passes = 2;
// They end at most 2 reach s beyond their start; one more is for roundoff.
constexpr std::size_t most_bins =
    static_cast<std::size_t>(2.0 * reach * bins_per_deviation) + 1;

// Above this value of <sigma^2>/p^2 - 1, of the order 1/eps^2, the mean p of
// positive and negative pressures is dominated by roundoff.
constexpr double most_excess = 2e31;

// Range of the least-squares search in ln G on either side of the initial
// value.
constexpr double search_reach = 4.0; // e^4 = 55
constexpr double search_step = 0.5;
constexpr int search_bits = 26; // half of the bits, the attainable accuracy of
                                // a minimum

/// A map in units of its mean p. All quantities below are dimensionless.
struct ReducedMap {
  MapView pressure;
  std::span<const double> weights;
  int threads;
  double mean = 0.0;               ///< p [Pa]
  double mean_square_excess = 0.0; ///< <sigma^2>/p^2 - 1 of sigma > 0
  long nodes_in_contact = 0;

  double weight(std::size_t node) const {
    return weights.empty() ? 1.0 : weights[node];
  }

  std::size_t size() const { return pressure.size(); }
};

struct SpreadSums {
  long nodes_in_contact = 0;
  double spread = 0.0, surplus = 0.0;

  SpreadSums& operator+=(const SpreadSums& other) {
    nodes_in_contact += other.nodes_in_contact;
    spread += other.spread;
    surplus += other.surplus;
    return *this;
  }
};

double weighted_mean_of(const MapView& map, std::span<const double> weights,
                        int threads) {
  if (map.is_stored())
    return mean_of(map, threads);
  std::vector<double> none;
  return weighted_mean(map.values(0, map.size(), none), weights, threads);
}

ReducedMap reduced(const MapView& pressure, std::span<const double> weights,
                   int threads) {
  ReducedMap map{pressure, weights, threads};
  map.mean = weighted_mean_of(pressure, weights, threads);
  if (!std::isfinite(map.mean))
    refuse_argument("pressure", map.mean, "finite");
  // Computes <s^2>/p^2 - 1, where s is the positive part of the pressure,
  // without cancellation. Pressures are divided by p before they are squared,
  // because the square of a pressure may exceed the range of double.
  const auto all = with_weights(weights, [&](const auto weight) {
    return sum_over<SpreadSums>(
        pressure, threads,
        [&](std::size_t first, std::span<const double> values) {
          SpreadSums sums;
          for (std::size_t i = 0; i < values.size(); ++i) {
            const double ratio = values[i] / map.mean;
            const double positive = std::max(0.0, ratio);
            const double share = weight[first + i];
            sums.nodes_in_contact += values[i] > 0.0 ? 1 : 0;
            sums.spread += share * (positive - 1.0) * (positive - 1.0);
            sums.surplus += share * (positive - ratio);
          }
          return sums;
        });
  });
  map.nodes_in_contact = all.nodes_in_contact;
  map.mean_square_excess =
      (all.spread + 2.0 * all.surplus) / static_cast<double>(map.size());
  return map;
}

/// Returns G/p^2 for which the mean square is (1 + excess) p^2, for
/// 0 <= excess < most_excess.
double variance_of_excess(double excess) {
  // Full contact has the excess 2 G, and partial contact has less, so this is a
  // lower bound. Up to 1 % of p^2 the difference is erfc(7), below roundoff.
  const double least = 0.5 * excess;
  if (excess <= 0.01)
    return least;
  const auto lack = [excess](double root) {
    return theory::pressure_moments(1.0, root * root).mean_square_pressure -
           1.0 - excess;
  };
  // At small loads the mean square is 4 p sqrt(G/pi), and otherwise it is
  // larger, so this is an upper bound.
  const double most = 0.25 * std::sqrt(std::numbers::pi) * (1.0 + excess);
  // In either limit the bound equals the root up to roundoff, and the sign of
  // `lack` at the bound is not reliable. The bound is then the result.
  if (!(lack(std::sqrt(least)) < 0.0))
    return least;
  if (!(lack(most) > 0.0))
    return most * most;
  std::uintmax_t evaluations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      lack, std::sqrt(least), most, boost::math::tools::eps_tolerance<double>(),
      evaluations);
  return 0.25 * (low + high) * (low + high);
}

/// Fractions of the nodes in bins of equal width.
struct Bins {
  double start = 0.0; ///< sigma/p
  double width = 0.0;
  std::vector<double> share;
};

Bins histogram(const ReducedMap& map, double variance) {
  const double spread = std::sqrt(2.0 * variance);
  Bins bins;
  bins.width = spread / bins_per_deviation;
  bins.start = std::max(bins.width, 1.0 - reach * spread);
  const auto n = static_cast<std::size_t>(
      std::ceil((1.0 + reach * spread - bins.start) / bins.width));
  assert(n <= most_bins);
  const auto sums = sum_over<SeveralSums<most_bins>>(
      map.pressure, map.threads,
      [&](std::size_t first, std::span<const double> values) {
        SeveralSums<most_bins> chunk;
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (!(values[i] > 0.0))
            continue; // below the first bin
          const double place = (values[i] / map.mean - bins.start) / bins.width;
          if (place >= 0.0 && place < static_cast<double>(n))
            chunk.values[static_cast<std::size_t>(place)] +=
                map.weight(first + i);
        }
        return chunk;
      });
  bins.share.assign(sums.values.begin(),
                    sums.values.begin() + static_cast<std::ptrdiff_t>(n));
  for (double& share : bins.share)
    share /= static_cast<double>(map.size());
  return bins;
}

double misfit(const Bins& bins, double variance) {
  double sum = 0.0;
  for (std::size_t i = 0; i < bins.share.size(); ++i) {
    const double low = bins.start + bins.width * static_cast<double>(i);
    const double difference =
        bins.share[i] -
        theory::pressure_share(low, low + bins.width, 1.0, variance); // (20)
    sum += difference * difference;
  }
  return sum;
}

/// Returns G/p^2 of the least-squares minimum around `start`; NaN if the
/// minimum is at the end of the search range.
double best_variance(const Bins& bins, double start) {
  const auto at = [&](double exponent) {
    return misfit(bins, start * std::exp(exponent));
  };
  double best = -search_reach;
  double least = at(best);
  for (double exponent = -search_reach + search_step; exponent <= search_reach;
       exponent += search_step)
    if (const double here = at(exponent); here < least) {
      least = here;
      best = exponent;
    }
  if (std::abs(best) >= search_reach)
    return PressureFit::none;
  const auto minimum = boost::math::tools::brent_find_minima(
      at, best - search_step, best + search_step, search_bits);
  return start * std::exp(minimum.first);
}

double least_squares_variance(const ReducedMap& map, double start) {
  double variance = start;
  for (int pass = 0; pass < n_passes && std::isfinite(variance); ++pass)
    variance = best_variance(histogram(map, variance), variance);
  return variance;
}

/// Returns the result of both fits if Eq. (20) does not apply.
PressureFit empty_fit(const ReducedMap& map) {
  PressureFit fit;
  fit.nominal_pressure = map.mean;
  if (map.nodes_in_contact == 0) {
    fit.area_fraction = 0.0;
    fit.reason = "nothing is in contact";
  } else if (!(map.mean > 0.0)) {
    fit.reason = "the mean pressure is not positive";
  } else if (!(map.mean_square_excess < most_excess)) {
    fit.reason = "the mean pressure is dominated by roundoff";
  }
  return fit;
}

PressureFit finished(PressureFit fit, double reduced_variance) {
  fit.variance = reduced_variance * fit.nominal_pressure * fit.nominal_pressure;
  fit.area_fraction = reduced_variance > 0.0
                          ? theory::area_fraction(1.0, reduced_variance)
                          : 1.0; // (21)
  return fit;
}

PressureFit fit_histogram(const ReducedMap& map) {
  PressureFit fit = empty_fit(map);
  if (!fit.reason.empty())
    return fit;
  if (map.nodes_in_contact < fewest_nodes) {
    fit.reason = "too few nodes are in contact for a histogram";
    return fit;
  }
  // If the spread is close to roundoff, no bins exist: sigma/p is known only to
  // 1e-16.
  const double start = variance_of_excess(map.mean_square_excess);
  if (start < 1e-24)
    return finished(fit, start);
  const double variance = least_squares_variance(map, start);
  if (!std::isfinite(variance)) {
    fit.reason = "the histogram has no least-squares fit";
    return fit;
  }
  return finished(fit, variance);
}

PressureFit fit_moment(const ReducedMap& map) {
  PressureFit fit = empty_fit(map);
  return fit.reason.empty()
             ? finished(fit, variance_of_excess(map.mean_square_excess))
             : fit;
}

} // namespace

PressureFit fit_pressure_distribution(const MapView& pressure,
                                      std::span<const double> weights,
                                      int threads) {
  return fit_histogram(reduced(pressure, weights, threads));
}

PressureFits pressure_fits(std::span<const double> pressure,
                           std::span<const double> weights, int threads) {
  const ReducedMap map = reduced(pressure, weights, threads);
  return {fit_histogram(map), fit_moment(map)};
}

} // namespace asperity::results
