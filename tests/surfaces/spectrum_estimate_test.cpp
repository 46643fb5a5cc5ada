// Tests of surfaces/analysis/spectrum_estimate.hpp and reliable_range.hpp.
#include "surfaces/analysis/reliable_range.hpp"
#include "surfaces/analysis/spectrum_estimate.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/realization.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace asperity::surfaces::spectrum_estimate_test {

constexpr double pi = std::numbers::pi;
constexpr double unit = 2.0 * pi; // of a side of 1 m

SelfAffineSpectrum rough(double roll_off, double cutoff) {
  return SelfAffineSpectrum::with_rms_height(
      {0.8, 0.5 * unit, roll_off * unit, cutoff * unit}, 1e-3);
}

/// A corner of a surface of twice the side, which does not continue across its
/// edges.
HeightMap corner(const SelfAffineSpectrum& spectrum, int points,
                 int realization) {
  const HeightMap whole =
      realize(spectrum.isotropic(), {2 * points, 2 * points, 2.0, 2.0},
              {11, realization}, mechanics::Amplitudes::gaussian);
  HeightMap map{{points, points, 1.0, 1.0}, {}};
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      map.heights.push_back(whole.heights[whole.grid.index(ix, iy)]);
  remove_mean(map);
  return map;
}

HeightMap white_noise(int points, int realization, double rms_height) {
  HeightMap map{{points, points, 1.0, 1.0}, {}};
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      map.heights.push_back(rms_height * std::sqrt(12.0) *
                            (draw_mode({3, realization}, ix, iy).first - 0.5));
  return map;
}

double sum_of(const std::vector<SpectrumRing>& rings) {
  double sum = 0.0;
  for (const SpectrumRing& ring : rings)
    sum += ring.mean_square_height;
  return sum;
}

// cos(qx): the entire power is in one ring of the right wavevector, with C =
// <h^2> L^2/((2 pi)^2 modes) and the four modes of that |q|.
TEST(SpectrumEstimate, OfAWaveIsOneRing) {
  const HeightMap map = wave_1d({32, 32, 1.0, 1.0}, 1e-3, 0.25);

  const SpectrumEstimate found = estimate_spectrum(map, true);

  ASSERT_EQ(found.rings.size(), 1U);
  EXPECT_NEAR(found.rings[0].wavevector, 4 * unit, 1e-10);
  EXPECT_NEAR(found.rings[0].mean_square_height, 0.5e-6, 1e-20);
  EXPECT_NEAR(found.rings[0].density, 0.5e-6 / (4.0 * pi * pi * 4.0), 1e-21);
  EXPECT_EQ(found.rings[0].degrees_of_freedom, 4.0);
  EXPECT_NEAR(nayak_parameter(found), 1.5, 1e-10);
}

// Parseval's theorem to roundoff: the rings sum to <h^2> of the periodic map,
// or of the windowed map over the mean square of the window.
TEST(SpectrumEstimate, SumsToTheVariance) {
  const HeightMap map = corner(rough(4, 28), 60, 0);

  const SpectrumEstimate periodic = estimate_spectrum(map, true);
  const SpectrumEstimate windowed = estimate_spectrum(map, false);

  const double variance = std::pow(statistics(map).rms_height, 2);
  EXPECT_NEAR(sum_of(periodic.rings) / variance, 1.0, 1e-12);
  const HeightMap shown = with_edges(map, mechanics::Edges::window);
  EXPECT_NEAR(sum_of(windowed.rings) * hann_power(map.grid) /
                  std::pow(statistics(shown).rms_height, 2),
              1.0, 1e-12);
  EXPECT_NEAR(windowed.rms_height / std::sqrt(sum_of(windowed.rings)), 1.0,
              1e-12);
  EXPECT_NEAR(sum_of(joined_rings(windowed.rings, 10)) / sum_of(windowed.rings),
              1.0, 1e-12);
}

// The windowed estimate is unbiased, and its 95 % intervals contain the exact
// value: 40 corners, rings of ten per decade between twice the lowest
// wavevector and the cut-off. Tolerance: the interval of the mean of 40 is
// 1/sqrt(40) as wide; 3 standard deviations. The coverage of about 400 nearly
// independent intervals has a standard deviation of 1.1 %.
TEST(SpectrumEstimate, OfACornerIsUnbiasedAndItsIntervalsHold) {
  const SelfAffineSpectrum exact = rough(4, 31);
  int inside = 0;
  int all = 0;
  double ratio = 0.0;
  double variance = 0.0;
  for (int r = 0; r < 40; ++r) {
    const SpectrumEstimate found =
        estimate_spectrum(corner(exact, 64, r), false);
    for (const SpectrumRing& ring :
         joined_rings(rings_between(found.rings, 4 * unit, 28 * unit), 10)) {
      const double expected = exact(ring.wavevector);
      const DensityInterval interval = confidence_of(ring);
      inside += interval.low <= expected && expected <= interval.high;
      ++all;
      ratio += ring.density / expected;
      variance += 2.0 / ring.degrees_of_freedom;
    }
  }
  EXPECT_NEAR(ratio / all, 1.0, 3.0 * std::sqrt(variance) / all + 0.01);
  EXPECT_GT(inside, 0.92 * all);
  EXPECT_LT(inside, 0.995 * all);
}

TEST(SpectrumEstimate, StatesWhereItCanBeTrusted) {
  const HeightMap map = white_noise(32, 0, 1e-3);

  EXPECT_NEAR(estimate_spectrum(map, true).wavevector_low, unit, 1e-12);
  EXPECT_NEAR(estimate_spectrum(map, false).wavevector_low, 2 * unit, 1e-12);
  EXPECT_NEAR(estimate_spectrum(map, false).wavevector_high, 32 * pi, 1e-11);
  EXPECT_THROW(
      estimate_spectrum({{8, 8, 1.0, 1.0}, std::vector<double>(64)}, true),
      std::domain_error);
}

// White noise of density N over a self-affine surface: the floor is found at
// its density, C = <h^2> h^2/(2 pi)^2, and the limit where C is 2 N.
TEST(ReliableRange, EndsAtTheNoiseFloor) {
  const SelfAffineSpectrum exact = rough(4, 60);
  HeightMap map = realize(exact.isotropic(), {128, 128, 1.0, 1.0}, {4, 0});
  const double floor = exact(20 * unit);
  const double rms = std::sqrt(floor * 4.0 * pi * pi * 128.0 * 128.0);
  const HeightMap noise = white_noise(128, 1, rms);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] += noise.heights[i];

  const SpectrumEstimate spectrum = estimate_spectrum(map, true);
  const ReliableRange found = reliable_range(spectrum, {}, {});

  ASSERT_TRUE(found.noise.has_value());
  EXPECT_NEAR(found.noise->density / floor, 1.0, 0.1);
  // The limit is a ring of 20 per decade below q = 20.
  EXPECT_NEAR(found.high / unit, 20.0, 2.5);
  EXPECT_EQ(found.high_reason, "noise floor");
}

/// How an instrument changes the waves of a map: a Gaussian filter whose
/// standard deviation is given in node spacings.
HeightMap filtered(const HeightMap& map, double deviation) {
  const int reach = static_cast<int>(std::ceil(5.0 * deviation));
  HeightMap result = map;
  for (const bool is_along_x : {true, false}) {
    const HeightMap from = result;
    for (int iy = 0; iy < map.grid.points_y; ++iy)
      for (int ix = 0; ix < map.grid.points_x; ++ix) {
        double sum = 0.0, weights = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int x = is_along_x ? ix + k : ix, y = is_along_x ? iy : iy + k;
          if (x < 0 || y < 0 || x >= map.grid.points_x ||
              y >= map.grid.points_y)
            continue;
          const double weight = std::exp(-0.5 * k * k / deviation / deviation);
          sum += weight * from.heights[map.grid.index(x, y)];
          weights += weight;
        }
        result.heights[map.grid.index(ix, iy)] = sum / weights;
      }
  }
  return result;
}

/// A measured map of 256 x 256 points and what is known of its floor.
struct NoisyMap {
  HeightMap map;
  double density = 0.0;  ///< of the white noise [m^4]
  double crossing = 0.0; ///< where the surface has this density, too [rad/m]
};

/// Surface and noise cross at a wavelength of so many spacings.
NoisyMap noisy_corner(double wavelength, double surface_filter = 0.0) {
  const SelfAffineSpectrum exact = rough(8, 127);
  const double crossing = 256.0 / wavelength * unit;
  NoisyMap result{corner(exact, 256, 1), exact(crossing), crossing};
  if (surface_filter > 0.0)
    result.map = filtered(result.map, surface_filter);
  const HeightMap noise =
      white_noise(256, 5, std::sqrt(result.density) * 2.0 * pi * 256.0);
  for (std::size_t i = 0; i < noise.heights.size(); ++i)
    result.map.heights[i] += noise.heights[i];
  return result;
}

ReliableRange range_of(const HeightMap& map) {
  return reliable_range(estimate_spectrum(map, false), {}, {});
}

// Also a floor of half an octave is found, which leaves a share of 30 % of the
// mean square slope to the noise. The limit is a ring of 20 per decade.
TEST(ReliableRange, FindsAFloorThatIsShort) {
  for (const double wavelength : {2.5, 3.0, 4.0, 8.0, 16.0}) {
    const NoisyMap noisy = noisy_corner(wavelength);

    const ReliableRange found = range_of(noisy.map);

    ASSERT_TRUE(found.noise.has_value()) << wavelength;
    EXPECT_NEAR(found.noise->density / noisy.density, 1.0, 0.12) << wavelength;
    EXPECT_NEAR(found.high / noisy.crossing, 1.0, 0.2) << wavelength;
    EXPECT_EQ(found.high_reason, "noise floor");
  }
}

// A tilt that levelling has left leaks into the long waves only.
TEST(ReliableRange, FindsTheFloorOfATiltedMap) {
  NoisyMap noisy = noisy_corner(3.0);
  for (int iy = 0; iy < 256; ++iy)
    for (int ix = 0; ix < 256; ++ix)
      noisy.map.heights[noisy.map.grid.index(ix, iy)] += 1e-5 * (ix - 2 * iy);

  const ReliableRange found = range_of(noisy.map);

  ASSERT_TRUE(found.noise.has_value());
  EXPECT_NEAR(found.noise->density / noisy.density, 1.0, 0.12);
}

// An instrument that rounds the surface before its noise is added: the spectrum
// falls steeply to the floor, and the surface ends below the crossing.
TEST(ReliableRange, FindsTheFloorOfARoundedSurface) {
  const NoisyMap rounded = noisy_corner(4.0, 2.0);

  const ReliableRange found = range_of(rounded.map);

  ASSERT_TRUE(found.noise.has_value());
  EXPECT_NEAR(found.noise->density / rounded.density, 1.0, 0.05);
  EXPECT_LT(found.high, 0.6 * rounded.crossing);
  EXPECT_GT(found.high, 0.3 * rounded.crossing);
}

// No floor is found in a surface without noise, however its spectrum ends: with
// any Hurst exponent, rounded by an instrument, or cut off, also if it scatters
// as the spectrum of a small map does.
TEST(ReliableRange, FindsNoFloorWithoutNoise) {
  for (int realization = 0; realization < 10; ++realization) {
    for (const double hurst : {0.1, 0.5, 1.0}) {
      const SelfAffineSpectrum exact = SelfAffineSpectrum::with_rms_height(
          {hurst, 0.5 * unit, 4 * unit, 63.9 * unit}, 1e-3);
      const HeightMap map = corner(exact, 128, realization);
      EXPECT_FALSE(range_of(map).noise.has_value()) << hurst;
      EXPECT_FALSE(range_of(filtered(map, 0.5)).noise.has_value()) << hurst;
    }
    EXPECT_FALSE(range_of(corner(rough(4, 30), 128, realization)).noise);
  }
  const SelfAffineSpectrum flat = SelfAffineSpectrum::with_rms_height(
      {0.1, 0.5 * unit, 2 * unit, 15.9 * unit}, 1e-3);
  for (int realization = 0; realization < 200; ++realization)
    EXPECT_FALSE(range_of(corner(flat, 32, realization)).noise);
}

// Two scans of one place tell their noise also where its spectrum is not flat;
// scans of two places, and a copy of the file, tell nothing.
TEST(ReliableRange, EndsAtTheNoiseBetweenTwoScans) {
  const SelfAffineSpectrum exact = rough(8, 127);
  const HeightMap place = corner(exact, 256, 1);
  const auto scan = [&](const HeightMap& surface, int realization) {
    HeightMap map = surface;
    const HeightMap noise =
        filtered(white_noise(256, realization,
                             std::sqrt(exact(32 * unit)) * 2.0 * pi * 256.0),
                 0.6);
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      map.heights[i] += noise.heights[i];
    remove_mean(map);
    return map;
  };
  const HeightMap first = scan(place, 5);
  ReliableRange range = range_of(first);
  ASSERT_FALSE(range.noise.has_value()); // its filter hides it
  limit_by_repeat(range, first, first, false);
  limit_by_repeat(range, first, scan(corner(exact, 256, 2), 6), false);
  EXPECT_EQ(range.high_reason, "sampling");

  limit_by_repeat(range, first, scan(place, 6), false);

  EXPECT_EQ(range.high_reason, "noise between scans");
  EXPECT_NEAR(range.high / (32 * unit), 1.0, 0.3);
}

// Neither a self-affine spectrum up to the end nor pure white noise has a
// floor.
TEST(ReliableRange, OfACleanSurfaceEndsAtTheSampling) {
  const HeightMap map =
      realize(rough(4, 63).isotropic(), {128, 128, 1.0, 1.0}, {4, 0});

  const SpectrumEstimate spectrum = estimate_spectrum(map, true);
  const ReliableRange found = reliable_range(spectrum, {}, {});

  EXPECT_FALSE(found.noise.has_value());
  EXPECT_EQ(found.high, 128 * pi);
  EXPECT_EQ(found.high_reason, "sampling");
  EXPECT_EQ(found.low_reason, "size of the scan");
  EXPECT_FALSE(
      noise_floor(estimate_spectrum(white_noise(64, 2, 1e-3), true).rings)
          .has_value());
}

// For peaks of curvature k, a tip of radius R distorts them if k > 1/(2 R).
// Between two distances the curvature is interpolated as a power law: 8 at 1
// and 2 at 2 reach 4 at sqrt2.
TEST(ReliableRange, EndsWhereTheTipIsTooBlunt) {
  std::vector<LocalDifferences> scales(3);
  const double curvatures[] = {8.0, 2.0, 0.5};
  for (std::size_t i = 0; i < 3; ++i) {
    scales[i].distance_x = scales[i].distance_y = std::pow(2.0, i);
    scales[i].lowest_second = -curvatures[i];
  }

  EXPECT_NEAR(tip_length(scales, 0.5 / 4.0).value(), 2.0 * std::sqrt(2.0),
              1e-12);
  EXPECT_FALSE(tip_length(scales, 0.5 / 9.0).has_value());
  EXPECT_EQ(tip_length(scales, 0.5 / 0.1).value(), 8.0); // all of it
  EXPECT_THROW(tip_length(scales, 0.0), std::domain_error);
}

} // namespace asperity::surfaces::spectrum_estimate_test
