#include "surfaces/analysis/spectrum_estimate.hpp"

#include "base/require.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

namespace asperity::surfaces {
namespace {

/// Sum of the correlations of |a_q|^2 between a mode and all modes, for white
/// noise times the 2-D Hann window. The squares of the Fourier coefficients of
/// sin^4, over that of its mean, are 4/9 and 1/36 for the two neighbours.
constexpr double along_one_side = 1.0 + 2.0 * (4.0 / 9.0 + 1.0 / 36.0);
constexpr double hann_correlation = along_one_side * along_one_side;

} // namespace

SpectrumEstimate estimate_spectrum(const HeightMap& map, bool is_periodic) {
  const mechanics::Edges edges =
      is_periodic ? mechanics::Edges::periodic : mechanics::Edges::window;
  const HeightMap shown = with_edges(map, edges);
  const double window = is_periodic ? 1.0 : hann_power(map.grid);
  const double dependent = is_periodic ? 1.0 : hann_correlation;
  const Statistics numbers = statistics(shown);
  if (!(numbers.rms_height > 0.0))
    refuse_argument("rms height", numbers.rms_height, "> 0 [m]");

  SpectrumEstimate estimate;
  estimate.is_windowed = !is_periodic;
  estimate.rms_height = numbers.rms_height / std::sqrt(window);
  estimate.rms_slope = numbers.rms_slope / std::sqrt(window);
  estimate.rms_curvature = numbers.rms_curvature / std::sqrt(window);
  const Grid& grid = map.grid;
  estimate.wavevector_low =
      wavevector(is_periodic ? 1 : 2, std::min(grid.length_x, grid.length_y));
  estimate.wavevector_high =
      std::numbers::pi / std::max(grid.spacing_x(), grid.spacing_y());
  for (const Shell& shell : spectral_shells(shown))
    estimate.rings.push_back(
        {shell.wavevector, shell_density(shell, grid) / window,
         shell.modes / dependent, shell.mean_square_height / window});
  return estimate;
}

std::vector<SpectrumRing> joined_rings(const std::vector<SpectrumRing>& rings,
                                       double per_decade) {
  require_positive("per_decade", per_decade, "1");

  struct Sums {
    double weight = 0.0;
    double density = 0.0;
    double power = 0.0;
    double square = 0.0;
  };

  std::map<long, Sums> steps;
  for (const SpectrumRing& ring : rings) {
    Sums& sums = steps[std::lround(std::log10(ring.wavevector) * per_decade)];
    sums.weight += ring.degrees_of_freedom;
    sums.density += ring.degrees_of_freedom * ring.density;
    sums.power += ring.mean_square_height;
    sums.square += ring.wavevector * ring.wavevector * ring.mean_square_height;
  }
  std::vector<SpectrumRing> joined;
  joined.reserve(steps.size());
  for (const auto& [step, sums] : steps)
    joined.push_back({std::sqrt(sums.square / sums.power),
                      sums.density / sums.weight, sums.weight, sums.power});
  return joined;
}

std::vector<SpectrumRing> rings_between(const std::vector<SpectrumRing>& rings,
                                        double low, double high) {
  std::vector<SpectrumRing> between;
  std::copy_if(rings.begin(), rings.end(), std::back_inserter(between),
               [&](const SpectrumRing& ring) {
                 return ring.wavevector >= low * (1.0 - 1e-9) &&
                        ring.wavevector <= high * (1.0 + 1e-9);
               });
  return between;
}

DensityInterval confidence_of(const SpectrumRing& ring) {
  const double nu = ring.degrees_of_freedom;
  const boost::math::chi_squared distribution(nu);
  return {nu * ring.density / quantile(distribution, 0.975),
          nu * ring.density / quantile(distribution, 0.025)};
}

double nayak_parameter(const SpectrumEstimate& spectrum) {
  const double height = spectrum.rms_height * spectrum.rms_height;
  const double slope = 0.5 * spectrum.rms_slope * spectrum.rms_slope;
  const double curvature =
      1.5 * spectrum.rms_curvature * spectrum.rms_curvature;
  return height * curvature / (slope * slope);
}

} // namespace asperity::surfaces
