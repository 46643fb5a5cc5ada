#include "surfaces/analysis/reliable_range.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::surfaces {
namespace {

constexpr double steepest_floor = -1.0; // exponent of a flat end
constexpr double least_contrast = 10.0;
constexpr double shown_per_decade = 20.0;

/// Exponent of the power law through the rings, by weighted least squares.
double exponent_of(std::span<const SpectrumRing> rings) {
  double weight = 0.0;
  double mean_q = 0.0;
  double mean_density = 0.0;
  for (const SpectrumRing& ring : rings) {
    weight += ring.degrees_of_freedom;
    mean_q += ring.degrees_of_freedom * std::log(ring.wavevector);
    mean_density += ring.degrees_of_freedom * std::log(ring.density);
  }
  mean_q /= weight;
  mean_density /= weight;
  double covariance = 0.0;
  double variance = 0.0;
  for (const SpectrumRing& ring : rings) {
    const double offset = std::log(ring.wavevector) - mean_q;
    covariance += ring.degrees_of_freedom * offset *
                  (std::log(ring.density) - mean_density);
    variance += ring.degrees_of_freedom * offset * offset;
  }
  return covariance / variance;
}

double mean_density(std::span<const SpectrumRing> rings) {
  double weight = 0.0;
  double sum = 0.0;
  for (const SpectrumRing& ring : rings) {
    weight += ring.degrees_of_freedom;
    sum += ring.degrees_of_freedom * ring.density;
  }
  return sum / weight;
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
  const auto octave =
      std::find_if(rings.begin(), rings.end(), [&](const SpectrumRing& ring) {
        return ring.wavevector >= 0.5 * end;
      });
  const std::span<const SpectrumRing> last(octave, rings.end());
  if (last.size() < 3 || last.size() == rings.size() ||
      exponent_of(last) < steepest_floor)
    return std::nullopt;
  const double floor = mean_density(last);
  const std::vector<SpectrumRing> shown = joined_rings(rings, shown_per_decade);
  const auto highest =
      std::max_element(shown.begin(), shown.end(),
                       [](const SpectrumRing& a, const SpectrumRing& b) {
                         return a.density < b.density;
                       });
  if (highest->density < least_contrast * floor)
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

} // namespace asperity::surfaces
