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
