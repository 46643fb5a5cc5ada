#include "surfaces/analysis/reliable_range.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::surfaces {
namespace {

constexpr double flattest_exponent = -2.0; // of a self-affine surface, H = 0
constexpr double steepest_exponent = -4.5; // above the floor; H = 1 has -4
constexpr double exponent_step = 0.25;
constexpr double window_ratio = 4.0; // two octaves
constexpr std::size_t fewest_in_window = 8;
constexpr double least_gain = 12.0; // of the deviance: 3.5 standard deviations
constexpr double least_contrast = 10.0;
constexpr double shown_per_decade = 20.0;
constexpr double least_correlation = 0.7; // of two scans of one place

/// C = signal (q/q_end)^exponent + noise of some rings, q_end the last.
struct LawOfRings {
  double signal = 0.0;   ///< [m^4] >= 0
  double noise = 0.0;    ///< [m^4] >= 0
  double deviance = 0.0; ///< sum of nu (C_ring/C - 1 - ln(C_ring/C))
};

/// Adds the deviance.
LawOfRings judged(std::span<const SpectrumRing> rings, double exponent,
                  LawOfRings law) {
  for (const SpectrumRing& ring : rings) {
    const double ratio =
        ring.density /
        (law.signal *
             std::pow(ring.wavevector / rings.back().wavevector, exponent) +
         law.noise);
    law.deviance += ring.degrees_of_freedom * (ratio - 1.0 - std::log(ratio));
  }
  return law;
}

/// The most likely power law of this exponent, without noise.
LawOfRings pure_law(std::span<const SpectrumRing> rings, double exponent) {
  double sum = 0.0;
  double weight = 0.0;
  for (const SpectrumRing& ring : rings) {
    weight += ring.degrees_of_freedom;
    sum += ring.degrees_of_freedom * ring.density *
           std::pow(ring.wavevector / rings.back().wavevector, -exponent);
  }
  return judged(rings, exponent, {sum / weight, 0.0});
}

/// The same with noise, by least squares that are weighted anew by the model.
LawOfRings noisy_law(std::span<const SpectrumRing> rings, double exponent) {
  constexpr int rounds = 5;
  const double unit = rings.back().density; // keeps squares in range
  LawOfRings law;
  for (int round = 0; round < rounds; ++round) {
    double ss = 0.0, sn = 0.0, nn = 0.0, sc = 0.0, nc = 0.0;
    for (const SpectrumRing& ring : rings) {
      const double shape =
          std::pow(ring.wavevector / rings.back().wavevector, exponent);
      const double model =
          round == 0 ? ring.density / unit : law.signal * shape + law.noise;
      const double weight = ring.degrees_of_freedom / (model * model);
      ss += weight * shape * shape;
      sn += weight * shape;
      nn += weight;
      sc += weight * shape * ring.density / unit;
      nc += weight * ring.density / unit;
    }
    const double determinant = ss * nn - sn * sn;
    law.signal = (sc * nn - nc * sn) / determinant;
    law.noise = (nc * ss - sc * sn) / determinant;
    if (!(law.noise > 0.0))
      law = {sc / ss, 0.0};
    else if (!(law.signal > 0.0))
      law = {0.0, nc / nn};
  }
  return judged(rings, exponent, {law.signal * unit, law.noise * unit});
}

template <class Law>
LawOfRings likeliest(std::span<const SpectrumRing> rings, double steepest,
                     const Law& law_of) {
  LawOfRings best = law_of(rings, flattest_exponent);
  for (double exponent = flattest_exponent - exponent_step;
       exponent >= steepest; exponent -= exponent_step) {
    const LawOfRings law = law_of(rings, exponent);
    if (law.deviance < best.deviance)
      best = law;
  }
  return best;
}

/// The floor at the end of these rings [m^4]; 0 if a self-affine spectrum, even
/// with H = 0, is as likely, or if C >= 2 N up to their end.
double floor_of(std::span<const SpectrumRing> rings) {
  const LawOfRings noisy = likeliest(rings, steepest_exponent, noisy_law);
  const LawOfRings pure = likeliest(rings, 2.0 * steepest_exponent, pure_law);
  const double dispersion =
      std::max(1.0, noisy.deviance / static_cast<double>(rings.size()));
  const bool is_likelier =
      pure.deviance - noisy.deviance >= least_gain * dispersion;
  return is_likelier && noisy.noise > noisy.signal ? noisy.noise : 0.0;
}

double correlation(const HeightMap& a, const HeightMap& b) {
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.heights.size(); ++i) {
    ab += a.heights[i] * b.heights[i];
    aa += a.heights[i] * a.heights[i];
    bb += b.heights[i] * b.heights[i];
  }
  return ab / std::sqrt(aa * bb);
}

void limit(ReliableRange& range, double wavevector, const char* reason) {
  if (wavevector >= range.high)
    return;
  range.high = std::max(wavevector, range.low);
  range.high_reason = reason;
}

} // namespace

std::optional<NoiseFloor> noise_floor(const std::vector<SpectrumRing>& rings) {
  if (rings.empty())
    return std::nullopt;
  const double end = rings.back().wavevector;
  const std::vector<SpectrumRing> window =
      rings_between(rings, end / window_ratio, end);
  if (window.size() < fewest_in_window || window.size() == rings.size())
    return std::nullopt;
  const double floor = floor_of(window);
  const std::vector<SpectrumRing> shown = joined_rings(rings, shown_per_decade);
  const double highest =
      std::ranges::max(shown, {}, &SpectrumRing::density).density;
  if (floor == 0.0 || highest < least_contrast * floor)
    return std::nullopt;
  const auto above =
      std::find_if(shown.rbegin(), shown.rend(), [&](const SpectrumRing& ring) {
        return ring.density >= 2.0 * floor;
      });
  return NoiseFloor{floor, above->wavevector};
}

std::optional<double> tip_length(std::span<const LocalDifferences> scales,
                                 double tip_radius) {
  require_positive("tip_radius", tip_radius, "m");
  const double limit = 0.5 / tip_radius;
  for (std::size_t i = scales.size(); i-- > 0;) {
    const double here = -scales[i].lowest_second;
    if (!(here > limit))
      continue;
    if (i + 1 == scales.size() || !(scales[i + 1].lowest_second < 0.0))
      return 2.0 * scales[i].distance();
    const double above = -scales[i + 1].lowest_second;
    const double share = std::log(here / limit) / std::log(here / above);
    return 2.0 * scales[i].distance() *
           std::pow(scales[i + 1].distance() / scales[i].distance(), share);
  }
  return std::nullopt;
}

ReliableRange reliable_range(const SpectrumEstimate& spectrum,
                             std::span<const LocalDifferences> scales,
                             std::optional<double> tip_radius) {
  ReliableRange range;
  range.low = spectrum.wavevector_low;
  range.low_reason = "size of the scan";
  range.high = std::max(spectrum.wavevector_high, range.low);
  range.high_reason = "sampling";
  range.noise = noise_floor(rings_between(
      spectrum.rings, spectrum.wavevector_low, spectrum.wavevector_high));
  if (range.noise)
    limit(range, range.noise->wavevector, "noise floor");
  if (tip_radius) {
    if (const std::optional<double> length = tip_length(scales, *tip_radius)) {
      range.tip_wavevector = 2.0 * std::numbers::pi / *length;
      limit(range, *range.tip_wavevector, "radius of the tip");
    }
  }
  return range;
}

void limit_by_repeat(ReliableRange& range, const HeightMap& scan,
                     const HeightMap& repeat, bool is_periodic) {
  if (scan.grid != repeat.grid || scan.heights == repeat.heights ||
      correlation(scan, repeat) < least_correlation)
    return;
  HeightMap difference = scan;
  for (std::size_t i = 0; i < difference.heights.size(); ++i)
    difference.heights[i] -= repeat.heights[i];
  const auto shown = [&](const HeightMap& map) {
    return joined_rings(rings_between(estimate_spectrum(map, is_periodic).rings,
                                      range.low, range.high),
                        shown_per_decade);
  };
  const std::vector<SpectrumRing> noise = shown(difference);
  if (noise.empty())
    return;
  NoiseFloor found;
  for (const SpectrumRing& ring : shown(scan)) {
    const auto beside =
        std::ranges::min(noise, {}, [&](const SpectrumRing& other) {
          return std::abs(std::log(other.wavevector / ring.wavevector));
        });
    if (ring.density >= beside.density)
      found = {0.5 * beside.density, ring.wavevector};
    else if (found.wavevector == 0.0)
      found.wavevector = range.low;
  }
  if (found.wavevector < noise.back().wavevector) {
    limit(range, found.wavevector, "noise between scans");
    range.noise = found;
  }
}

} // namespace asperity::surfaces
