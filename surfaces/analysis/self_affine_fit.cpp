#include "surfaces/analysis/self_affine_fit.hpp"

#include "base/special_numbers.hpp"
#include "surfaces/analysis/whittle_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr double two_sided = 1.959963984540054; // 95 % of a normal distribution
constexpr double likelihood_drop = 0.5 * two_sided * two_sided;
constexpr std::size_t fewest_rings = 10;
constexpr double least_ratio = 3.0;
constexpr double widest_hurst = 0.5; // half width of a useful interval of H
constexpr double one_ring = 1.03;    // a little more than the width of a ring

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
  std::array<double, 4> gradient{};
  for (std::size_t k = 0; k < 4; ++k) {
    constexpr double step = 1e-5;
    WhittleParameters changed = part.parameters;
    changed.at(k) += step;
    gradient.at(k) = (log_mean_square(changed, low, high) - middle) / step;
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      variance += gradient.at(i) * covariance.at(i).at(k) * gradient.at(k);
  const double half = 0.5 * two_sided * std::sqrt(variance);
  const double height = std::exp(0.5 * middle);
  return {height, height * std::exp(-half), height * std::exp(half), ""};
}

} // namespace

double SelfAffineFit::density(double wavevector) const {
  const double corner =
      std::isnan(roll_off.value) ? wavevector_low : roll_off.value;
  return plateau * std::pow(std::max(wavevector, corner) / corner, exponent) +
         noise;
}

std::optional<SelfAffineFit>
fit_self_affine(const std::vector<SpectrumRing>& rings, double wavevector_end) {
  if (rings.size() < fewest_rings ||
      rings.back().wavevector < least_ratio * rings.front().wavevector)
    return std::nullopt;
  SelfAffineFit fit;
  WhittlePart part;
  if (rings.back().wavevector * one_ring < wavevector_end) {
    part = fit_part(rings, rings.size() - 1, std::nullopt);
    fit.dispersion = dispersion_of(rings, part);
    fit.cutoff = end_of(rings);
  } else {
    const CutoffScan scan = scan_cutoffs(rings);
    const bool has_cutoff = scan.best > 0 && scan.best + 1 < scan.parts.size();
    part = scan.parts[has_cutoff ? scan.best - 1 : scan.best];
    fit.dispersion = dispersion_of(rings, part);
    fit.cutoff = cutoff_of(rings, scan, std::max(1.0, fit.dispersion));
  }
  const double widening = std::max(1.0, fit.dispersion);
  fit.wavevector_low = rings.front().wavevector;
  fit.wavevector_high = rings[part.count - 1].wavevector;

  const WhittlePart straight = without_roll_off(rings, part);
  const bool has_roll_off =
      straight.value > part.value + likelihood_drop * widening;
  const WhittlePart& chosen = has_roll_off ? part : straight;
  const Covariance covariance =
      covariance_of(rings, chosen, has_roll_off, widening);
  const double hurst = chosen.parameters[1];
  const double half = two_sided * std::sqrt(covariance[1][1]);
  fit.exponent = -2.0 - 2.0 * hurst;
  fit.hurst = {hurst, hurst - half, hurst + half, ""};
  if (half > widest_hurst || std::abs(hurst - 0.5) > widest_hurst + 0.5)
    fit.hurst = {not_a_number, not_a_number, not_a_number,
                 "the self-affine part of the spectrum is too short"};
  const double corner = std::exp(chosen.parameters[2]);
  if (has_roll_off) {
    const double factor = std::exp(two_sided * std::sqrt(covariance[2][2]));
    fit.roll_off = {corner, corner / factor, corner * factor, ""};
  } else {
    fit.roll_off = {not_a_number, not_a_number, fit.wavevector_low,
                    "no roll-off within the reliable range"};
  }
  fit.rms_height = rms_height_of(chosen, covariance, fit.wavevector_low,
                                 fit.wavevector_high);
  fit.plateau = std::exp(log_signal(chosen.parameters, fit.wavevector_low));
  fit.noise = std::exp(chosen.parameters[3]);
  return fit;
}

} // namespace asperity::surfaces
