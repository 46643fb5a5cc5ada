#include "surfaces/analysis/self_affine_fit.hpp"

#include "base/special_numbers.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace asperity::surfaces {
namespace {

/// ln of the self-affine part at 1 rad/m, H, ln q_0, ln N and the square of the
/// blur s [m^2]: S(q) = exp(p[0]) max(q, q_0)^(-2 - 2 H) exp(-p[4] q^2).
constexpr std::size_t whittle_parameters = 5;
constexpr std::size_t amplitude_at = 0, hurst_at = 1, corner_at = 2,
                      noise_at = 3, blur_at = 4;
using WhittleParameters = std::array<double, whittle_parameters>;

using Covariance =
    std::array<std::array<double, whittle_parameters>, whittle_parameters>;

/// A fit whose first `count` rings follow S + N; the other rings are free.
struct WhittlePart {
  std::size_t count = 0;
  WhittleParameters parameters{};
  double value = 0.0;  ///< minus the log-likelihood, up to a constant
  double beyond = 0.0; ///< the share of the other rings, each with the cost of
                       ///< its freedom
};

/// Deviance of the rings below the cut-off, joined to 15 per decade.
struct Dispersion {
  double value = 1.0; ///< over its expected value [1]
  double limit = 1.0; ///< which rings of the model exceed once in a thousand
                      ///< maps [1]
};

/// ln S(q).
double log_signal(const WhittleParameters& parameters, double wavevector) {
  return parameters[amplitude_at] +
         (-2.0 - 2.0 * parameters[hurst_at]) *
             std::max(std::log(wavevector), parameters[corner_at]) -
         parameters[blur_at] * wavevector * wavevector;
}

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

/// Fits the model by Fisher scoring from several starts.
/// @param start  one more start; if given, only starts near it are tried unless
///               count is a multiple of eight
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

/// Fits the same rings without a roll-off.
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

/// Inverse Fisher information times `widening`, for N in units of the smallest
/// ring in the place of ln N; zero for q_0 without a roll-off. Noise and blur
/// count also where the most likely one is 0: a map excludes neither exactly,
/// and each changes H.
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

constexpr double two_sided = 1.959963984540054; // 95 % of a normal distribution
constexpr double likelihood_drop = 0.5 * two_sided * two_sided;
constexpr std::size_t fewest_rings = 10;
constexpr double least_ratio = 3.0;
constexpr double widest_hurst = 0.5; // half width of a useful interval of H
constexpr double one_ring = 1.03;    // a little more than the width of a ring
constexpr const char* not_self_affine =
    "above 1: the spectrum is not that of a self-affine surface";
constexpr const char* no_interval =
    "no interval: the rings scatter more than the model allows";

/// The best fit for each number of rings below the cut-off.
struct CutoffScan {
  std::vector<WhittlePart> parts; ///< one per count, fewest_rings..n
  std::size_t best = 0;           ///< index of the accepted one
};

std::size_t fewest_below(const std::vector<SpectrumRing>& rings) {
  const double least = least_ratio * rings.front().wavevector;
  const auto first =
      std::find_if(rings.begin(), rings.end(), [&](const SpectrumRing& ring) {
        return ring.wavevector >= least;
      });
  return std::max(fewest_rings,
                  static_cast<std::size_t>(first - rings.begin()) + 1);
}

CutoffScan scan_cutoffs(const std::vector<SpectrumRing>& rings) {
  CutoffScan scan;
  std::optional<WhittleParameters> start;
  for (std::size_t count = rings.size(); count >= fewest_below(rings);
       --count) {
    WhittlePart part = fit_part(rings, count, start);
    start = part.parameters;
    scan.parts.push_back(part);
  }
  std::reverse(scan.parts.begin(), scan.parts.end());
  // The warm start may follow a local optimum: repeat in the other direction.
  for (std::size_t i = 1; i < scan.parts.size(); ++i) {
    const WhittlePart again =
        fit_part(rings, scan.parts[i].count, scan.parts[i - 1].parameters);
    if (again.value < scan.parts[i].value)
      scan.parts[i] = again;
  }
  const auto least =
      std::min_element(scan.parts.begin(), scan.parts.end(),
                       [](const WhittlePart& a, const WhittlePart& b) {
                         return a.value < b.value;
                       });
  scan.best = static_cast<std::size_t>(least - scan.parts.begin());
  return scan;
}

FittedParameter cutoff_of(const std::vector<SpectrumRing>& rings,
                          const CutoffScan& scan, double dispersion) {
  const double limit =
      scan.parts[scan.best].value + likelihood_drop * dispersion;
  std::size_t lowest = scan.best;
  std::size_t highest = scan.best;
  for (std::size_t i = 0; i < scan.parts.size(); ++i)
    if (scan.parts[i].value <= limit) {
      lowest = std::min(lowest, i);
      highest = std::max(highest, i);
    }
  const auto ring_at = [&](std::size_t part, std::size_t above) {
    const std::size_t ring = scan.parts[part].count - 1 + above;
    return rings[std::min(ring, rings.size() - 1)].wavevector;
  };
  if (scan.best + 1 == scan.parts.size())
    return {not_a_number, ring_at(scan.best, 0), not_a_number,
            "no cut-off within the reliable range"};
  // The cut-off may deplete the last ring of the part or the first beyond it.
  FittedParameter cutoff{
      std::sqrt(ring_at(scan.best, 0) * ring_at(scan.best, 1)),
      ring_at(lowest, 0), ring_at(highest, 2), ""};
  if (highest + 2 >= scan.parts.size()) {
    cutoff.high = not_a_number;
    cutoff.reason = "no upper limit within the reliable range";
  }
  return cutoff;
}

/// The cut-off of a spectrum without power above its last ring.
FittedParameter end_of(const std::vector<SpectrumRing>& rings) {
  const double last = rings.back().wavevector;
  return {last, rings[rings.size() - 2].wavevector, last * one_ring, ""};
}

/// ln h_rms^2 of the model, by the trapezoidal rule in ln q.
double log_mean_square(const WhittleParameters& parameters, double low,
                       double high) {
  constexpr int steps = 400;
  const double width = std::log(high / low) / steps;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double q = low * std::exp(i * width);
    const double end = i == 0 || i == steps ? 0.5 : 1.0;
    sum += end * q * q * std::exp(log_signal(parameters, q)) * width;
  }
  return std::log(2.0 * std::numbers::pi * sum);
}

FittedParameter rms_height_of(const WhittlePart& part,
                              const Covariance& covariance, double low,
                              double high) {
  const double middle = log_mean_square(part.parameters, low, high);
  WhittleParameters gradient{};
  for (std::size_t k = 0; k < whittle_parameters; ++k) {
    const double step = k == blur_at ? 1e-5 / (high * high) : 1e-5;
    WhittleParameters changed = part.parameters;
    changed.at(k) += step;
    gradient.at(k) = (log_mean_square(changed, low, high) - middle) / step;
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < whittle_parameters; ++i)
    for (std::size_t k = 0; k < whittle_parameters; ++k)
      variance += gradient.at(i) * covariance.at(i).at(k) * gradient.at(k);
  const double half = 0.5 * two_sided * std::sqrt(variance);
  const double height = std::exp(0.5 * middle);
  return {height, height * std::exp(-half), height * std::exp(half), ""};
}

FittedParameter hurst_of(const WhittlePart& part,
                         const Covariance& covariance) {
  const double hurst = part.parameters[hurst_at];
  const double half = two_sided * std::sqrt(covariance[hurst_at][hurst_at]);
  if (!(half <= widest_hurst) || std::abs(hurst - 0.5) > widest_hurst + 0.5)
    return {not_a_number, not_a_number, not_a_number,
            "the self-affine part of the spectrum is too short"};
  const char* const reason =
      hurst <= 1.0          ? ""
      : hurst - half <= 1.0 ? "above 1, where no surface is self-affine, but "
                              "the interval reaches below"
                            : not_self_affine;
  return {hurst, hurst - half, hurst + half, reason};
}

FittedParameter roll_off_of(const WhittlePart& part,
                            const Covariance& covariance) {
  const double corner = std::exp(part.parameters[corner_at]);
  const double factor =
      std::exp(two_sided * std::sqrt(covariance[corner_at][corner_at]));
  return {corner, corner / factor, corner * factor, ""};
}

/// The blur, of which only an upper limit is determined if the rings do not
/// exclude that there is none.
FittedParameter blur_of(const WhittlePart& part, const Covariance& covariance) {
  const double square = part.parameters[blur_at];
  const double half = two_sided * std::sqrt(covariance[blur_at][blur_at]);
  if (!(square > half))
    return {not_a_number, not_a_number, std::sqrt(square + half),
            "no blur is found"};
  return {std::sqrt(square), std::sqrt(square - half), std::sqrt(square + half),
          ""};
}

/// Withdraws the intervals of a fit whose rings scatter too much.
void withdraw_intervals(SelfAffineFit& fit) {
  for (FittedParameter* const parameter :
       {&fit.hurst, &fit.roll_off, &fit.cutoff, &fit.blur, &fit.rms_height}) {
    parameter->low = parameter->high = not_a_number;
    if (std::isfinite(parameter->value))
      parameter->reason = no_interval;
  }
  if (fit.hurst.value > 1.0)
    fit.hurst.reason = std::string(not_self_affine) + "; " + no_interval;
}

} // namespace

double SelfAffineFit::density(double wavevector) const {
  const double corner =
      std::isnan(roll_off.value) ? wavevector_low : roll_off.value;
  return plateau * std::pow(std::max(wavevector, corner) / corner, exponent) *
             std::exp(-blur_square * (wavevector * wavevector -
                                      wavevector_low * wavevector_low)) +
         noise;
}

std::optional<SelfAffineFit>
fit_self_affine(const std::vector<SpectrumRing>& rings, double wavevector_end) {
  if (rings.size() < fewest_rings ||
      rings.back().wavevector < least_ratio * rings.front().wavevector)
    return std::nullopt;
  SelfAffineFit fit;
  WhittlePart part;
  Dispersion dispersion;
  if (rings.back().wavevector * one_ring < wavevector_end) {
    part = fit_part(rings, rings.size() - 1, std::nullopt);
    dispersion = dispersion_of(rings, part);
    fit.cutoff = end_of(rings);
  } else {
    const CutoffScan scan = scan_cutoffs(rings);
    const bool has_cutoff = scan.best > 0 && scan.best + 1 < scan.parts.size();
    part = scan.parts[has_cutoff ? scan.best - 1 : scan.best];
    dispersion = dispersion_of(rings, part);
    fit.cutoff = cutoff_of(rings, scan, std::max(1.0, dispersion.value));
  }
  const double widening = std::max(1.0, dispersion.value);
  fit.dispersion = dispersion.value;
  fit.wavevector_low = rings.front().wavevector;
  fit.wavevector_high = rings[part.count - 1].wavevector;

  const WhittlePart straight = without_roll_off(rings, part);
  const bool has_roll_off =
      straight.value > part.value + likelihood_drop * widening;
  const WhittlePart& chosen = has_roll_off ? part : straight;
  const Covariance covariance =
      covariance_of(rings, chosen, has_roll_off, widening);
  fit.exponent = -2.0 - 2.0 * chosen.parameters[hurst_at];
  fit.hurst = hurst_of(chosen, covariance);
  if (has_roll_off)
    fit.roll_off = roll_off_of(chosen, covariance);
  else
    fit.roll_off = {not_a_number, not_a_number, fit.wavevector_low,
                    "no roll-off within the reliable range"};
  fit.blur = blur_of(chosen, covariance);
  fit.blur_square = chosen.parameters[blur_at];
  fit.rms_height = rms_height_of(chosen, covariance, fit.wavevector_low,
                                 fit.wavevector_high);
  fit.plateau = std::exp(log_signal(chosen.parameters, fit.wavevector_low));
  fit.noise = std::exp(chosen.parameters[noise_at]);
  fit.is_model = dispersion.value <= dispersion.limit;
  if (!fit.is_model)
    withdraw_intervals(fit);
  return fit;
}

} // namespace asperity::surfaces
