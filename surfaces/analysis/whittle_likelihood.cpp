#include "surfaces/analysis/whittle_likelihood.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace asperity::surfaces {
namespace {

constexpr int n_parameters = static_cast<int>(whittle_parameters);
using Vector = Eigen::Matrix<double, n_parameters, 1>;
using Information = Eigen::Matrix<double, n_parameters, n_parameters>;
using Rings = std::span<const SpectrumRing>;

constexpr double least_noise = -30.0; // ln N below that of the smallest C
constexpr double most_blur = 30.0;    // of s^2 q^2 at the last ring
constexpr int most_fit_steps = 80;
// Rings of one group are wider than the correlation of windowed modes.
constexpr double groups_per_decade = 15.0;

/// Value, gradient and Fisher information at some parameters.
struct Expansion {
  double value = 0.0;
  Vector gradient = Vector::Zero();
  Information information = Information::Zero();
};

double deviance_term(const SpectrumRing& ring, double log_model) {
  return 0.5 * ring.degrees_of_freedom *
         (log_model + ring.density * std::exp(-log_model));
}

/// @param noise_unit  the derivatives are those by N in this unit [m^4]
Expansion expand(Rings rings, const WhittleParameters& at, bool has_corner,
                 double noise_unit) {
  Expansion result;
  const double floor = std::exp(at[noise_at]);
  for (const SpectrumRing& ring : rings) {
    const double log_q = std::log(ring.wavevector);
    const bool is_flat = has_corner && log_q < at[corner_at];
    const double exponent = -2.0 - 2.0 * at[hurst_at];
    const double bent = is_flat ? at[corner_at] : log_q;
    const double square = ring.wavevector * ring.wavevector;
    const double signal =
        std::exp(at[amplitude_at] + exponent * bent - at[blur_at] * square);
    const double model = signal + floor;
    const double share = signal / model;
    Vector slope;
    slope << share, -2.0 * bent * share, is_flat ? exponent * share : 0.0,
        noise_unit / model, -square * share;
    const double weight = 0.5 * ring.degrees_of_freedom;
    result.value += deviance_term(ring, std::log(model));
    result.gradient += weight * (1.0 - ring.density / model) * slope;
    result.information += weight * slope * slope.transpose();
  }
  return result;
}

/// Expands in the parameters themselves.
Expansion expand(Rings rings, const WhittleParameters& at, bool has_corner) {
  return expand(rings, at, has_corner, std::exp(at[noise_at]));
}

/// Excludes a parameter from a step.
void hold(Expansion& at, Eigen::Index parameter) {
  at.information.row(parameter).setZero();
  at.information.col(parameter).setZero();
  at.gradient(parameter) = 0.0;
}

/// The solution of A x = b for a symmetric A whose rows have different units,
/// and are zero for parameters that are held.
/// @param damping  relative to the diagonal
Vector solve_scaled(const Information& system, const Vector& right,
                    double damping) {
  Vector scale = system.diagonal().cwiseSqrt();
  scale = (scale.array() > 0.0).select(scale, 1.0);
  Information scaled = system.array() / (scale * scale.transpose()).array();
  scaled.diagonal().array() += damping + 1e-14;
  return scaled.ldlt().solve(right.cwiseQuotient(scale)).cwiseQuotient(scale);
}

/// Limits of ln q_0, ln N and the square of the blur.
struct Box {
  double corner_low, corner_high, noise_low, noise_high, blur_high;

  explicit Box(Rings rings) {
    const auto by_density = [](const SpectrumRing& a, const SpectrumRing& b) {
      return a.density < b.density;
    };
    const auto [least, largest] =
        std::minmax_element(rings.begin(), rings.end(), by_density);
    corner_low = std::log(rings.front().wavevector);
    corner_high = std::log(rings.back().wavevector);
    noise_low = std::log(least->density) + least_noise;
    noise_high = std::log(largest->density);
    blur_high = most_blur / std::pow(rings.back().wavevector, 2);
  }

  WhittleParameters inside(WhittleParameters p) const {
    p[hurst_at] = std::clamp(p[hurst_at], -1.0, 4.0);
    p[corner_at] = std::clamp(p[corner_at], corner_low, corner_high);
    p[noise_at] = std::clamp(p[noise_at], noise_low, noise_high);
    p[blur_at] = std::clamp(p[blur_at], 0.0, blur_high);
    return p;
  }
};

/// Damped Fisher scoring. The amplitude at q = 1 rad/m and H are almost
/// collinear for measured wavevectors; the damping is therefore relative to the
/// diagonal, and the solution uses a pivoted decomposition.
double descend(Rings rings, const Box& box, bool has_corner,
               WhittleParameters& at) {
  const double blur_unit = most_blur / box.blur_high; // q^2 of the last ring
  at = box.inside(at);
  Expansion here = expand(rings, at, has_corner);
  double damping = 1e-3;
  for (int step = 0; step < most_fit_steps && damping < 1e10; ++step) {
    if (at[blur_at] == 0.0 && here.gradient(blur_at) > 0.0)
      hold(here, blur_at); // it would become negative
    Vector change = solve_scaled(here.information, here.gradient, damping);
    change *= std::min(
        1.0, 0.5 / std::max({std::abs(change(hurst_at)),
                             0.5 * std::abs(change(corner_at)),
                             0.25 * blur_unit * std::abs(change(blur_at))}));
    WhittleParameters next = at;
    for (std::size_t k = 0; k < whittle_parameters; ++k)
      next.at(k) -= change(static_cast<Eigen::Index>(k));
    next = box.inside(next);
    const Expansion there = expand(rings, next, has_corner);
    if (!(there.value < here.value)) {
      damping *= 10.0;
      continue;
    }
    const double gain = here.value - there.value;
    at = next;
    here = there;
    damping = std::max(damping * 0.1, 1e-9);
    if (gain < 1e-6)
      break;
  }
  return here.value;
}

/// The power law through the rings with the best amplitude for an exponent.
/// @param blur_exponent  s^2 q^2 at the last ring
WhittleParameters start_at(Rings rings, double log_corner, double roughness,
                           double noise_share, double blur_exponent) {
  const double end = rings.back().wavevector;
  WhittleParameters start{0.0, roughness, log_corner, 0.0,
                          blur_exponent / (end * end)};
  double weight = 0.0;
  double ratio = 0.0;
  for (const SpectrumRing& ring : rings) {
    weight += ring.degrees_of_freedom;
    ratio += ring.degrees_of_freedom *
             (std::log(ring.density) - log_signal(start, ring.wavevector));
  }
  start[amplitude_at] = ratio / weight;
  start[noise_at] = std::log(rings.back().density * noise_share);
  return start;
}

std::vector<WhittleParameters> starts_for(Rings rings) {
  std::vector<WhittleParameters> starts;
  const double low = std::log(rings.front().wavevector);
  const double high = std::log(rings.back().wavevector);
  for (const double share : {0.0, 0.15, 0.3, 0.5, 0.7})
    for (const double noise_share : {0.3, 1e-6})
      for (const double blur_exponent : {0.0, 1.0})
        starts.push_back(start_at(rings, low + share * (high - low), 0.7,
                                  noise_share, blur_exponent));
  return starts;
}

/// Value of the rings beyond the cut-off: each has a density of its own and
/// costs the deviance at which a ring counts as a departure from the model, a
/// factor of 1.5 or, where that is within the scatter of the ring, 3.2 standard
/// deviations.
double value_beyond(Rings rings) {
  constexpr double by_scatter = 5.0;
  constexpr double by_factor = 0.0361; // (ln 1.5 + 1/1.5 - 1)/2
  double value = 0.0;
  for (const SpectrumRing& ring : rings)
    value += deviance_term(ring, std::log(ring.density)) +
             std::max(by_scatter, by_factor * ring.degrees_of_freedom);
  return value;
}

} // namespace

double log_signal(const WhittleParameters& parameters, double wavevector) {
  return parameters[amplitude_at] +
         (-2.0 - 2.0 * parameters[hurst_at]) *
             std::max(std::log(wavevector), parameters[corner_at]) -
         parameters[blur_at] * wavevector * wavevector;
}

WhittlePart fit_part(const std::vector<SpectrumRing>& rings, std::size_t count,
                     const std::optional<WhittleParameters>& start) {
  const Rings below = Rings(rings).first(count);
  const Box box(below);
  std::vector<WhittleParameters> starts;
  if (!start || count % 8 == 0)
    starts = starts_for(below);
  if (start)
    starts.push_back(*start);
  WhittlePart part;
  part.count = count;
  part.value = HUGE_VAL;
  for (WhittleParameters& at : starts) {
    const double value = descend(below, box, true, at);
    if (value < part.value) {
      part.value = value;
      part.parameters = at;
    }
  }
  part.beyond = value_beyond(Rings(rings).subspan(count));
  part.value += part.beyond;
  return part;
}

WhittlePart without_roll_off(const std::vector<SpectrumRing>& rings,
                             const WhittlePart& part) {
  const Rings below = Rings(rings).first(part.count);
  const Box box(below);
  WhittlePart straight = part;
  straight.value = HUGE_VAL;
  std::vector<WhittleParameters> starts = starts_for(below);
  starts.push_back(part.parameters);
  for (WhittleParameters& at : starts) {
    at[corner_at] = box.corner_low;
    const double value = descend(below, box, false, at);
    if (value < straight.value) {
      straight.value = value;
      straight.parameters = at;
    }
  }
  straight.parameters[corner_at] = box.corner_low;
  straight.value += part.beyond;
  return straight;
}

Dispersion dispersion_of(const std::vector<SpectrumRing>& rings,
                         const WhittlePart& part) {
  struct Group {
    double weight = 0.0;
    double density = 0.0;
    double model = 0.0;
  };

  std::map<long, Group> groups;
  const double floor = std::exp(part.parameters[noise_at]);
  for (const SpectrumRing& ring : Rings(rings).first(part.count)) {
    Group& group =
        groups[std::lround(groups_per_decade * std::log10(ring.wavevector))];
    group.weight += ring.degrees_of_freedom;
    group.density += ring.degrees_of_freedom * ring.density;
    group.model +=
        ring.degrees_of_freedom *
        (std::exp(log_signal(part.parameters, ring.wavevector)) + floor);
  }
  double deviance = 0.0;
  double expected = 0.0;
  for (const auto& [step, group] : groups) {
    const double nu = group.weight;
    const double ratio = group.density / group.model;
    deviance += nu * (ratio - 1.0 - std::log(ratio));
    expected += nu * (std::log(0.5 * nu) - boost::math::digamma(0.5 * nu));
  }
  const auto count = static_cast<double>(groups.size());
  const double free = std::max(1.0, count - n_parameters);
  constexpr double exceeded = 1e-3; // probability
  return {deviance / (expected * free / count),
          quantile(complement(boost::math::chi_squared(free), exceeded)) /
              free};
}

Covariance covariance_of(const std::vector<SpectrumRing>& rings,
                         const WhittlePart& part, bool has_roll_off,
                         double widening) {
  const Rings below = Rings(rings).first(part.count);
  const double noise_unit =
      std::ranges::min(below, {}, &SpectrumRing::density).density;
  Information information =
      expand(below, part.parameters, has_roll_off, noise_unit).information;
  if (!has_roll_off)
    information(corner_at, corner_at) = 1.0;
  Covariance covariance{};
  for (std::size_t k = 0; k < whittle_parameters; ++k) {
    if (k == corner_at && !has_roll_off)
      continue;
    const Vector column = solve_scaled(
        information, Vector::Unit(static_cast<Eigen::Index>(k)), 0.0);
    for (std::size_t i = 0; i < whittle_parameters; ++i)
      covariance.at(i).at(k) = widening * column(static_cast<Eigen::Index>(i));
  }
  return covariance;
}

} // namespace asperity::surfaces
